// First hour, flange, step 5: a macro makes a flange of any size, and a plate of any number of holes.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 6, -9> look_at <0, 0.4, 0> angle 40 }
light_source { <-6, 9, -5> rgb 1 }
light_source { <8, 5, -3> rgb 0.4 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.30, 0.28, 0.25>] [0.3 rgb <0.16, 0.20, 0.28>] [1 rgb <0.75, 0.85, 1>] } } }

#declare Steel = texture {
  pigment { rgb <0.55, 0.58, 0.64> }
  finish { ambient 0 diffuse 0.45 specular 0.8 roughness 0.02 metallic reflection { 0.35 metallic } }
}

#macro Flange(Radius, Neck, Height, Holes)
  difference {
    union {
      cylinder { <0, 0, 0>, <0, 0.3, 0>, Radius }
      cylinder { <0, 0, 0>, <0, Height, 0>, Neck }
    }
    cylinder { <0, -1, 0>, <0, Height + 1, 0>, 0.7*Neck }
    #for (I, 1, Holes)
      cylinder {
        <(Radius + Neck)/2, -1, 0>, <(Radius + Neck)/2, 1, 0>, 0.25*(Radius - Neck)
        rotate <0, 360/Holes*I, 0>
      }
    #end
    texture { Steel }
  }
#end

object { Flange(2, 1, 1.2, 6) translate <-1.6, 0, 1> }
object { Flange(1.5, 0.6, 2.2, 8) translate <2.1, 0, 0.6> }
object { Flange(1, 0.5, 0.5, 4) rotate <-50, 0, 0> translate <0.6, 0.8, -2> }
plane { y, -0.001 pigment { rgb <0.35, 0.38, 0.42> } }
