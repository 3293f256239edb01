// A mesh of smooth triangles made in loops: a patch of waves.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.6, -4.5> look_at <0, 0, 0> angle 46 }
light_source { <-4, 5, 3> rgb 1 }
light_source { <4, 6, -5> rgb 0.4 }
background { rgb <0.1, 0.1, 0.15> }

#macro Height(X, Z) (0.25*sin(3*X)*cos(2.5*Z)) #end
#macro Point(X, Z) <X, Height(X, Z), Z> #end
#macro Normal(X, Z) vnormalize(<-0.75*cos(3*X)*cos(2.5*Z), 1, 0.625*sin(3*X)*sin(2.5*Z)>) #end

#declare N = 12;
#declare D = 3/N;
mesh {
  #for (I, 0, N - 1)
    #for (K, 0, N - 1)
      #local X = -1.5 + I*D;
      #local Z = -1.5 + K*D;
      smooth_triangle { Point(X, Z), Normal(X, Z), Point(X + D, Z), Normal(X + D, Z), Point(X, Z + D), Normal(X, Z + D) }
      smooth_triangle { Point(X + D, Z), Normal(X + D, Z), Point(X + D, Z + D), Normal(X + D, Z + D), Point(X, Z + D), Normal(X, Z + D) }
    #end
  #end
  pigment { rgb <0.9, 0.7, 0.4> }
  finish { phong 0.5 phong_size 30 }
}
