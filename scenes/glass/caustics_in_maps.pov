// Panes with `caustics` whose normals are bent within texture maps: the maps' turning turns what bends them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -0.01> look_at 0 angle 50 }
light_source { <6, 18, 0> rgb 0.4 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare Slope = texture {
  pigment { rgbt <0.7, 0.8, 0.9, 1> }
  normal { gradient x 2 scale 10 translate -5 * x }
  finish { ambient 0 diffuse 0 }
}
#declare Flat = texture { pigment { rgbt <0.9, 0.8, 0.7, 1> } finish { ambient 0 diffuse 0 } }
#macro Pane(Place, Turn)
  box { <-0.8, 1, -0.8>, <0.8, 1.05, 0.8>
    texture { gradient z texture_map { [0 Slope] [0.5 Slope] [1 Flat] } scale 1.7 rotate y * Turn }
    interior { caustics 20 }
    no_image
    translate Place
  }
#end
Pane(<-1, 0, -1>, 90)
Pane(<1, 0, -1>, 180)
Pane(<-1, 0, 1>, 0)
Pane(<1, 0, 1>, 30)
