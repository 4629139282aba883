// isosurface of a pattern and of a pigment.
// lute scenes/feature/shape/isosurface_pigment.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Waves = function { pattern { leopard scale 0.15 } }
#declare Grey = function { pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } scale 0.3 } }
isosurface { function { y + 0.3 * Waves(x, y, z) } max_gradient 4 contained_by { box { -0.9, 0.9 } } rotate 30 * y translate -1.1 * x }
isosurface { function { x * x + y * y + z * z - 0.4 - 0.4 * Grey(x, y, z).gray } max_gradient 5 contained_by { sphere { 0, 1 } } translate 1.1 * x }
