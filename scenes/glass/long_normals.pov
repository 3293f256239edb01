// Glass whose normals no_bump_scale leaves longer or shorter than 1: what such a normal bends is bent by its length, and again where it
// leaves through a plain one.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -6> look_at <0, 0, 0> angle 42 }
light_source { <-5, 9, -4> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.5> scale 0.4 } }

#macro Slab(X, Size)
  intersection {
    box { <X - 0.9, -10, -1.5>, <X + 0.9, 10, 1.5> pigment { rgbf 0.9 } }
    plane {
      y, 0.2
      texture {
        gradient y no_bump_scale
        texture_map { [0 pigment { rgbf 0.9 } normal { bumps 0.4 scale 0.3 }] [1 pigment { rgbf <1, 0.9, 0.8, 0.9> } normal { dents 0.6 scale 0.4 }] }
        scale Size
      }
    }
    plane { -y, 0.3 pigment { rgbf 0.9 } }
    interior { ior 1.4 }
  }
#end
Slab(-2, 0.7)
Slab(0, 1.05)
Slab(2, 1.6)
