// Stacks of glass lenses, each the intersection of two spheres, before a chart.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 }
camera { location <1.5, 1.4, -9> look_at <0, 0, 0> angle 36 }
light_source { <-5, 8, -8> rgb 1 }
background { rgb <0.7, 0.8, 0.9> }

#declare Lens = intersection {
  sphere { <0, 0, -1.7>, 1.9 }
  sphere { <0, 0, 1.7>, 1.9 }
  pigment { rgbf <0.97, 0.99, 0.98, 0.97> }
  finish { ambient 0 diffuse 0.02 specular 0.6 roughness 0.003 }
  interior { ior 1.3 }
}
#for (Row, -1, 1)
  #for (Column, -1, 1)
    #for (I, 0, 2)
      object { Lens translate <Column*1.75, Row*1.75, I*0.7 - 1> }
    #end
  #end
#end
plane { -z, -4 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.3, 0.35, 0.5> scale 0.5 } }
