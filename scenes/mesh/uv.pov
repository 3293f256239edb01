// Coordinates of a surface over a mesh: by vertex, by indices of their own, and inside `mesh`; smooth and flat.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.2, -4.5> look_at <0, 0.1, 0> angle 46 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.15, 0.2, 0.3> }

#declare Boards = pigment {
  checker rgb <0.9, 0.8, 0.5>, rgb <0.4, 0.15, 0.1>
  scale 0.125
}
#declare N = 12;
#declare P = array[N + 1][N + 1]
#for (I, 0, N) #for (J, 0, N)
  #declare P[I][J] = <I/N - 0.5, 0.12*sin(I*0.9)*cos(J*0.8), J/N - 0.5>*2;
#end #end
mesh2 {
  vertex_vectors { (N + 1)*(N + 1) #for (I, 0, N) #for (J, 0, N) , P[I][J] #end #end }
  normal_vectors { (N + 1)*(N + 1) #for (I, 0, N) #for (J, 0, N)
    , <-0.108*N/2*cos(I*0.9)*cos(J*0.8)*2, 1, 0.096*N/2*sin(I*0.9)*sin(J*0.8)*2> #end #end }
  uv_vectors { (N + 1)*(N + 1) #for (I, 0, N) #for (J, 0, N) , <I/N, J/N> #end #end }
  face_indices { 2*N*N #for (I, 0, N - 1) #for (J, 0, N - 1)
    , <I*(N + 1) + J, I*(N + 1) + J + 1, (I + 1)*(N + 1) + J>
    , <I*(N + 1) + J + 1, (I + 1)*(N + 1) + J + 1, (I + 1)*(N + 1) + J> #end #end }
  uv_mapping
  texture { pigment { Boards } finish { phong 0.4 } }
  rotate 25*y
  translate -1.1*x
}
mesh2 {
  vertex_vectors { 4, <-0.6, -0.5, 0>, <0.6, -0.5, 0>, <0.6, 0.9, 0.2>, <-0.6, 0.9, 0.2> }
  uv_vectors { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0.5, 3> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
  uv_indices { 2, <0, 1, 2>, <0, 4, 3> }
  texture { uv_mapping pigment { Boards } }
  translate <1, 0, 0.4>
}
mesh {
  triangle { <0, 0, 0>, <1.2, 0, 0>, <0.3, 0, 1> uv_vectors <0, 0>, <2, 0>, <0.5, 1> }
  triangle { <1.2, 0, 0>, <1.5, 0.2, 1>, <0.3, 0, 1> uv_vectors <2, 0>, <2.5, 1>, <0.5, 1> }
  uv_mapping pigment { gradient x color_map { [0 rgb <0.2, 0.6, 0.9>][1 rgb 1] } }
  translate <0.2, -0.6, -1.3>
}
