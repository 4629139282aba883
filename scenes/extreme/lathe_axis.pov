// Lathes whose curve begins and ends on the axis: a double cone, from beside, and from above along the axis.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Above) #declare Above = 0; #end
#ifndef (Spline) #declare Spline = 0; #end
camera { orthographic location -5*z direction z right 4*x up 3*y #if (Above) rotate 90*x #end }
lathe {
  #switch (Spline)
  #case (0) bezier_spline 8, <0, -1>, <1/3, -2/3>, <2/3, -1/3>, <1, 0>, <1, 0>, <2/3, 1/3>, <1/3, 2/3>, <0, 1> #break
  #case (1) linear_spline 3, <0, -1>, <1, 0>, <0, 1> #break
  #end
  pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
