// What a scene asks while it is read: where a ray meets an object, what an object holds, how far it reaches, what colour a
// pigment has somewhere, where a curve leads.
#version 3.7;
#include "functions.inc"
#include "transforms.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, 0.6, 0> angle 44 }
light_source { <-20, 30, -30> rgb 1 }
plane { y, -0.01 pigment { rgb <0.7, 0.75, 0.7> } }

#declare Bowl = difference { sphere { 0, 1.6 } sphere { 0.5 * y, 1.4 } cylinder { -2 * y, 2 * y, 0.4 } scale <1.3, 0.8, 1> rotate 10 * z translate <-1.8, 1.2, 0> }
object { Bowl pigment { rgb <0.8, 0.4, 0.2> } }

// Pins where rays from above land, along the normal there.
#declare Colors = pigment { bozo color_map { [0 rgb <0.1, 0.2, 0.9>] [0.5 rgb <0.9, 0.9, 0.2>] [1 rgb <0.2, 0.8, 0.3>] } scale 0.5 }
#declare I = 0;
#while (I < 60)
  #declare From = <-4 + mod(I, 10) * 0.5, 5, -1.5 + div(I, 10) * 0.6>;
  #declare Up = <0, 0, 0>;
  #declare Spot = trace(Bowl, From, -y, Up);
  #if (vlength(Up) > 0)
    #declare Tint = eval_pigment(Colors, Spot);
    cylinder { Spot, Spot + 0.4 * Up, 0.05 pigment { rgb <Tint.red, Tint.green, Tint.blue> } }
  #end
  #declare I = I + 1;
#end

// Beads inside of a lens.
#declare Lens = intersection { sphere { -0.7 * x, 1.4 } sphere { 0.7 * x, 1.4 } torus { 0.6, 0.45 rotate 90 * z } translate <2, 1.4, 0> }
#declare Low = min_extent(Lens);
#declare High = max_extent(Lens);
#declare A = 0;
#while (A <= 6)
  #declare B = 0;
  #while (B <= 8)
    #declare P = Low + (High - Low) * <A / 6, B / 8, 0.5>;
    #if (inside(Lens, P)) sphere { P, 0.1 pigment { rgb <0.3, 0.7, 0.9> } } #end
    #declare B = B + 1;
  #end
  #declare A = A + 1;
#end
box { Low, <High.x, Low.y + 0.05, High.z> pigment { rgb <0.5, 0.3, 0.6> } }

// A string of balls along a curve, and one moved by a transformation asked as a function.
#declare Way = spline { natural_spline 0, <-3.5, 0.2, -2.5> 0.3, <-1, 0.9, -3> 0.7, <1.5, 0.2, -2> 1, <3.4, 0.7, -2.6> }
#declare T = 0;
#while (T <= 1)
  sphere { Way(T), 0.12 pigment { rgb <0.9, 0.2, 0.3> } }
  sphere { Way(T, linear_spline) + 0.3 * y, 0.06 pigment { rgb 0.2 } }
  #declare T = T + 0.05;
#end
sphere { vtransform(<1, 0, 0>, transform { rotate 90 * z translate <0.2, 2, 1> }), 0.3 pigment { rgb <0.2, 0.8, 0.5> } }
