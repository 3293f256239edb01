// Spotlights: a soft falloff, a sharp rim and a tight beam.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4, -7> look_at <0, 0.3, 0> angle 48 }
light_source { <-2, 5, -1> rgb <1, 0.9, 0.6> spotlight point_at <-2, 0, 0> radius 5 falloff 20 }
light_source { <0.2, 5, -1> rgb <0.6, 0.9, 1> spotlight point_at <0.3, 0, 0> radius 12 falloff 12.5 }
light_source { <2, 5, -2> rgb <1, 0.7, 0.9> spotlight point_at <2.2, 0, 0> radius 4 falloff 25 tightness 20 }

sphere { <-2, 0.4, 0>, 0.4 pigment { rgb 0.9 } }
box { <0.1, 0, -0.2>, <0.5, 0.6, 0.2> pigment { rgb 0.9 } }
cone { <2.2, 0, 0>, 0.4, <2.2, 0.9, 0>, 0 pigment { rgb 0.9 } }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 } }
