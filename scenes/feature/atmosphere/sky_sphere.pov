// sky_sphere: patterns far away, in layers; emission.
// lute scenes/feature/atmosphere/sky_sphere.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> right 4 / 3 * x look_at <0, 1, 0> angle 50 }
light_source { <-4, 6, -8> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } hollow }
#for (I, 0, 4)
  sphere { <2 * I - 4, 0, 4 * I>, 1 pigment { rgb <1, 0.6, 0.3> } }
#end

sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.9, 1>] [1 rgb <0.2, 0.4, 0.9>] } }
  pigment { bozo turbulence 0.5 color_map { [0.4 rgbt 1] [0.8 rgbt <1, 1, 1, 0.2>] } scale 0.2 }
  rotate 10 * z
}
