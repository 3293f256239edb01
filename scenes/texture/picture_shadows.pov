// Shadows of pictures that were made clear within a map of pigments: POV-Ray takes them for opaque where it judges a map
// for the first time, and copies of a declared pigment share what was found.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 10, 0> look_at 0 right 8 * x up 6 * z }
light_source { <0, 100, 0> rgb 1 }
plane { y, -1 pigment { rgb 1 } finish { ambient 0 diffuse 1 } hollow }

#macro Picture()
  image_map { function 4, 4 { pigment { gradient x color_map { [0 rgb <0.8, 0.4, 0.2>][1 rgb <0.3, 0.5, 0.9>] } } } filter all 0.9 }
#end
#declare OnSurface = pigment { uv_mapping Picture() }
#declare TwoOf = pigment { gradient x pigment_map { [0 Picture()][1 rgb 1] } }
#declare Deep = pigment { uv_mapping OnSurface }
#declare Tile = box { <-0.5, 0, -0.5>, <0.5, 0.2, 0.5> no_image }
#macro Row(Z, A, B, C, D)
  object { Tile texture { A } translate <-3, 0, Z> }
  object { Tile texture { B } translate <-1, 0, Z> }
  object { Tile texture { C } translate <1, 0, Z> }
  object { Tile texture { D } translate <3, 0, Z> }
#end
#declare Plain = texture { pigment { Picture() } }
#declare First = texture { pigment { OnSurface } }
#declare Mapped = texture { pigment { TwoOf } }
#declare Deeper = texture { pigment { Deep } }
Row(2.25, Deeper, Deeper, First, First)
Row(0.75, Mapped, Mapped, Plain, texture { uv_mapping pigment { Picture() } })
Row(-0.75, texture { pigment { uv_mapping Picture() } }, texture { pigment { uv_mapping gradient x color_map { [0 rgbt 0.5][1 rgbf 0.7] } } },
    texture { pigment { checker pigment { Picture() } pigment { rgbt 0.5 } } }, texture { pigment { checker pigment { Picture() } pigment { rgb 1 } } })
union {
  object { Tile translate -3 * x } object { Tile translate -x } object { Tile texture { First } translate x } object { Tile texture { First } translate 3 * x }
  pigment { uv_mapping Picture() } translate -2.25 * z
}
