// Boxes in one place, red, green and blue in order of declaration: which of them is seen where a clip, a union in a
// union or a subtrahend that reaches nothing stands between (docs/povray/05a, 2.2).
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <5, -3, -16>
  look_at <5, -3, 0>
  angle 45
}
#default { finish { ambient 0 diffuse 0 emission 1 } }
background { rgb <0.1, 0.12, 0.16> }

#declare Red = box { -0.5, 0.5 pigment { rgb <0.9, 0.2, 0.15> } }
#declare Green = box { -0.5, 0.5 pigment { rgb <0.2, 0.75, 0.25> } }
#declare Blue = box { -0.5, 0.5 pigment { rgb <0.2, 0.35, 0.95> } }
#declare Around = box { -2, 2 }
#declare Far = box { 8, 9 }
#declare Pair = union { object { Red } object { Green } }
#declare Clipped_pair = union { object { Red } object { Green } clipped_by { Around } }
#declare Common = intersection { object { Red } object { Green } object { Around } }
#declare Clipped_common = intersection { object { Red } object { Green } object { Around } clipped_by { Around } }

#macro At(Column, Row) translate <Column * 2, -Row * 2, 0> #end

union { object { Red } object { Green } object { Blue } clipped_by { Around } At(0, 0) }
union { object { Red } object { Green } object { Blue } split_union off clipped_by { Around } At(1, 0) }
object { Clipped_common At(2, 0) }
intersection { object { Clipped_pair } object { Around } At(3, 0) }
intersection { object { Pair } object { Around } clipped_by { Around } At(4, 0) }
intersection { object { Pair } object { Blue } object { Around } clipped_by { Around } At(5, 0) }

union { object { Clipped_pair } object { Blue } At(0, 1) }
union { object { Pair } object { Blue } clipped_by { Around } At(1, 1) }
union { object { Blue } object { Clipped_pair } split_union off At(2, 1) }
union { object { Blue } object { Pair } clipped_by { Around } At(3, 1) }
difference { object { Pair } object { Far } At(4, 1) }
difference { object { Pair } object { Far } clipped_by { Around } At(5, 1) }

difference { object { Clipped_pair } object { Far } At(0, 2) }
intersection { object { Common } object { Around } clipped_by { Around } At(1, 2) }
intersection { object { Clipped_common } object { Around } At(2, 2) }
intersection { object { Blue } object { Clipped_common } object { Around } At(3, 2) }
union { object { Common } object { Clipped_common } clipped_by { Around } At(4, 2) }
union { object { Clipped_common } object { Common } split_union off At(5, 2) }

union { object { Blue } object { Clipped_pair } clipped_by { Around } At(0, 3) }
union { object { Clipped_pair } object { Blue } clipped_by { Around } At(1, 3) }
intersection { union { object { Clipped_pair } object { Blue } } object { Around } At(2, 3) }
union { union { union { object { Pair } clipped_by { Around } } object { Blue } } object { Red } clipped_by { Around } At(3, 3) }
difference { object { Common } object { Far } At(4, 3) }
difference { difference { object { Pair } object { Far } } object { Far translate 2 } At(5, 3) }
