// Textures as version 1 had them, with the words of pigment, normal and finish in the texture itself; images behind a
// vector; a fog whose distance is a bare number.
#version 1.0
camera { location <0 3 -8> direction <0 0 1.5> up <0 1 0> right <1.333 0 0> look_at <0 0.6 0> }
object { light_source { <10 20 -15> colour red 1 green 1 blue 1 } }
object { sphere { <-2.4 1 0> 1 } texture { colour red 0.8 green 0.2 blue 0.1 phong 0.8 phong_size 40 ambient 0.15 } }
object { sphere { <0 1 0> 1 } texture { turbulence 0.6 marble octaves 4 scale <0.5 0.5 0.5> reflection 0.1 } }
object { sphere { <2.4 1 0> 1 } texture {
  wood colour_map { [0.0 0.5 colour red 1 colour blue 1] [0.5 1.0 colour blue 1 colour green 1] }
  scale <0.4 0.4 0.4> ripples 0.4 frequency 4 phase 0.3 specular 0.5 roughness 0.05 } }
composite {
  object { box { <-1.4 0 -2.2> <-0.6 0.6 -1.6> } texture { waves 0.3 colour blue 0.9 alpha 0.4 } texture { granite scale 0.2 } }
  object { box { <0.4 0 -2.2> <1.2 0.8 -1.6> } texture { image_map { <1 -1 0> gif "shapes.gif" once } bumps 0.2 } }
  object { cylinder { <2 0 -2> <2 0.7 -2> 0.4 } texture { bump_map { <1 -1 0> gif "shapes.gif" bump_size 4 } colour red 1 green 0.8 } }
  rotate <0 5 0>
}
plane { <0 1 0> 0 texture { scale <0.6 0.6 0.6> checker colour red 0.9 green 0.9 blue 0.9 colour red 0.4 dents 0.2 } }
fog { colour red 0.6 green 0.7 blue 0.9 40 }
