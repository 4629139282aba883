#version 3.7;
global_settings { assumed_gamma 1 }
// Boxes as min_extent and max_extent tell them, and the normals of round shapes with the signs of their zeros.
#fopen W "out.txt" write
#macro V(Name, Value) #write(W, Name, " ", vstr(3, Value, ",", 0, 6), "\n") #end
#macro E(Name, Thing) V(Name, min_extent(Thing)) V(Name, max_extent(Thing)) #end

#declare O = cylinder { 0, y, 1 } E("cylinder", O)
#declare O = cylinder { 0, <1, 2, 3>, .5 } E("slanted cylinder", O)
#declare O = cylinder { 0, y, 1 rotate 30*z } E("turned cylinder", O)
#declare O = cone { 0, 1, y, .5 } E("cone", O)
#declare O = cone { 0, 1, <1, 2, 3>, .5 } E("slanted cone", O)
#declare O = cone { 0, .5, <1, 2, 3>, 1 scale <1, 2, 1> } E("scaled cone", O)
#declare O = sphere { <1, 2, 3>, 2 rotate <10, 20, 30> } E("turned sphere", O)
#declare O = sphere { 0, 1 scale <1, 2, 3> rotate 30*z } E("ellipsoid", O)
#declare O = box { 0, 1 rotate 30*z } E("turned box", O)
#declare O = torus { 1, .2 rotate 30*z } E("turned torus", O)
#declare O = disc { 0, <1, 1, 1>, 1 } E("slanted disc", O)
#declare O = superellipsoid { <.5, .5> rotate 45*y } E("superellipsoid", O)
#declare O = lathe { linear_spline 3 <0, 0>, <1, .5>, <0, 1> rotate 20*x } E("turned lathe", O)
#declare O = prism { 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> rotate 20*y } E("turned prism", O)
#declare O = mesh { triangle { 0, x, y } triangle { x, y, z } rotate 30*z } E("turned mesh", O)
#declare O = blob { threshold .5 sphere { <1, 2, 3>, 1, 1 rotate <10, 20, 30> scale <1, 2, 3> } } E("ellipsoid of a blob", O)
#declare O = blob { threshold .5 sphere { <1, 2, 3>, 1, 1 scale <1, 2, 3> rotate <10, 20, 30> } } E("turned ellipsoid of a blob", O)
#declare O = blob { threshold .5 cylinder { 0, x, .5, 1 } } E("cylinder of a blob", O)
#declare O = blob { threshold .5 cylinder { 0, <1, 2, 3>, .5, 1 } sphere { <2, 1, 0> .3, 1 } } E("slanted cylinder of a blob", O)
#declare O = blob { threshold .5 cylinder { 0, <1, -2, 3>, .5, 1 scale <1, 2, 1> } } E("scaled cylinder of a blob", O)
#declare O = blob { threshold .5 cylinder { 0, <10, 1, 0>, 1, 1 } } E("long cylinder of a blob", O)
#declare O = blob { threshold .5 cylinder { 0, 2*y, .5, 1 } rotate 30*z } E("turned blob", O)
#declare O = blob { threshold .5 cylinder { 0, 2*y, .5, -1 } sphere { 0, 1, 1 } } E("blob with a hollow", O)
#declare O = polygon { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> } E("polygon", O)
#declare O = polygon { 4, <0, 1, 0>, <1, 1, 9e-4>, <1, 2, 9e-4>, <0, 2, 0> } E("thin polygon", O)
#declare O = polygon { 4, <0, 0, 0>, <1, 0, 11e-4>, <1, 1, 11e-4>, <0, 1, 0> } E("less thin polygon", O)
#declare O = polygon { 3, <0, 0>, <3, 0>, <1, 1> rotate <10, 20, 30> translate <1, 2, 3> } E("turned polygon", O)
#declare O = polygon { 3, <0, 0>, <3, 0>, <1, 1> rotate <10, 20, 30> scale <1, 2, 3> } E("scaled polygon", O)
#declare O = sphere_sweep { linear_spline 2, <-2, 0, 0>, .1 <1, 1, 0>, .3 } E("linear sweep", O)
#declare O = sphere_sweep { cubic_spline 4, <-2, 0, 0>, .1 <-1, 0, 4>, .2 <1, 1, 0>, .3 <4, 3, 1>, .1 } E("cubic sweep", O)
#declare O = sphere_sweep { cubic_spline 4, <-2, 0, 0>, .1 <-1, 0, 4>, .2 <1, 1, 0>, .3 <4, 3, 1>, .1 rotate 40*x scale 2 }
E("turned cubic sweep", O)
#declare O = sphere_sweep { cubic_spline 4, <-2, 0, 0>, .1 <-1, 0, 4>, .2 <1, 1, 0>, .3 <4, 3, 1>, .1 scale <1, 2, 3> rotate <10, 20, 30> }
E("scaled cubic sweep", O)
#declare O = sphere_sweep { b_spline 4, <-2, 0, 0>, .1 <-1, 0, 4>, .2 <1, 1, 0>, .3 <4, 3, 1>, .1 } E("b_spline sweep", O)
#declare O = plane { y, 0 } E("plane", O)
#declare O = union { sphere { 0, 1 } box { 1, 2 } } E("union", O)
#declare O = union { sphere { 0, 1 } box { 1, 2 } rotate 45*y } E("turned union", O)
#declare O = object { O rotate 30*x } E("union turned again", O)
#declare O = intersection { sphere { 0, 1 } box { 0, 2 } } E("intersection", O)
#declare O = intersection { sphere { 0, 1 } plane { y, .3 } } E("with plane", O)
#declare O = intersection { sphere { 0, 1 } plane { y, .3 translate .2*y } } E("with moved plane", O)
#declare O = intersection { quadric { <1, 0, 1>, 0, 0, -1 } plane { y, 1 } plane { -y, 1 } } E("quadric between planes", O)
#declare O = difference { box { -1, 1 } plane { y, .3 } } E("without half space", O)
#declare O = difference { box { -1, 1 } plane { x + y, .3 } } E("without slanted half space", O)
#declare O = difference { cone { 0, 1, y, .5 } cylinder { -y, 2*y, .3 } rotate <20, 30, 40> } E("turned difference", O)
#declare O = object { sphere { 0, 1 } clipped_by { box { 0, 1 } } } E("clipped", O)
#declare O = object { sphere { 0, 1 } bounded_by { box { 0, .5 } } } E("bounded", O)
#declare O = light_source { 0, 1 } E("light", O)
#declare O = quadric { <1, 1, 1>, 0, 0, -1 } E("quadric", O)
E("moved quadric", object { O translate <1, 2, 3> scale <1, 2, 3> }) E("turned quadric", object { O rotate 45*z })
E("tilted quadric", object { O scale <1, 2, 3> rotate <10, 20, 30> })
E("quadric inside out", quadric { <-1, -1, -1>, 0, 0, 1 }) E("quadric off centre", quadric { <1, 2, 1>, 0, <1, 2, 3>, -1 rotate 45*z })
E("mixed quadric", quadric { <1, 2, 1>, <.5, 0, 0>, 0, -1 })
#macro Q(Name, Thing)
  E(concat(Name, " in a box"), intersection { object { Thing } box { -3, 3 } })
  E(concat(Name, " turned in a box"), intersection { object { Thing rotate 90*x } box { -3, 3 } })
  E(concat(Name, " in a turned box"), intersection { object { Thing } box { -3, 3 } rotate 45*z })
  E(concat(Name, " between planes"), intersection { object { Thing } plane { y, 1 } plane { -y, 1 } })
  E(concat(Name, " clipped by planes"), object { Thing clipped_by { plane { y, 1 } plane { -y, 1 } } })
  E(concat(Name, " clipped by a box"), object { Thing clipped_by { box { -3, 3 } } })
#end
Q("round", quadric { <1, 4, 1>, 0, 0, -1 })
Q("cylinder", quadric { <1, 0, 1>, 0, 0, -1 })
Q("cylinder inside out", quadric { <-1, 0, -1>, 0, 0, 1 })
Q("moved cylinder", quadric { <1, 0, 1>, 0, 0, -1 translate <.5, .25, .1> })
Q("cone", quadric { <1, -1, 1>, 0, 0, 0 })
Q("hyperboloid", quadric { <1, -1, 1>, 0, 0, -1 })
Q("wide hyperboloid", quadric { <1, -1, 1>, 0, 0, -4 })
Q("two sheets", quadric { <-1, 1, -1>, 0, 0, -1 })
Q("paraboloid", quadric { <1, 0, 1>, 0, -y, 0 })
Q("saddle", quadric { <1, 0, -1>, 0, -y, 0 })
Q("slab", quadric { <0, 1, 0>, 0, 0, -.25 })
E("planes", intersection { plane { y, 1 } plane { -y, 1 } plane { x, 2 } })
#macro Patch(Type)
  bicubic_patch {
    type Type flatness .1 u_steps 3 v_steps 3
    #for (I, 0, 3) #for (J, 0, 3) #if (I + J > 0) , #end <I, J, sin(I*J)> #end #end
  }
#end
#for (Type, 0, 1)
  E("patch", Patch(Type)) E("moved patch", object { Patch(Type) scale <1, -2, 3> translate 1 })
  E("turned patch", object { Patch(Type) rotate <20, 30, 40> scale <1, 2, 3> })
#end
#declare O = julia_fractal { <-.08, 0, -.8, -.03> } E("fractal", O) E("turned fractal", object { O rotate 45*z translate x })
E("large fractal", julia_fractal { <.9, 0, -.8, -.03> cube }) E("cubic fractal", julia_fractal { <.1, .5, -.2, 0> cube })
#macro X(Font, String)
  E(concat("text ", Font, " '", String, "'"), text { ttf Font String .25, 0 })
#end
X("timrom.ttf", "lute") X("timrom.ttf", "lute ") X("timrom.ttf", "lute    ") X("timrom.ttf", "  lute") X("timrom.ttf", " ")
X("timrom.ttf", "") X("timrom.ttf", "a b") X("timrom.ttf", "j@*Y") X("timrom.ttf", "l*") X("cyrvetic.ttf", "j") X("crystal.ttf", " a ")
E("text with offset", text { ttf "timrom.ttf" "  lute " .25, <.1, -.2, .3> })
E("turned text", text { ttf "timrom.ttf" "  lute  " .25, 0 rotate <20, 30, 40> translate x })
E("text with depth", text { ttf "timrom.ttf" " A" 100, 0 }) E("text turned inside out", text { ttf "timrom.ttf" "lute" -1, 0 })
E("fractal of four", julia_fractal { <.1, 0, -.2, 0> hypercomplex sqr }) E("sine fractal", julia_fractal { <.1, 0, -.2, 0> hypercomplex sin })

#declare Axis = array[6] { x, -x, y, -y, z, -z }
#macro T(Name, Thing, From, To)
  #local N = <0, 0, 0>;
  #local P = trace(Thing, From, To, N);
  V(Name, P) V(Name, N)
#end
#for (I, 0, 5)
  #declare O = cylinder { 0, Axis[I], .5 }
  #for (J, 0, 5)
    T(concat("cylinder ", str(I, 0, 0)), O, Axis[I]*.5 + Axis[J]*2, -Axis[J])
    T(concat("cylinder ", str(I, 0, 0)), O, Axis[I]*.5 + Axis[J]*2 + .1*vrotate(Axis[I], 90), -Axis[J])
  #end
#end
#fclose W
camera { }
sphere { 0, 1 }
