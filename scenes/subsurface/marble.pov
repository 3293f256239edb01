// A ball and a block of two stones that light goes into.
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 10 subsurface { samples 24, 12 } }
camera { location <0, 1.6, -4> look_at <0, 0.55, 0> angle 40 }
light_source { <4, 6, -4> rgb 1 }
plane { y, 0 pigment { rgb 0.5 } finish { ambient 0.03 diffuse 0.6 } }
sphere { <-0.75, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.7, 0.55> } interior { ior 1.4 } finish { ambient 0 diffuse 0.8 specular 0.3 subsurface { translucency <2, 1, 0.6> } } }
box { <0.2, 0, -0.4>, <1.2, 0.8, 0.4> rotate 25 * y pigment { granite color_map { [0 rgb <0.85, 0.9, 0.8>] [1 rgb <0.5, 0.7, 0.6>] } scale 0.6 }
  interior { ior 1.5 } finish { ambient 0 diffuse 0.75 subsurface { translucency 1.5 } } }
