// Normals in texture maps: a map that was looked at before carries its neighbours' bumps through its own transformations, and with
// no_bump_scale lengths stay as the transformations make them.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location <0, 0, -10> look_at 0 right 8*x up 6*y }
light_source { <-20, 30, -40> rgb 1 }
background { rgb <0.1, 0.15, 0.2> }

#declare Bumpy = texture { pigment { rgb <0.9, 0.7, 0.4> } normal { bumps 0.8 scale <0.1, 0.3, 0.1> } }
#declare Dented = texture { pigment { rgb <0.4, 0.7, 0.9> } normal { dents 0.8 scale 0.2 } }
#declare Stripes = texture { gradient x texture_map { [0 pigment { rgb <0.8, 0.3, 0.2> }] [1 pigment { rgb <0.2, 0.6, 0.3> }] } }

#macro Ball(X, Y, Look)
  sphere { <X, Y, 0>, 0.9 texture { Look translate <X, Y, 0> } }
#end

Ball(-3, 1.6, texture { average texture_map { [1 Stripes rotate 70*z] [1 Bumpy] } })
Ball(-1, 1.6, texture { average texture_map { [1 Bumpy] [1 Stripes rotate 70*z] } })
Ball(1, 1.6, texture { average texture_map { [1 Stripes rotate 40*z] [1 Stripes scale <1, 4, 1>] [1 Bumpy] [1 Dented] } })
Ball(3, 1.6, texture { gradient y texture_map { [0 Bumpy] [1 Stripes rotate 70*z] } })
Ball(-3, -1.6, texture { gradient y no_bump_scale texture_map { [0 Bumpy] [1 Dented] } scale 3 })
Ball(-1, -1.6, texture { gradient y texture_map { [0 Bumpy] [1 Dented] } scale 3 })
Ball(1, -1.6, texture { bozo no_bump_scale texture_map { [0 gradient x texture_map { [0 Bumpy] [1 Dented] } scale 0.5] [1 Dented] } scale 2 })
Ball(3, -1.6, texture { bozo texture_map { [0 gradient x texture_map { [0 Bumpy] [1 Dented] } scale 0.5 no_bump_scale] [1 Dented] } scale 2 })
