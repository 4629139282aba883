// A net of triangles that meet at angles of a thousand-millionth: no ray finds a way through.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Bump) #declare Bump = 1e-9; #end
camera { orthographic location -3*z direction <0.3, 0.2, 1> right 0.4*x up 0.3*y }
#macro P(I, J) <I/20, J/20, Bump*sin(I*12.9 + J*78.2)> #end
mesh {
  #for (I, -30, 29) #for (J, -30, 29)
    triangle { P(I, J), P(I + 1, J), P(I, J + 1) } triangle { P(I + 1, J), P(I + 1, J + 1), P(I, J + 1) }
  #end #end
  translate <0.9, 0.6, 0>
  pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
