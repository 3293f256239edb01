// Difference of an intersection of unions: four levels of nesting with every operator.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <3, 3, -4.5> look_at <0, 0, 0> angle 38 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.2, 0.2, 0.25> }

#declare Bar = cylinder { -1.4*x, 1.4*x, 0.25 };

difference {
  intersection {
    union {
      sphere { 0, 1.2 pigment { rgb <0.8, 0.5, 0.3> } }
      merge {
        box { <-1.5, -0.3, -0.3>, <1.5, 0.3, 0.3> pigment { rgb <0.4, 0.6, 0.8> } }
        box { <-0.3, -0.3, -1.5>, <0.3, 0.3, 1.5> pigment { rgb <0.4, 0.8, 0.6> } }
      }
    }
    box { <-1.3, -1, -1.3>, <1.3, 1, 1.3> pigment { rgb <0.9, 0.9, 0.5> } }
  }
  union {
    object { Bar }
    object { Bar rotate 90*y }
    difference {
      object { Bar scale <1, 1.8, 1.8> rotate 90*z }
      cylinder { -y, y, 0.3 }
    }
    pigment { rgb <0.7, 0.2, 0.3> }
  }
  finish { diffuse 0.75 ambient 0.1 }
}
