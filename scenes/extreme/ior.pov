// A clear slab over a striped wall, seen from a slant: the stripes move by d (tan a - tan b). Beyond the critical angle all light comes
// from the blue behind the camera.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 }
#ifndef (Ior) #declare Ior = 1; #end
#ifndef (Nudge) #declare Nudge = 0; #end
#ifndef (Slant) #declare Slant = 0.6; #end
camera { orthographic location <-2*Slant, 0, -2> direction <Slant, 0, 1> right 4*x up 3*y }
box { <-9, -9, 0>, <9, 9, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior Ior + Nudge*1e-9 } }
plane { -z, -2
  pigment { function { mod(floor(4*x) + 100, 2) } color_map { [0.5 rgb <0, 0.5, 0>] [0.5 rgb <1, 1, 0>] } }
  finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
