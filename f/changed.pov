// A finish behind a declared texture changes what it names and leaves the rest; a declared finish takes the place of all.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.5, -8> look_at <0, 0.6, 0> angle 45 }
light_source { <-4, 8, -6> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
#declare Worn = texture { pigment { rgb <0.8, 0.5, 0.3> } finish { ambient 0.3 diffuse 0.5 phong 0.9 phong_size 20 } }
#declare Plain = finish { diffuse 0.9 }
sphere { <-2.4, 0.8, 0>, 0.8 texture { Worn } }
sphere { <-0.8, 0.8, 0>, 0.8 texture { Worn finish { reflection 0.4 } } }
sphere { <0.8, 0.8, 0>, 0.8 texture { Worn } finish { phong_size 90 } }
sphere { <2.4, 0.8, 0>, 0.8 texture { Worn finish { Plain } } }
union {
  box { <-3, 2, 2>, <-1, 3, 3> }
  box { <1, 2, 2>, <3, 3, 3> texture { Worn finish { ambient 0 } finish { brilliance 3 } } }
  texture { Worn finish { diffuse 0.2 } }
}
plane { y, 0 pigment { checker rgb 0.8 rgb 0.4 } }
