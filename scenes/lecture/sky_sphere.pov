// sky_sphere: a pigment looked up by the direction of a ray that hits nothing, as a point of the unit sphere; layers add up by their
// transparency; reflections see it too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -6> look_at <0, 1.6, 0> angle 65 }
light_source { <-6, 7, -6> rgb 1 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.5>] [0.3 rgb <0.45, 0.6, 0.85>] [1 rgb <0.1, 0.2, 0.5>] } }
  pigment { gradient x color_map { [0 rgbt 1] [0.8 rgbt 1] [1 rgbt <1, 1, 1, 0.4>] } scale 0.23 rotate z * 20 }
}
plane { y, 0 pigment { rgb <0.35, 0.4, 0.3> } }
sphere { <-1.3, 1.1, 0>, 1.1 pigment { rgb 0.05 } finish { reflection 0.9 diffuse 0.1 } }
sphere { <1.5, 0.9, -0.3>, 0.9 pigment { rgbf <0.95, 1, 1, 0.95> } finish { reflection 0.1 diffuse 0.05 } interior { ior 1.4 } }
