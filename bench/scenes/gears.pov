// A field of 64 gears: a toothed union, drilled and grooved.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 14, -16> look_at <0, 0, -0.5> angle 50 }
light_source { <-15, 25, -10> rgb 1 }
background { rgb <0.1, 0.12, 0.15> }

#declare Gear = difference {
  union {
    cylinder { -0.2*y, 0.2*y, 0.8 }
    #for (I, 0, 15)
      box { <0.75, -0.2, -0.08>, <1.0, 0.2, 0.08> rotate 22.5*I*y }
    #end
  }
  cylinder { -y, y, 0.2 }
  #for (I, 0, 5)
    cylinder { <0.5, -1, 0>, <0.5, 1, 0>, 0.13 rotate 60*I*y }
  #end
  torus { 0.7, 0.05 translate 0.2*y }
}
#for (X, 0, 7)
  #for (Z, 0, 7)
    object {
      Gear
      pigment { rgb <0.8, 0.6 + 0.2*sin(X + Z), 0.35 + 0.2*cos(X*Z)> }
      finish { phong 0.6 metallic }
      rotate <15*sin(X*Z), 11*(X + Z), 12*cos(X + 2*Z)>
      translate <(X - 3.5)*2.1, 0, (Z - 3.5)*2.1>
    }
  #end
#end
plane { y, -0.8 pigment { rgb 0.5 } }
