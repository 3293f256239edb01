// A light within a hollow lantern, and looks_like giving a light a body.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -6> look_at <0, 0.5, 0> angle 48 }
light_source { <0, 0.7, 0> rgb <1, 0.9, 0.7> }
light_source { 0 rgb <0.3, 0.4, 0.7> looks_like { sphere { 0, 0.2 pigment { rgb <0.6, 0.7, 1> } finish { emission 0.8 diffuse 0 } } } translate <1.8, 1.2, -0.5> }

difference {
  box { <-0.6, 0, -0.6>, <0.6, 1.4, 0.6> }
  box { <-0.5, 0.1, -0.5>, <0.5, 1.3, 0.5> }
  cylinder { <-2, 0.7, 0>, <2, 0.7, 0>, 0.35 }
  cylinder { <0, 0.7, -2>, <0, 0.7, 2>, 0.35 }
  pigment { rgb <0.6, 0.45, 0.3> }
}
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 } }
