// A camera made of a mesh: a bent sheet of triangles, each looking along its normal, shown by texture coordinates.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Columns = 16;
#declare Rows = 12;
#macro Corner(C, R)
    #local A = radians(70*(C/Columns - 0.5));
    <3*sin(A), 2.4*(R/Rows - 0.5) + 1, -7 + 3*cos(A)>
#end
#declare Sheet = mesh {
    #for (R, 0, Rows - 1)
        #for (C, 0, Columns - 1)
            #local U = C/Columns;  #local V = R/Rows;  #local S = 1/Columns;  #local T = 1/Rows;
            triangle { Corner(C, R), Corner(C, R + 1), Corner(C + 1, R) uv_vectors <U, V>, <U, V + T>, <U + S, V> }
            triangle { Corner(C + 1, R), Corner(C, R + 1), Corner(C + 1, R + 1) uv_vectors <U + S, V>, <U, V + T>, <U + S, V + T> }
        #end
    #end
}
camera { mesh_camera { 1 3 mesh { Sheet } } location <0, 0, 0.05> }
light_source { <-6, 9, -9> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.4, 0.5, 0.4> } finish { diffuse 0.7 ambient 0.2 } }
#for (K, -4, 4)
    sphere { <1.6*K, 0.8, 1 + 0.4*K*K>, 0.7 pigment { rgb <0.9, 0.5 + 0.1*K, 0.5 - 0.1*K> } finish { phong 0.7 } }
#end
