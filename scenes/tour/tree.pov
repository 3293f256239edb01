// A tree that a macro grows: each branch parts into branches that call the macro again. Evening, mist over a meadow.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
#default { finish { ambient 0 } }

camera { location <0, 1.5, -11> right 4/3*x look_at <0, 3.15, 0> angle 46 }
light_source { <-40, 16, 30> rgb <1.0, 0.62, 0.34>*2.2 parallel point_at 0 }
light_source { <20, 40, -50> rgb <0.80, 0.70, 0.75>*0.85 shadowless parallel point_at 0 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <1.10, 0.55, 0.28>] [0.12 rgb <0.92, 0.52, 0.36>] [0.4 rgb <0.38, 0.34, 0.50>] [1 rgb <0.06, 0.09, 0.26>] } }
}
sphere { <-112, 44, 460>, 20 pigment { rgb 1 } finish { diffuse 0 emission <1.6, 1.15, 0.7> } no_shadow no_reflection }
fog { fog_type 2 distance 22 fog_offset 0 fog_alt 0.55 rgb <0.98, 0.62, 0.42> }
plane { y, 0 pigment { bozo scale <2, 1, 1> turbulence 0.5 color_map { [0.3 rgb <0.10, 0.12, 0.03>] [0.7 rgb <0.24, 0.17, 0.05>] } } normal { bumps 1.2 scale 0.06 } }

#declare Dice = seed(29);
#declare Bark = texture { pigment { rgb <0.13, 0.085, 0.06> } finish { diffuse 0.8 } }
#macro Leaf(P)
  sphere {
    0, 1 scale <0.085, 0.02, 0.055> rotate <90*rand(Dice), 360*rand(Dice), 90*rand(Dice)> translate P
    pigment { rgb <0.95 - 0.3*rand(Dice), 0.10 + 0.38*rand(Dice), 0.02> } finish { diffuse 0.85 }
  }
#end
// From P along D, as long as L and as thick as R; Level branchings are to come.
#macro Branch(P, D, L, R, Level)
  #local Q = P + D*L;
  cone { P, R, Q, R*0.74 texture { Bark } }
  sphere { Q, R*0.74 texture { Bark } }
  #if (Level = 0)
    #for (I, 1, 8) Leaf(Q + 0.42*(<rand(Dice), rand(Dice), rand(Dice)> - 0.5)) #end
  #else
    #local Side = vnormalize(vcross(D, <rand(Dice) - 0.5, rand(Dice) - 0.5, rand(Dice) - 0.5>));
    #local Parts = (Level > 5 ? 3 : 2) + (rand(Dice) > 0.6);
    #for (I, 1, Parts)
      #local Out = vaxis_rotate(Side, D, 360*I/Parts + 50*rand(Dice));
      Branch(Q, vnormalize(D + Out*(0.45 + 0.35*rand(Dice)) + 0.10*y), L*(0.72 + 0.16*rand(Dice)), R*0.68, Level - 1)
    #end
  #end
#end
Branch(<0.4, -0.1, 0>, vnormalize(<0.06, 1, 0>), 1.45, 0.24, 7)
#for (I, 1, 260)                                     // Leaves that have fallen
  #local A = 2*pi*rand(Dice); #local F = 3.6*sqrt(rand(Dice));
  Leaf(<0.4 + F*cos(A)*1.3, 0.03, F*sin(A)>)
#end
