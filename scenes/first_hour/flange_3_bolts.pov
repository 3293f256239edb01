// First hour, flange, step 3: numbers get names, and a loop drills six holes for bolts.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 5, -7> look_at <0, 0.3, 0> angle 36 }
light_source { <-6, 9, -5> rgb 1 }
background { rgb <0.20, 0.23, 0.28> }

#declare Radius = 2;
#declare Thick = 0.4;
#declare Holes = 6;

difference {
  union {
    cylinder { <0, 0, 0>, <0, Thick, 0>, Radius }
    cylinder { <0, 0, 0>, <0, 1.2, 0>, 1 }
  }
  cylinder { <0, -1, 0>, <0, 2, 0>, 0.7 }
  #for (I, 1, Holes)
    cylinder {
      <1.5, -1, 0>, <1.5, 1, 0>, 0.2
      rotate <0, 360/Holes*I, 0>
    }
  #end
  pigment { rgb <0.75, 0.77, 0.80> }
}
