// Thin plates of wax before a light: what shines through depends on their thickness in mm.
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 5 subsurface { samples 24, 16 } }
camera { location <0, 1, -4.5> look_at <0, 0.6, 0> angle 40 }
light_source { <0, 1.5, 4> rgb 2 }
light_source { <3, 5, -5> rgb 0.3 }
plane { y, 0 pigment { rgb 0.6 } finish { ambient 0.02 diffuse 0.6 } }
#declare Wax = finish { ambient 0 diffuse 0.9 subsurface { translucency <3, 2, 1.2> } };
#for (I, 0, 3)
  box { <-1.5 + 0.75 * I, 0, 0>, <-0.9 + 0.75 * I, 1.1, 0.04 + 0.12 * I> pigment { rgb <0.95, 0.85, 0.7> } interior { ior 1.3 } finish { Wax } }
#end
