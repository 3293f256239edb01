// ambient with coloured ambient_light, and emission that ignores it.
#version 3.7;
global_settings { assumed_gamma 1.0 ambient_light rgb <1.2, 1, 0.6> }
camera { location <0, 1.4, -6> look_at <0, 0.5, 0> angle 50 }
light_source { <-3, 5, -4> rgb 0.6 }

#macro Ball(I, F) sphere { <-2.2 + 1.1*I, 0.5, 0>, 0.5 pigment { rgb <0.7, 0.8, 0.9> } finish { F } } #end
Ball(0, finish { ambient 0 })
Ball(1, finish { ambient 0.3 })
Ball(2, finish { ambient rgb <0.6, 0, 0.2> })
Ball(3, finish { ambient 0 emission 0.4 })
Ball(4, finish { ambient 0 emission rgb <0, 0.3, 0.6> })
plane { y, 0 pigment { rgb 0.7 } }
