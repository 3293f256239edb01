// OpenSCAD's text: letters of a font are a solid, so they can be cut into a plate or stand on it.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<0, 0, 0>, 30)

// text("M8 x 40", size=6) is 1 high at first: scale gives the size; thickness runs along z.
#declare Word = text { ttf "cyrvetic.ttf", "M8 x 40", 1, 0 scale <6, 6, 1> }
#declare Low = min_extent(Word);
#declare High = max_extent(Word);
#declare Centred = object { Word translate -(Low + High)/2 }    // halign and valign "center"

difference {
  box { <-14, -4, -2>, <14, 4, 0> }
  object { Centred }
  texture { Yellow }
  translate <0, 6, 0>
}
union {
  box { <-14, -4, -2>, <14, 4, 0> texture { Yellow } }
  object { Centred texture { Green } }
  translate <0, -6, 0>
}
