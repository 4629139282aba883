// a difference with 200 holes.
// lute scenes/feature/csg/wide.pov -W160 -H120
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.3> }
camera { location <0, 2, -6> right 4 / 3 * x look_at 0 angle 36 }
light_source { <-4, 6, -8> rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.7 phong 0.3 } }

#declare Seed = seed(3);
difference {
  box { <-1.8, -1.2, -0.2>, <1.8, 1.2, 0.2> }
  #for (I, 1, 200)
    sphere { <3.6 * rand(Seed) - 1.8, 2.4 * rand(Seed) - 1.2, -0.2 + 0.1 * rand(Seed)>, 0.05 + 0.15 * rand(Seed) pigment { rgb <rand(Seed), 0.5, 0.8> } }
  #end
  rotate <20, 20, 0>
}
