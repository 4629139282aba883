// A disc of ten thousand needle triangles, around the point where all of them meet.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (View) #declare View = 1e-3; #end
camera { orthographic location -3*z direction z right 4*View*x up 3*View*y }
mesh {
  #for (I, 0, 9999)
    triangle { 0, 1000*<cos(I*pi/5000), sin(I*pi/5000), 0>, 1000*<cos((I + 1)*pi/5000), sin((I + 1)*pi/5000), 0> }
  #end
  pigment { rgb <1, 1, 0> } finish { ambient 1 diffuse 0 }
}
background { rgb <0, 0, 1> }
