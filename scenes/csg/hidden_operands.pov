// Operands that only some rays see: flags of operands of merges and of unions that stay whole count, those of
// differences and intersections don't, unless these are inverted; no_shadow counts for none of them, unless all of a union have it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -11> look_at <0, 0.3, 0> angle 44 }
background { rgb <0.55, 0.7, 0.85> }
light_source { <-8, 12, -9> rgb 1 }
plane { y, -0.7 pigment { checker rgb 0.9 rgb 0.6 } finish { reflection 0.4 } }

#declare Red = pigment { rgb <0.9, 0.25, 0.2> }
#declare Blue = pigment { rgb <0.25, 0.35, 0.9> }
#macro Pair(First, Second)
  box { <-0.7, -0.7, -0.7>, <0.5, 0.4, 0.4> pigment { Red } #if (First = 1) no_image #end #if (First = 2) no_reflection #end #if (First = 3) no_shadow #end }
  sphere { <0.3, 0.2, 0.3>, 0.7 pigment { Blue } #if (Second = 1) no_image #end #if (Second = 2) no_reflection #end #if (Second = 3) no_shadow #end }
#end

// Back row: what a camera ray and a mirrored ray go past in a merge, and what a bounded union hides from its mirror image.
merge { Pair(1, 0) translate <-3.6, 0, 2> }
merge { Pair(0, 1) translate <-1.2, 0, 2> }
merge { Pair(2, 0) translate <1.2, 0, 2> }
union { Pair(0, 2) bounded_by { sphere { 0, 3 } } translate <3.6, 0, 2> }

// Middle row: a hidden operand still counts where the others are cut.
intersection { merge { Pair(1, 0) } sphere { 0, 0.95 pigment { rgb 0.9 } } translate <-2.4, 0, 0> }
difference { merge { Pair(0, 1) } sphere { <-0.3, 0.4, -0.7>, 0.6 pigment { rgb 0.9 } } }
intersection { union { Pair(2, 0) } sphere { 0, 0.95 pigment { rgb 0.9 } } translate <2.4, 0, 0> }

// Front row: shadows. Filtered by both operands of an intersection; of a union none; of one that is clipped none either.
#declare Clear = pigment { rgbf <0.95, 0.8, 0.5, 0.7> }
intersection { sphere { 0, 0.6 pigment { Clear } no_shadow } box { -0.5, 0.5 pigment { Clear } no_shadow } translate <-2.6, -0.2, -2.4> }
union { sphere { 0, 0.5 pigment { Red } no_shadow } cylinder { 0, <0, 0.9, 0>, 0.2 pigment { Blue } no_shadow } split_union off translate <0, -0.2, -2.4> }
union { sphere { 0, 0.5 pigment { Red } no_shadow } cylinder { 0, <0, 0.9, 0>, 0.2 pigment { Blue } no_shadow }
  clipped_by { sphere { 0, 0.6 } } translate <2.4, -0.2, -2.4> }

// Inverted: an intersection, which hides nothing; inverted twice: a merge, which does.
intersection { sphere { 0, 0.6 pigment { rgb 0.9 } } merge { box { -1, <1, 0.1, 0.1> pigment { Red } no_image } sphere { <0, 0.4, -0.2>, 0.3 pigment { Blue } no_image } inverse } translate <-1.3, -0.1, -4> }
difference { sphere { 0, 0.6 pigment { rgb 0.9 } } union { box { -1, <1, 0.1, 0.1> pigment { Red } no_image } sphere { <0, 0.4, -0.2>, 0.3 pigment { Blue } } inverse } translate <1.3, -0.1, -4> }
union { sphere { 0, 0.3 pigment { Clear } no_shadow } inverse translate <0, -0.4, -4.5> }

// An inverted difference or intersection: a merge.
difference { sphere { 0, 0.6 pigment { Red } no_image } sphere { <0.4, 0.25, -0.25>, 0.4 pigment { Blue } } inverse translate <-2.6, 2.2, 0> }
intersection { sphere { 0, 0.6 pigment { Red } no_reflection } sphere { <0.4, 0.25, -0.25>, 0.4 pigment { Blue } } inverse translate <2.6, 2.2, 0> }
