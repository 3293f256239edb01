// Below a clear coat, behind glass, and seen in a mirror; one of the spheres has an index below 1.
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 10 subsurface { samples 20, 10 } }
camera { location <0, 1.8, -4.5> look_at <0, 0.6, 0> angle 42 }
light_source { <-4, 6, -3> rgb 0.9 area_light 2 * x, 2 * y, 3, 3 adaptive 0 }
plane { y, 0 pigment { rgb 0.4 } finish { ambient 0.02 diffuse 0.5 reflection 0.3 } }
sphere { <-1.2, 0.6, 0>, 0.6
  texture { pigment { rgb <0.7, 0.8, 0.95> } finish { ambient 0.05 diffuse 0.7 subsurface { translucency 1.2 } } }
  texture { pigment { rgbt <1, 0.9, 0.8, 0.7> } finish { ambient 0 diffuse 0.2 phong 0.6 } }
  interior { ior 1.3 } }
sphere { <0.2, 0.5, 0.3>, 0.5 pigment { rgb <0.9, 0.5, 0.5> } interior { ior 0.8 } finish { ambient 0 diffuse 0.8 subsurface { translucency <1, 1.5, 2> } } }
box { <0.9, 0, -0.3>, <1.5, 1, 0.3> pigment { rgb 0.85 } interior { ior 1.4 } finish { ambient 0 diffuse 0.8 subsurface { translucency 1 } } }
