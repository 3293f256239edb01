// A hundred thousand unions of a box and two triangles, each with a pigment of its own and a place.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Seed = seed(7);
#declare I = 0;
#while (I < 100000)
  union {
    box { <-0.4, 0, -0.4>, <0.4, 0.5 + rand(Seed), 0.4> }
    triangle { <-0.5, 1.5, -0.5>, <0.5, 1.5, -0.5>, <0, 2, 0> }
    triangle { <-0.5, 1.5, 0.5>, <0.5, 1.5, 0.5>, <0, 2, 0> pigment { rgb <1, 0, 0> } }
    pigment { rgb <rand(Seed), rand(Seed), rand(Seed)> }
    rotate y*360*rand(Seed)
    translate <mod(I, 300), 0, div(I, 300)>
  }
  #declare I = I + 1;
#end
#debug concat("total ", str(I, 0, 0), "\n")
camera { location <150, 60, -100> look_at <150, 0, 100> }
light_source { <100, 200, -200>, rgb 1 }
