// As starts_in_clipped, for rays that each start at a place of their own: those at the edge start outside of the second ball.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -4> look_at <0.3, 0.1, 0> angle 50 }
background { rgb <0.4, 0.6, 0.9> }
#default { finish { ambient 1 diffuse 0 } }
plane { -z, -6 pigment { checker rgb <0.8, 0.3, 0.2> rgb <0.9, 0.9, 0.7> } }
union {
  sphere { <0, 0, -3>, 3.2 clipped_by { plane { -z, 1.5 } } }
  sphere { <0.8, 0, -4>, 2.5 }
  pigment { rgbt <0.9, 1, 0.9, 0.8> } interior { ior 1.3 }
}
