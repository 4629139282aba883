#version 3.7;
// The camera, kinds of light and what a finish and an interior can be told. The last camera counts.
global_settings {
  assumed_gamma 1.0 ambient_light rgb <1, 0.5, 0.25> adc_bailout 0.01 max_trace_level 12
  irid_wavelength rgb <0.7, 0.5, 0.4> number_of_waves 4 noise_generator 3 charset utf8 mm_per_unit 20
}
camera { fisheye angle 180 location x }
camera {
  perspective location <1, 2, -3> right 1.5*x up y direction 2*z sky <0, 1, 0.1> look_at <0, 0.5, 0>
  aperture 0.25 blur_samples 4, 20 focal_point <0, 0, 1> confidence 0.95 variance 0.001
  bokeh { pigment { rgb 1 } } normal { bumps 0.1 } translate y
}
light_source { <0, 10, 0> rgb 1 }
light_source { x rgb 0.5 spotlight radius 10 falloff 25 tightness 5 point_at <0, -1, 0> }
light_source { y rgb 1 cylinder radius 1 falloff 2 point_at 0 parallel }
light_source { z rgb 1 shadowless fade_distance 3 fade_power 2 media_interaction off media_attenuation on }
light_source { 0 rgb 1 area_light 2*x, 2*z, 4, 3 adaptive 1 jitter circular orient area_illumination on }
light_source { 0 rgb 1 looks_like { sphere { 0, 0.1 } } projected_through { disc { y, y, 1 } } translate 3*y }
light_group { light_source { x rgb 1 } sphere { 0, 1 } global_lights on }
sphere { 0, 1
  texture {
    pigment { rgbft <1, 0.5, 0.25, 0.1, 0.2> quick_color rgb z }
    finish {
      ambient 0.1 emission 0.2 diffuse 0.5, 0.25 brilliance 2 phong 0.25 phong_size 20 specular albedo 0.5 roughness 0.01
      metallic 0.5 reflection { 0.1, 0.9 falloff 2 exponent 0.5 metallic 0.75 } conserve_energy
      irid { 0.25 thickness 0.5 turbulence 0.1 } crand 0.1 subsurface { translucency 0.5 }
    }
  }
  interior { ior 1.33 dispersion 1.02 dispersion_samples 10 caustics 0.5 fade_distance 2 fade_power 2 fade_color rgb <0, 1, 0>
    media { method 3 samples 4, 8 intervals 2 emission 0.1 absorption 0.2 scattering { 2, 0.3 extinction 0.5 } density { spherical } } }
  interior_texture { pigment { rgb x } }
  photons { target 0.5 refraction on reflection off collect off }
  hollow no_shadow no_image no_reflection double_illuminate
}
