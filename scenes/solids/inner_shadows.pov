// Shadows of what is opaque outside and clear inside, from a light behind: a blob is black all the same, alone, of several
// components and in CSG; a sphere lets the light through its far side (docs/povray/03, 13.2).
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 2.6, -11>
  look_at <0, 0.1, 0>
  angle 40
}
light_source { <4, 9, 12> rgb 1.2 }
background { rgb <0.3, 0.35, 0.42> }
plane { y, -1.2 pigment { rgb <0.8, 0.78, 0.7> } }

#declare Opaque = texture { pigment { rgb <0.9, 0.6, 0.4> } }
#declare Clear = texture { pigment { rgbft <0.6, 0.8, 0.95, 0.3, 0.5> } }

blob { sphere { 0, 1.3, 2 } texture { Opaque } interior_texture { Clear } double_illuminate translate <-2.6, 0, 1> }
sphere { 0, 1 texture { Opaque } interior_texture { Clear } double_illuminate translate <0, 0, 1> }
blob {
  threshold 0.5
  sphere { <-0.5, 0, 0>, 0.9, 1.4 }
  cylinder { <-0.5, 0, 0>, <0.7, 0.3, 0>, 0.6, 1 }
  texture { Opaque }
  interior_texture { Clear }
  double_illuminate
  translate <2.6, 0, 1>
}
merge {
  blob { sphere { 0, 1, 2 } }
  box { <-0.9, -0.15, -0.9>, <0.9, 0.15, 0.9> }
  texture { Opaque }
  interior_texture { Clear }
  double_illuminate
  translate <-1.5, -0.3, -1.6>
}
blob { sphere { 0, 1.1, 2 } texture { Clear } interior_texture { Opaque } double_illuminate translate <1.3, -0.3, -1.6> }
