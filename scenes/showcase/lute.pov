// A still life after Dürer's woodcut of a man drawing a lute: the lute, and around it what a first ray tracer learns to see.
// A checkered plane, a mirror, glass, a die cut out of a box, rings, a gem of triangles.
//
//   lute scenes/showcase/lute.pov --width 1200 --height 800 --antialias 0.2

#version 3.7;

global_settings { assumed_gamma 1.0 max_trace_level 8 }

camera {
  location <-0.6, 3.1, -10.5>
  right x*image_width/image_height
  up y
  angle 41
  look_at <0.25, 1.38, 0>
}

light_source { <-9, 13, -10> rgb <1.15, 1.1, 1.0> }
light_source { <12, 6, -9> rgb <0.22, 0.25, 0.32> shadowless }

sky_sphere {
  pigment {
    gradient y
    color_map { [0.00 rgb <0.80, 0.72, 0.60>] [0.25 rgb <0.42, 0.48, 0.60>] [1.00 rgb <0.10, 0.14, 0.26>] }
  }
}

fog { distance 60 rgb <0.80, 0.72, 0.60> }  // the floor fades into the horizon

// ---- Materials

#declare Spruce = texture {
  pigment {
    gradient x
    color_map { [0.0 rgb <0.78, 0.52, 0.25>] [0.8 rgb <0.70, 0.44, 0.20>] [1.0 rgb <0.56, 0.33, 0.14>] }
    scale 0.07
  }
  finish { ambient 0.08 diffuse 0.75 specular 0.25 roughness 0.02 }
}

#declare Ebony = texture {
  pigment { rgb <0.05, 0.035, 0.03> }
  finish { ambient 0.05 diffuse 0.8 specular 0.5 roughness 0.01 reflection 0.04 }
}

#declare Maple = texture {
  pigment {
    radial
    color_map {
      [0.00 rgb <0.52, 0.22, 0.07>] [0.46 rgb <0.50, 0.20, 0.06>] [0.50 rgb <0.13, 0.05, 0.02>] [0.54 rgb <0.44, 0.17, 0.05>]
    }
    frequency 24
  }
  finish { ambient 0.06 diffuse 0.7 phong 0.5 phong_size 60 reflection 0.06 }
}

#declare Gold = texture {
  pigment { rgb <0.95, 0.62, 0.20> }
  finish { ambient 0.06 diffuse 0.35 metallic 1 specular 0.7 roughness 0.02 reflection { 0.45 metallic 1 } }
}

#declare Ivory = texture {
  pigment { rgb <0.92, 0.88, 0.78> }
  finish { ambient 0.08 diffuse 0.75 phong 0.6 phong_size 80 reflection 0.03 }
}

// ---- The lute: soundboard in the plane z = 0, face toward -z, neck along y

#declare Body = union {
  intersection {
    sphere { 0, 1 scale <1, 1.32, 0.78> }
    plane { -z, 0 }
    texture { Maple rotate 90*x }
  }
  difference {
    cylinder { -0.05*z, 0, 1 scale <1, 1.32, 1> }
    cylinder { <0, 0.28, -1>, <0, 0.28, 1>, 0.30 }
    texture { Spruce }
  }
  torus { 1, 0.035 rotate 90*x scale <1, 1.32, 1> texture { Ebony } }
}

// The rosette: rings, and a star of thin bars.
#declare Rosette = union {
  torus { 0.30, 0.030 rotate 90*x }
  torus { 0.17, 0.018 rotate 90*x }
  #for (I, 0, 11)
    cylinder { <0.02, 0, 0>, <0.29, 0, 0>, 0.012 rotate 30*I*z }
  #end
  translate <0, 0.28, -0.035>
  texture { Gold }
}

#declare String_Count = 6;

#macro Peg(At, Side)
  union {
    cylinder { At, At + 0.34*Side*x, 0.035 }
    sphere { At + 0.40*Side*x, 0.085 }
    texture { Ivory }
  }
#end

#declare Neck = union {
  box { <-0.17, 1.22, -0.06>, <0.17, 2.55, 0.10> texture { Maple rotate 90*x } }
  box { <-0.17, 0.95, -0.09>, <0.17, 2.55, -0.05> texture { Ebony } }
  #for (Fret, 1, 7)
    cylinder { <-0.17, 2.55 - 0.19*Fret, -0.092>, <0.17, 2.55 - 0.19*Fret, -0.092>, 0.010 texture { Ivory } }
  #end
  // The peg box is bent back.
  union {
    difference {
      box { <-0.17, 0, -0.07>, <0.17, 0.95, 0.09> }
      box { <-0.10, 0.05, -0.08>, <0.10, 0.88, 0.05> }
      texture { Maple rotate 90*x }
    }
    #for (I, 0, 2)
      Peg(<-0.10, 0.22 + 0.24*I, 0>, -1)
      Peg(<0.10, 0.22 + 0.24*I, 0>, 1)
    #end
    rotate 68*x
    translate <0, 2.55, 0>
  }
}

#declare Strings = union {
  #for (I, 0, String_Count - 1)
    #local At = I/(String_Count - 1) - 0.5;
    cylinder { <0.42*At, -0.80, -0.12>, <0.24*At, 2.55, -0.105>, 0.009 }
  #end
  texture { Ivory }
}

#declare Bridge = box { <-0.36, -0.86, -0.13>, <0.36, -0.76, -0.04> texture { Ebony } }

#declare Lute = union {
  object { Body }
  object { Rosette }
  object { Neck }
  object { Strings }
  object { Bridge }
}

// ---- A gem of flat triangles

#declare Sides = 9;
#macro Ring(I, Radius, Height, Turn) <Radius*cos(2*pi*(I + Turn)/Sides), Height, Radius*sin(2*pi*(I + Turn)/Sides)> #end

#declare Gem = mesh {
  #for (I, 0, Sides - 1)
    triangle { 0*y, Ring(I, 1, 0.9, 0), Ring(I + 1, 1, 0.9, 0) }                      // pavilion
    triangle { Ring(I, 1, 0.9, 0), Ring(I + 1, 1, 0.9, 0), Ring(I, 0.6, 1.25, 0.5) }  // crown
    triangle { Ring(I, 0.6, 1.25, 0.5), Ring(I + 1, 0.6, 1.25, 0.5), Ring(I + 1, 1, 0.9, 0) }
    triangle { 1.25*y, Ring(I, 0.6, 1.25, 0.5), Ring(I + 1, 0.6, 1.25, 0.5) }         // table
  #end
  inside_vector y
}

// ---- A die: a box rounded by a sphere, pips cut out

#macro Pip(X, Y) sphere { <X, Y, -1.04>, 0.19 } #end

#declare Die = difference {
  intersection {
    box { -1, 1 }
    sphere { 0, 1.42 }
  }
  union {  // five on the front
    Pip(-0.5, 0.5) Pip(0.5, 0.5) Pip(0, 0) Pip(-0.5, -0.5) Pip(0.5, -0.5)
  }
  object {  // one on top
    Pip(0, 0)
    rotate 90*x
  }
  union {  // three on the right
    Pip(-0.5, 0.5) Pip(0, 0) Pip(0.5, -0.5)
    rotate -90*y
  }
  pigment { rgb <0.55, 0.06, 0.05> }
  finish { ambient 0.06 diffuse 0.75 specular 0.6 roughness 0.008 reflection 0.05 }
}

// ---- The still life

plane {
  y, 0
  pigment { checker rgb <0.85, 0.82, 0.76> rgb <0.16, 0.20, 0.26> }
  finish { ambient 0.05 diffuse 0.75 reflection 0.10 }
}

// The lute leans against a column.
cylinder {
  <0.55, 0, 2.6>, <0.55, 2.3, 2.6>, 0.5
  pigment { rgb <0.62, 0.60, 0.58> }
  finish { ambient 0.06 diffuse 0.8 }
}

object {
  Lute
  rotate <14, 0, -9>
  translate <0.1, 1.32, 0.6>
}

sphere {  // mirror
  <-2.55, 1.1, 1.1>, 1.1
  pigment { rgb 0.02 }
  finish { ambient 0 diffuse 0.1 specular 0.8 roughness 0.002 reflection 0.85 }
}

sphere {  // glass
  <1.75, 0.7, -2.0>, 0.7
  pigment { rgbf <0.96, 0.99, 0.98, 0.97> }
  finish { ambient 0 diffuse 0.02 specular 0.8 roughness 0.001 reflection { 0.05, 0.7 fresnel on } conserve_energy }
  interior { ior 1.5 fade_distance 3 fade_power 1 }
}

object {
  Die
  scale 0.48
  rotate -32*y
  translate <-1.55, 0.48, -2.1>
}

union {  // two rings, one leaning on the other
  torus { 0.46, 0.085 translate 0.085*y }
  torus { 0.46, 0.085 rotate -62*x translate <0.25, 0.50, 0.30> }
  texture { Gold }
  translate <0.15, 0, -2.6>
}

object {  // amethyst
  Gem
  scale 0.75
  rotate <0, 20, 38>
  translate <3.15, 0.28, 0.6>
  pigment { rgbf <0.80, 0.55, 0.95, 0.85> }
  finish { ambient 0.02 diffuse 0.08 specular 0.9 roughness 0.002 reflection { 0.05, 0.8 fresnel on } conserve_energy }
  interior { ior 1.55 }
}
