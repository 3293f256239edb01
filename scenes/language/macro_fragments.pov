// Macros that yield parts: a vector, a pigment, half an object, an object, a value through a parameter.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.5, -6> look_at <0, 0.2, 0> angle 50 }
light_source { <-3, 6, -5> rgb 1 }

#macro On_circle(Angle, Radius)
  <Radius*cos(radians(Angle)), 0, Radius*sin(radians(Angle))>
#end
#macro Paint(R, G, B) pigment { rgb <R, G, B> } #end
#macro Open_ball(Center) sphere { Center, 0.35 #end
#macro Next(Value) #declare Value = Value + 60; #end
#macro Post(Place, Tall) cylinder { Place, Place + Tall*y, 0.2 Paint(0.3, 0.5, 0.7) } #end

#declare Angle = 0;
#while (Angle < 360)
  Open_ball(On_circle(Angle, 1.6) + 0.8*y) Paint(Angle/360, 0.6, 0.3) }
  Post(On_circle(Angle, 1.6), 0.6)
  Next(Angle)
#end
plane { y, 0 Paint(0.6, 0.6, 0.6) }
