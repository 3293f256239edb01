#version 3.8;
// Commas behind the last element of a list, of a matrix and of a patch; grey spelt so.
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0.2*y angle 50 }
light_source { <-4, 6, -6>, 1 }
#declare Shades = array[4] { <0.9, 0.3, 0.2>, <0.4, 0.8, 0.3>, <0.3, 0.5, 0.9>, <0.9, 0.8, 0.3>, }
#declare Mixed = dictionary { .Size: 0.5, .Name: "box", }
bicubic_patch {
  type 1 flatness 0.01 u_steps 3 v_steps 3
  <-2, 0, -2>, <-1, 0.6, -2>, <1, -0.5, -2>, <2, 0, -2>, <-2, 0.5, -1>, <-1, 0, -1>, <1, 0.6, -1>, <2, 0, -1>,
  <-2, 0, 1>, <-1, 0.7, 1>, <1, 0, 1>, <2, 0.4, 1>, <-2, 0, 2>, <-1, 0, 2>, <1, 0.5, 2>, <2, 0, 2>,
  pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.4 }
}
#declare First = rgb Shades[0];
#for (I, 0, 3)
  box { -Mixed.Size*0.5, Mixed.Size*0.5 matrix <1, 0.2, 0, -0.3, 1, 0.1, 0, 0.2, 1, I - 1.5, 0.9, 0,> pigment { rgb Shades[I] } }
#end
sphere { <0, 1.4, 0>, 0.3 pigment { rgb First.grey } }
