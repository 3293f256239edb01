// A knot from a file, with its facets as they are, and once more as a solid that is cut: POV-Ray has the same faces from loops.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
#default { finish { ambient 0 } }

camera { location <0, 5.6, -12> right 4/3*x look_at <0.1, 1.62, 0> angle 36 }
light_source { <-8, 13, -4> rgb <1.0, 0.93, 0.84>*1.25 area_light <3, 0, 0>, <0, 0, 3>, 5, 5 adaptive 1 circular orient }
light_source { <12, 5, -6> rgb <0.95, 0.45, 0.35>*0.35 }
light_source { <0, 6, 14> rgb <0.4, 0.7, 0.9>*0.6 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.02, 0.05, 0.08>] [0.4 rgb <0.10, 0.20, 0.25>] [0.8 rgb <0.9, 0.95, 1>] } } }
plane { y, 0 pigment { rgb <0.06, 0.16, 0.19> } finish { diffuse 0.8 specular 0.1 roughness 0.05 reflection { 0.02, 0.25 } } }

#ifdef (Whittle)
  #declare Knot = mesh { file "knot.obj" }
#else
  #macro Corner(I, J)                               // Corner J of ring I, of 5 and 84
    #local T = I*pi/42;
    #local D = vnormalize(<cos(T) + 4*cos(2*T), -sin(T) + 4*sin(2*T), -4.05*cos(3*T)>);
    #local U = vnormalize(vcross(D, z));
    (<sin(T) + 2*sin(2*T), cos(T) - 2*cos(2*T), -1.35*sin(3*T)> + 0.62*U*cos(2*pi*J/5 + 2*T) + 0.62*vcross(D, U)*sin(2*pi*J/5 + 2*T))
  #end
  #declare Knot = mesh {
    #for (I, 0, 83)
      #for (J, 0, 4)
        #local A = Corner(I, J); #local B = Corner(I, J + 1); #local C = Corner(I + 1, J + 1);
        triangle { A, B, C } triangle { A, C, Corner(I + 1, J) }
      #end
    #end
    inside_vector z
  }
#end
object {
  Knot rotate <62, 0, 0> rotate 20*y scale 0.62 translate <-1.7, 1.5, 0.4>
  pigment { gradient y scale 4 color_map { [0 rgb <0.75, 0.10, 0.12>] [0.45 rgb <0.95, 0.40, 0.12>] [0.8 rgb <0.98, 0.75, 0.25>] } }
  finish { diffuse 0.8 specular 0.4 roughness 0.015 reflection { 0.03, 0.2 } }
  interior { ior 1.5 }
}
difference {
  object { Knot pigment { rgb <0.12, 0.42, 0.50> } finish { diffuse 0.8 specular 0.4 roughness 0.015 } }
  plane { -z, 0 inverse translate -0.15*z pigment { rgb <0.98, 0.78, 0.45> } finish { diffuse 0.8 } }
  rotate <24, 25, 0> scale 0.5 translate <2.35, 1.85, 0.6>
}
