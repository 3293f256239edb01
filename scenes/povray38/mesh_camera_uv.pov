#version 3.8;
// A mesh camera by coordinates: the light on a ball, seen as a map of it; pixels are asked in their middles.
global_settings { assumed_gamma 1 }
#declare N = 24;
#macro OnBall(I, J) <sin(2*pi*I/N)*sin(pi*J/N), -cos(pi*J/N), -cos(2*pi*I/N)*sin(pi*J/N)> #end
#declare Ball = mesh {
  #for (J, 0, N - 1) #for (I, 0, N - 1)
    #local A = OnBall(I, J); #local B = OnBall(I + 1, J); #local C = OnBall(I, J + 1); #local D = OnBall(I + 1, J + 1);
    #if (J < N - 1)
      smooth_triangle { B, B, C, C, D, D uv_vectors <(I + 1)/N, J/N>, <I/N, (J + 1)/N>, <(I + 1)/N, (J + 1)/N> }
    #end
    #if (J > 0)
      smooth_triangle { A, A, C, C, B, B uv_vectors <I/N, J/N>, <I/N, (J + 1)/N>, <(I + 1)/N, J/N> }
    #end
  #end #end
}
camera { mesh_camera { 1 3 mesh { Ball } smooth } location <0, 0, 0.01> direction <0, 0, -1> }
object { Ball pigment { uv_mapping checker rgb <0.9, 0.6, 0.3> rgb 0.4 scale <0.125, 0.125, 1> } finish { ambient 0.1 diffuse 0.8 } }
torus { 1.4, 0.15 rotate 25*x pigment { rgb 1 } }
light_source { <-4, 5, -6>, rgb <1, 0.9, 0.8> }
light_source { <6, -2, 4>, rgb <0.2, 0.3, 0.6> }
