#version 3.8;
// Each word of 3.8 once: what --dump says of it is compared in tests/golden/dumps.
global_settings { assumed_gamma 1 }
camera {
  user_defined
  location { function { 1.4*x } function { 0.4 + y } function { -4 } }
  direction { function { 0.4*x } function { 0.3*y - 0.1 } function { 1 } }
}
light_source { <-4, 6, -6>, rgb 7 fade_power 1 }
#declare Set = dictionary { .Size: 0.5, ["Pull"]: tau/12 }
#declare Shades = array mixed [2] { "orange", rgb <0.9, 0.6, 0.2> }
#declare Gaps = array[3] optional { 1, , 3 }
#declare (Low, High) = (0, version/3.8);
#macro Ball(R, optional C)
  sphere { <-0.3, 1.2, 0>, local.R #ifdef (local.C) pigment { rgb C } #else pigment { global.Grey } #end }
#end
#declare Grey = rgb Shades[1].grey;
Ball(0.3, )
lemon { -Set.Size*y, Low, Set.Size*y, 0.1, 0.6 open pigment { Shades[1] } translate <-1.4, 0.6, 0> finish { fresnel 0.5 use_alpha on specular 0.3 } }
ovus { 0.3, 0.2 radius 0.9 distance 0.5 precision 1e-6 translate <0.5, 0.3, 0> pigment { user_defined { function { x + 0.5 }, function { y }, function { 0.4 } } } }
torus { 0.2, 0.35 difference rotate 90*x translate <1.4, 0.6, 0> pigment { rgb <0.4, 0.7, 0.9> } }
isosurface { function { 0.4 - sqrt(x*x + y*y + z*z) } contained_by { box { -0.5, 0.5 } } max_gradient 1.2 polarity on translate <-0.4, 0.3, 0>
  pigment { potential { blob { threshold 0.3 sphere { -0.4*z, 0.6, 1 } } } threshold on color_map { [0 rgb <0.3, 0.4, 0.8>] [0.4 rgb 1] } } }
plane { y, -0.4 pigment { crackle repeat <3, 2, 3> scale 0.4 color_map { [0 rgb 0.2] [High rgb 1] } } }
box { <0.4, 0.8, 0>, <1, 1.4, 0.1>
  pigment { image_map { png "../pigment/leaf.png" gamma bt709 map_type 7 transmit all 0.4 filter all 0.1 } scale 0.6 translate <0.7, 1.1, -0.5> } }
box { <-1, 0.9, 0>, <-0.7, 1.3, 0.1> pigment { image_map { png "../pigment/weave.png" gamma bt2020 } scale 0.4 } }
#if (defined(Gaps[2]) & !defined(Gaps[1])) cylinder { <1.3, 1.1, 0>, <1.6, 1.1, 0>, 0.1 pigment { rgb x } } #end
