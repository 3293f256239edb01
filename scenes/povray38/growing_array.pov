#version 3.8;
// A list of points that grows while they are found, with a gap where none was.
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at 0 angle 45 }
light_source { <-4, 8, -6>, 1 }

#declare Points = array;
#for (I, 0, 11)
    #if (mod(I, 4) != 3) #declare Points[I] = <2.5*cos(tau*I/12), 0.5*sin(3*tau*I/12), 2.5*sin(tau*I/12)>; #end
#end
#for (I, 0, dimension_size(Points, 1) - 1)
    #ifdef (Points[I]) sphere { Points[I], 0.5 pigment { rgb <0.9, 0.4 + 0.05*I, 0.2> } } #end
#end
