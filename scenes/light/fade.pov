// fade_distance and fade_power: light that weakens with distance.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4, -7> look_at <0, 0.2, 1> angle 50 }
light_source { <-2, 1.5, -0.5> rgb <1.6, 1.3, 0.8> fade_distance 1.5 fade_power 2 }
light_source { <2.2, 1, 0.5> rgb <0.6, 0.9, 1.5> fade_distance 1 fade_power 1 }

#for (I, 0, 5)
  sphere { <-2.5 + I, 0.35, 1 + 0.4*mod(I, 2)>, 0.35 pigment { rgb 0.9 } }
#end
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.02 } }
