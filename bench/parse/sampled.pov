// Functions and vectors sampled in loops: a height field's normals, a walk along a curve, integrals.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Height = function(x, z) { sin(3 * x) * cos(2 * z) + 0.25 * sin(11 * x + 5 * z) }
#declare Bell = function(x) { exp(-x * x) }
#declare Steps = 250;
#declare Normals = array[Steps][Steps];
#declare Step = 2 / Steps;
#for (I, 0, Steps - 1)
  #for (J, 0, Steps - 1)
    #local X = -1 + I * Step;
    #local Z = -1 + J * Step;
    #local Dx = (Height(X + Step, Z) - Height(X - Step, Z)) / (2 * Step);
    #local Dz = (Height(X, Z + Step) - Height(X, Z - Step)) / (2 * Step);
    #declare Normals[I][J] = vnormalize(<-Dx, 1, -Dz>);
  #end
#end
#declare Sum = <0, 0, 0>;
#for (I, 0, Steps - 1) #for (J, 0, Steps - 1) #declare Sum = Sum + Normals[I][J]; #end #end
#debug concat("total normals ", vstr(3, Sum, " ", 0, 3), "\n")

#declare Integral = 0;
#declare N = 200000;
#for (I, 0, N - 1)
  #declare Integral = Integral + Bell(-4 + 8 * (I + 0.5) / N) * 8 / N;
#end
#debug concat("total integral ", str(Integral, 0, 6), "\n")

#declare Place = <1, 0, 0>;
#declare Way = 0;
#for (I, 1, 200000)
  #local Last = Place;
  #local Turn = <0, 0.3, 0.2 * sin(I / 100)>;
  #declare Place = vrotate(Place, Turn) + 0.0001 * <sin(I), cos(I), 0>;
  #declare Way = Way + vlength(Place - Last);
  #if (vdot(Place, Place) > 1.5)
    #declare Place = vnormalize(Place);
  #end
#end
#debug concat("total way ", str(Way, 0, 4), "\n")

#declare Hue = rgb 0;
#for (I, 1, 150000)
  #local T = I / 150000;
  #declare Other = rgb <T, T * T, 1 - T>;
  #declare Hue = Hue * 0.99 + Other * 0.01;
  #declare Hue = <Hue.red, Hue.green, Hue.blue>;
#end
#debug concat("total hue ", vstr(3, <Hue.red, Hue.green, Hue.blue>, " ", 0, 3), "\n")

camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }
