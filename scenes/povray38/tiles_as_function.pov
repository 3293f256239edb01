#version 3.8;
// Pavement and tiling in functions: a floor whose tiles stand out by one, and a ball with a pigment that asks another.
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at <0, 0.2, 0> angle 45 right x*4/3 }
light_source { <-4, 6, -5>, 1 }
#declare Tiles = function { pattern { tiling 8 sine_wave scale 0.6 } }
#declare Paving = function { pattern { pavement number_of_sides 4 number_of_tiles 3 scale 0.3 } }
isosurface {
  function { y - 0.15*Tiles(x, 0, z) }
  contained_by { box { <-2, -0.2, -2>, <2, 0.2, 2> } }
  max_gradient 3
  pigment { rgb <0.8, 0.6, 0.4> }
}
sphere { <0, 0.9, 0>, 0.7
  pigment { function { Paving(x, 0, y) } color_map { [0 rgb <0.1, 0.2, 0.4>] [1 rgb <0.9, 0.9, 0.6>] } }
  finish { phong 0.4 }
}
