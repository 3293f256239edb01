// A drop fell into milk: a blob of a hundred components, which run together where they come near each other.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
#default { finish { ambient 0 } }

camera { location <0, 2.7, -11> right 4/3*x look_at <0, 1.25, 0> angle 36 }
light_source { <-8, 12, 3> rgb <1.0, 0.95, 0.88>*1.05 area_light <4, 0, 4>, sqrt(32)*y, 6, 6 adaptive 1 circular orient }
light_source { <10, 7, -9> rgb <0.80, 0.82, 1.0>*0.60 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.50, 0.035, 0.05>] [0.30 rgb <0.16, 0.01, 0.025>] [0.6 rgb <0.9, 0.8, 0.8>] } } }

#declare Milk = texture {
  pigment { rgb <0.92, 0.90, 0.86> }
  finish { ambient <0.10, 0.07, 0.08> diffuse 0.80 specular 0.5 roughness 0.008 reflection { 0.01, 0.30 } }
}
#declare Dice = seed(4);
fog { fog_type 1 distance 60 rgb <0.40, 0.025, 0.04> }
#macro Around(R, H, A) <R*cos(A), H, R*sin(A)> #end

#declare Prongs = 16;
blob {
  threshold 0.5
  #for (I, 1, Prongs*2)
    #local A = I*pi/Prongs;
    cylinder { Around(1.62, -0.3, A), Around(1.78, 0.75, A), 0.42, 0.8 }       // the wall
    sphere { Around(1.5, -0.12, A), 0.75, 0.7 }                                // and its foot
  #end
  #for (I, 1, Prongs)
    #local A = (I + 0.35*(rand(Dice) - 0.5))*2*pi/Prongs;
    #local Tip = 1.25 + 0.55*rand(Dice);
    cylinder { Around(1.74, 0.6, A), Around(2.0 + 0.18*Tip, Tip, A), 0.27, 1.1 }
    sphere { Around(2.02 + 0.20*Tip, Tip + 0.12, A), 0.34, 1.1 }
    #if (rand(Dice) > 0.45)
      sphere { Around(2.3 + 0.35*Tip, Tip + 0.55 + 0.5*rand(Dice), A), 0.15 + 0.12*rand(Dice), 2 }
    #end
  #end
  // The column that comes back up in the middle, and the drop that leaves it.
  cylinder { <0, -0.6, 0>, <0, 0.9, 0>, 0.62, 0.9 }
  sphere { <0, 0.1, 0>, 0.95, 0.6 }
  sphere { <0, 1.05, 0>, 0.62, 1 }
  sphere { <0.03, 2.15, 0>, 0.52, 2 }
  texture { Milk }
}
// The pool: waves that run outwards and die away.
#declare Far = function(x, z) { sqrt(x*x + z*z) }
plane {
  y, 0
  texture { Milk normal { function { 0.5 + 0.5*sin(Far(x, z)*5.2)*exp(-0.22*Far(x, z))*min(1, max(0, Far(x, z) - 1.6)) } 0.22 } }
}
