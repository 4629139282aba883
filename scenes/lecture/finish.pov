// The terms of a finish: ambient, emission, diffuse with brilliance, phong with phong_size, specular with roughness, metallic
// highlights, albedo, crossed on a grid. I = ambient + emission + sum over lights (kd (n·L)^b + ks (n·H)^(1/roughness) + kp (R·L)^size).
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 1 }
background { rgb <0.12, 0.13, 0.17> }
camera { location <0, 0, -12> look_at 0 angle 42 }
light_source { <-8, 10, -14> rgb 0.9 }
light_source { <9, 2, -10> rgb <0.2, 0.25, 0.35> }
#macro Ball(X, Y, F)
  sphere { <X, Y, 0>, 0.9 pigment { rgb <0.85, 0.45, 0.3> } finish { F } }
#end
Ball(-3, 2, finish { ambient 0.4 diffuse 0 })
Ball(-1, 2, finish { ambient 0 emission <0.1, 0.2, 0.3> diffuse 0.5 })
Ball(1, 2, finish { ambient 0.05 diffuse 0.9 brilliance 4 })
Ball(3, 2, finish { ambient 0.05 diffuse 0.9 brilliance 0.4 })
Ball(-3, 0, finish { ambient 0.05 diffuse 0.6 phong 0.9 phong_size 10 })
Ball(-1, 0, finish { ambient 0.05 diffuse 0.6 phong 0.9 phong_size 120 })
Ball(1, 0, finish { ambient 0.05 diffuse 0.6 specular 0.9 roughness 0.1 })
Ball(3, 0, finish { ambient 0.05 diffuse 0.6 specular 0.9 roughness 0.005 })
Ball(-3, -2, finish { ambient 0.05 diffuse 0.4 specular 0.9 roughness 0.05 metallic })
Ball(-1, -2, finish { ambient 0.05 diffuse 0.4 phong 0.9 phong_size 40 metallic 0.5 })
Ball(1, -2, finish { ambient 0.05 diffuse albedo 0.7 specular albedo 0.3 roughness 0.03 })
Ball(3, -2, finish { ambient rgb <0.3, 0, 0.2> diffuse 0.6, 0.3 conserve_energy reflection 0.3 })
