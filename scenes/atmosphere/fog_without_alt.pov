// Ground fog with a fog_alt of 0, the default: full below its offset, none above, and black where a ray crosses the offset.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <-6, 8, -6> 1 }
background { rgb <0.2, 0.3, 0.6> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.7, 0.4, 0.2> } }
sphere { <0, 1, 3>, 1 pigment { rgb 1 } finish { reflection 0.3 } }
sphere { <2, 0.5, 1>, 0.5 pigment { rgb <0.9, 0.6, 0.2> } }
fog { distance 4 rgb <0.8, 0.75, 0.7> fog_type 2 fog_offset 0.4 }
