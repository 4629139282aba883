// metallic: highlights have the colour of the pigment.
// lute scenes/feature/finish/metallic.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 1.5, -6> right 4 / 3 * x look_at 0 angle 38 }
light_source { <-4, 6, -8> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
#macro Ball(X, Finish) sphere { <X, 0, 0>, 0.6 pigment { rgb <1, 0.6, 0.3> } finish { Finish } } #end
#declare Plain = finish { ambient 0.1 diffuse 0.6 }

Ball(-1.4, finish { specular 0.8 metallic ambient 0.1 })
Ball(0, finish { phong 0.8 metallic 0.5 ambient 0.1 })
Ball(1.4, finish { specular 0.8 roughness 0.1 metallic 2 ambient 0.1 })
