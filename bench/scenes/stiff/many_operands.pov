// A slab that a hundred thousand small balls are taken from.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> look_at <0, 0, -.5> }
light_source { <8, 10, -6> rgb 1 }
#declare Random = seed(4);
difference {
  box { <-6, -1, -6>, <6, 0, 6> }
  #for (I, 1, 100000)
    sphere { <12*rand(Random) - 6, .005, 12*rand(Random) - 6>, .01 + .02*rand(Random) }
  #end
  pigment { rgb <.75, .7, .6> }
}
