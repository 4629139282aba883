// Ray and box by slabs: for each axis the ray is between the two planes for t in [t1, t2]; the largest t1 is where it enters, the
// smallest t2 where it leaves; a miss when it would leave before it enters, or leave behind the eye. Parallel to a slab: inside
// it for all t, or for none.
// The camera looks along z through the middle, so that one column of rays has Dx = 0 and one row Dy = 0; boxes beside, behind
// and around the eye are the cases of a miss and of a start inside.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.25, 0.35> }
camera { location <0, 0, -6> look_at <0, 0, 0> angle 55 }
light_source { <-4, 5, -9> rgb 1 }
box { <-0.8, -0.8, -0.8>, <0.8, 0.8, 0.8> pigment { rgb <0.8, 0.3, 0.2> } rotate <20, 35, 0> }
box { <-3, -1.5, 0>, <-1.8, 1.5, 1> pigment { rgb <0.3, 0.7, 0.3> } }
box { <3, 1.2, 1>, <1.6, 0.2, -0.5> pigment { rgb <0.85, 0.75, 0.2> } }             // corners in the other order
box { <1.5, -1.4, -0.2>, <3, -0.6, 0.2> pigment { rgb <0.3, 0.5, 0.9> } }
box { <-1, -1, -9>, <1, 1, -7> pigment { rgb <1, 0, 1> } }                          // behind the eye
box { <-20, -15, -30>, <20, 15, 20> pigment { rgb <0.35, 0.35, 0.4> } hollow }      // around the eye
