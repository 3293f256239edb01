// #if, #elseif, #ifdef, #ifndef, defined(), strings compared, arrays, #local hiding #declare.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -6> look_at <0, 0.3, 0> angle 48 }
light_source { <3, 6, -5> rgb 1 }

#declare Kind = "cone";
#declare Size = 0.8;
#declare Colors = array[3] { rgb <0.9, 0.3, 0.3>, rgb <0.3, 0.8, 0.4>, rgb <0.4, 0.4, 0.9> }

#macro Thing(Kind_of, I)
  #local Size = 0.5;
  #if (strcmp(Kind_of, "box") = 0)
    box { -Size, Size
  #elseif (!strcmp(Kind_of, "cone"))
    cone { -Size*y, Size, Size*y, 0
  #else
    sphere { 0, Size
  #end
    pigment { Colors[I] } translate <1.4*(I - 1), 0.5, 0> }
#end
Thing("box", 0)
Thing(Kind, 1)
Thing(concat("sp", "here"), 2)

#ifndef (Missing)
  plane { y, 0 pigment { rgb Size } }
#end
#ifdef (Colors)
  sphere { <0, 1.4, 1>, 0.3 pigment { Colors[dimension_size(Colors, 1) - 1] } }
#end
#undef Size
#if (defined(Size)) sphere { 0, 3 } #end
