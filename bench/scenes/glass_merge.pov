// Merged glass: chains of spheres and rings without inner surfaces.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 16 }
camera { location <0, 3, -9> look_at <0, 0.2, 0> angle 42 }
light_source { <-6, 10, -8> rgb 1 }
background { rgb <0.65, 0.75, 0.85> }

#declare Chain = merge {
  #for (I, 0, 11)
    sphere { <0.75*cos(I*pi/6), 0, 0.75*sin(I*pi/6)>, 0.26 }
  #end
  cylinder { -0.25*y, 0.25*y, 0.3 }
  torus { 0.55, 0.12 }
  box { <-0.7, -0.06, -0.06>, <0.7, 0.06, 0.06> }
}
#for (X, -1, 1)
  #for (Y, -1, 1)
    object {
      Chain
      pigment { rgbf <0.95, 0.99, 0.97, 0.95> }
      finish { ambient 0 diffuse 0.03 specular 0.6 reflection 0.05 }
      interior { ior 1.2 }
      rotate <60 + 20*X, 0, 30*Y>
      translate <2.3*X, 1.3*Y + 0.6, Y>
    }
  #end
#end
plane { y, -1.8 pigment { checker rgb 0.9, rgb <0.4, 0.5, 0.6> } }
