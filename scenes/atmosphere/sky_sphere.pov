// A sky_sphere of two layers, turned, seen directly and in a mirror; emission dims it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> look_at <0, 1.4, 0> angle 60 }
light_source { <-6, 8, -6>, 1 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.3 rgb <0.3, 0.5, 0.9>] [1 rgb <0, 0.1, 0.4>] } }
  pigment { checker rgbt 1 rgbt <1, 1, 1, 0.5> scale 0.25 }
  emission rgb <0.9, 0.8, 1>
  rotate <15, 40, 10>
}
plane { y, 0 pigment { rgb 0.3 } finish { reflection 0.4 } }
sphere { <0, 1.2, 0>, 1 pigment { rgb 0.1 } finish { reflection 0.8 } }
