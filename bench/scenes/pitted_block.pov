// A block minus 500 spheres.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2.6, 2.4, -4> look_at <0, -0.1, 0> angle 40 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.15, 0.18, 0.22> }

difference {
  box { -1, 1 pigment { rgb <0.85, 0.75, 0.5> } }
  union {
    #for (I, 0, 499)
      // A spiral over the faces: even, without chance.
      #local Y = 1 - (2*I + 1)/500;
      #local R = sqrt(1 - Y*Y);
      #local P = <R*cos(I*2.39996323), Y, R*sin(I*2.39996323)>;
      #local Largest = max(abs(P.x), abs(P.y), abs(P.z));
      sphere { P/Largest, 0.06 + 0.03*sin(I) }
    #end
    pigment { rgb <0.6, 0.25, 0.2> }
  }
  finish { phong 0.4 }
}
plane { y, -1 pigment { rgb 0.6 } }
