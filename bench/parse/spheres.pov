// A million spheres in a loop.
#version 3.7;
global_settings { assumed_gamma 1 }
#for (I, 0, 999999)
  sphere { <mod(I, 100), mod(div(I, 100), 100), div(I, 10000)>, 0.4 }
#end
#debug concat("total ", str(I, 0, 0), "\n")
camera { location <-40, 80, -120> look_at 50 }
light_source { <100, 200, -200>, rgb 1 }
