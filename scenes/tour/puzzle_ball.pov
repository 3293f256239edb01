// Puzzle balls: shells that turn within each other, each a sphere less a sphere less twelve cones, and one ball cut open.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#default { finish { ambient 0 diffuse 0.75 } }

camera { location <0, 4.2, -10> right 4/3*x look_at <0.35, 1.35, 0> angle 34.5 }
light_source { <-9, 14, -7> rgb <1, 0.92, 0.80>*1.25 area_light <3, 0, 2>, <0, 3, -2>, 5, 5 adaptive 1 circular orient }
light_source { <12, 6, -4> rgb <0.45, 0.62, 0.80>*0.40 }
light_source { <-2, 8, 12> rgb <0.90, 0.75, 0.60>*0.45 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.03, 0.05, 0.06>] [0.45 rgb <0.10, 0.14, 0.15>] [1 rgb <0.9, 0.95, 1>] } } }
plane { y, 0 pigment { rgb <0.055, 0.095, 0.105> } finish { diffuse 0.8 specular 0.12 roughness 0.05 reflection { 0.02, 0.25 } } }

#declare Gold = texture {
  pigment { rgb <1.0, 0.66, 0.25> }
  finish { diffuse 0.45 metallic specular 0.7 roughness 0.03 reflection { 0.35 metallic } }
}
#macro Lacquer(C) texture { pigment { rgb C } finish { specular 0.5 roughness 0.012 reflection { 0.02, 0.3 fresnel on } } } #end

// A shell of outer radius R, as thick as T, whose twelve holes stand in the corners of an icosahedron.
#declare Tall = (1 + sqrt(5))/2;
#macro Shell(R, T, Turn, C)
  difference {
    sphere { 0, R Lacquer(C) }
    sphere { 0, R - T texture { Gold } }
    #for (Swap, 0, 2)
      #for (Corner, 0, 3)
        #local D = vnormalize(<0, 1 - 2*mod(Corner, 2), (1 - 2*int(Corner/2))*Tall>);
        #local D = (Swap = 0 ? D : (Swap = 1 ? <D.z, D.x, D.y> : <D.y, D.z, D.x>));
        cone { 0, 0, D*R*1.1, R*0.40 texture { Gold } }
      #end
    #end
    rotate Turn
    interior { ior 1.5 }
  }
#end

#declare Ball = union {
  Shell(1.50, 0.16, <8, 10, 0>, <0.62, 0.045, 0.03>)
  Shell(1.15, 0.12, <40, 25, 10>, <0.80, 0.68, 0.50>)
  Shell(0.86, 0.10, <10, -20, 70>, <0.03, 0.22, 0.24>)
  sphere { 0, 0.42 texture { Gold } }
}
#declare Ring = difference { cylinder { 0, 0.32*y, 0.80 } sphere { 1.60*y, 1.50 } texture { Gold } }
union { object { Ball translate 1.60*y } object { Ring } rotate 20*y translate <-1.15, 0, 0> }

// Another, cut in half by a plane, and skins alone where only clipped_by cuts.
#declare Half = plane { -z, 0 rotate <0, 12, 0> }
union {
  intersection { Shell(1.50, 0.16, <30, 10, 20>, <0.80, 0.68, 0.50>) object { Half texture { Gold } } }
  intersection { Shell(1.15, 0.12, <0, 25, 10>, <0.03, 0.22, 0.24>) object { Half texture { Gold } } }
  object { Shell(0.86, 0.10, <10, -20, 70>, <0.62, 0.045, 0.03>) clipped_by { plane { -y, 0 rotate -25*z } } }
  sphere { 0, 0.42 texture { Gold } }
  rotate <4, 0, -8> translate <2.15, 1.5, 1.2>
}
