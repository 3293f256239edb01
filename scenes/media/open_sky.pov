// Media under an open sky.
// They scatter up to the farthest distance: points of the air lie 1e7 away from a lamp that stands among what casts
// shadows into it. A sun stands far away itself.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -9> look_at <0, 1.5, 0> angle 45 }
light_source { <6, 7, -4> rgb <1, 0.8, 0.6>*0.5 }
light_source { <-2e6, 1e6, 5e5> rgb <0.1, 0.15, 0.2> }
media { scattering { 1, 0.02 } samples 6 }
#declare R = seed(3);
union {
  #for (I, 0, 30)
    cone { <5*rand(R) - 2.5, 0, 3*rand(R) - 1>, 0.12, <5*rand(R) - 2.5, 2 + rand(R), 3*rand(R) - 1>, 0.02 }
  #end
  pigment { rgb <0.5, 0.35, 0.2> }
}
sphere { <0, 0.8, 0.6>, 0.8 pigment { rgbt <0.7, 0.9, 1, 0.6> } }
plane { y, 0 pigment { checker rgb 0.4 rgb 0.7 } }
