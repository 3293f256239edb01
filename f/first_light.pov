// First light: four spheres of four materials around a block of half-spaces opened by quadrics.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 }

camera { location <0.5, 4.3, -10.4> look_at <0.05, 0.78, 0> angle 36 }

light_source { <-9, 9, -4> rgb <1, 0.93, 0.80>*1.25 }            // key: a low sun on the left
light_source { <8, 6, -6> rgb <0.10, 0.14, 0.22> shadowless }    // fill: open sky
light_source { <3, 6, 12> rgb <0.24, 0.20, 0.16> }               // rim: from behind

// The sky, out of the picture but in every reflection.
background { rgb <0.10, 0.18, 0.32> }
plane {
  -z, -60
  pigment {
    gradient y
    color_map { [0 rgb <1.0, 0.82, 0.60>] [0.2 rgb <0.75, 0.72, 0.72>] [0.5 rgb <0.36, 0.50, 0.70>] [1 rgb <0.10, 0.18, 0.32>] }
    scale 60
    translate -1*y
  }
  finish { ambient 1 diffuse 0 }
}

plane {
  y, 0
  pigment { checker rgb <0.78, 0.70, 0.56>, rgb <0.085, 0.10, 0.13> scale 1.2 rotate 28*y translate 0.3*x }
  finish { diffuse 0.7 ambient 0.04 specular 0.1 roughness 0.02 reflection { 0.02, 0.16 falloff 3 } }
}

// textured: painted bands, a fine line pattern over them, a varnish with the highlight
sphere {
  0, 1
  texture {
    pigment {
      gradient y
      color_map {
        [0.14 rgb <0.05, 0.09, 0.20>] [0.14 rgb <0.80, 0.62, 0.34>]
        [0.20 rgb <0.80, 0.62, 0.34>] [0.20 rgb <0.55, 0.12, 0.06>]
        [0.44 rgb <0.78, 0.30, 0.10>] [0.44 rgb <0.90, 0.82, 0.66>]
        [0.60 rgb <0.90, 0.82, 0.66>] [0.60 rgb <0.06, 0.24, 0.30>]
        [0.84 rgb <0.05, 0.12, 0.22>] [0.84 rgb <0.80, 0.62, 0.34>]
      }
      scale 2
      translate -y
    }
    finish { diffuse 0.8 ambient 0.05 }
  }
  texture {
    pigment { gradient x color_map { [0.12 rgb <0.05, 0.06, 0.10>] [0.12 rgbt 1] } scale 0.25 }
    finish { diffuse 0.8 ambient 0.05 }
  }
  texture {
    pigment { rgbt 1 }
    finish { diffuse 0 ambient 0 specular 0.5 roughness 0.02 }
  }
  rotate <-12, 35, 22>
  translate <-2.55, 1, 0.9>
}

// glossy: deep red under a clear coat that mirrors more towards the rim
sphere {
  <2.45, 1.1, 1.3>, 1.1
  pigment { rgb <0.42, 0.025, 0.03> }
  finish { diffuse 0.7 ambient 0.03 specular 1 roughness 0.003 reflection { 0.07, 0.8 falloff 3 } }
}

// plastic: one soft highlight, colour to the edge
sphere {
  <-1.55, 0.52, -1.9>, 0.52
  pigment { rgb <0.03, 0.36, 0.30> }
  finish { diffuse 0.8 ambient 0.06 phong 0.6 phong_size 22 }
}

// glass
sphere {
  <1.15, 0.68, -1.75>, 0.68
  pigment { rgbf <0.94, 0.99, 0.97, 0.98> }
  finish { ambient 0 diffuse 0.01 specular 1 roughness 0.0015 reflection { 0.02, 1 fresnel } conserve_energy }
  interior { ior 1.5 }
}

// A cube without its corners, a hyperboloid through each pair of sides, a round hollow within.
#declare Brass = texture {
  pigment { rgb <0.78, 0.50, 0.16> }
  finish { diffuse 0.55 ambient 0.05 specular 0.8 roughness 0.015 metallic reflection { 0.25 metallic } }
}
#declare Lacquer = texture {
  pigment { rgb <0.70, 0.11, 0.05> }
  finish { diffuse 0.8 ambient 0.08 }
}
#declare Waist = quadric { <1, -0.35, 1>, <0, 0, 0>, <0, 0, 0>, -0.16 }
difference {
  intersection {
    box { -1, 1 }
    #for (I, -1, 1, 2) #for (J, -1, 1, 2) #for (K, -1, 1, 2)
      plane { <I, J, K>, 1.25 texture { Brass } }
    #end #end #end
  }
  union {
    object { Waist }
    object { Waist rotate 90*x }
    object { Waist rotate 90*z }
  }
  sphere { 0, 0.97 texture { Lacquer } }
  pigment { rgb <0.72, 0.75, 0.80> }
  finish { diffuse 0.75 ambient 0.05 specular 0.3 roughness 0.02 }
  rotate 28*y
  translate <-0.1, 1, 0.9>
}
// A brass bead in the hollow.
sphere { <-0.1, 1, 0.9>, 0.34 texture { Brass } }
