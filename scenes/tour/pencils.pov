// Pencils through a lens (focal blur), in the soft shadows of an area light; each is hexagon and cone, intersected.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
#default { finish { ambient 0 } }

camera {
  location <-3.3, 5.6, -8.6> right 4/3*x look_at <0.45, 0.30, -0.35> angle 37
  aperture 0.50 focal_point <0.2, 0.5, -1.9> blur_samples 37 variance 1/1000 confidence 0.9
}
light_source { <-3, 9, 7> rgb <1.0, 0.95, 0.88>*1.25 area_light <4, 0, 0>, <0, 0, 4>, 5, 5 adaptive 1 circular orient }
light_source { <-9, 5, -8> rgb <0.7, 0.8, 1.0>*0.30 shadowless }
plane { y, 0 pigment { rgb <0.80, 0.79, 0.75> } finish { diffuse 0.75 } }

// A pencil of radius 0.5 that lies on its flat side, its tip at the origin, along z.
#declare Hexagon = intersection { #for (A, 0, 300, 60) plane { y, 0.433 rotate A*z } #end }
#macro Pencil(C, Long)
  union {
    intersection {                                   // Where the cone leaves the hexagon the paint ends in scallops.
      object { Hexagon pigment { rgb C } finish { diffuse 0.75 specular 0.5 roughness 0.02 reflection { 0.02, 0.10 } } }
      plane { z, Long pigment { rgb <0.80, 0.62, 0.42> } }
      cone {
        <0, 0, 0.28>, 0.09, <0, 0, Long + 0.3>, 0.09 + (Long + 0.02)*0.30
        pigment { wood turbulence 0.05 scale <0.07, 0.07, 0.5> rotate <2, 2, 0> translate <1.9, 1.3, 0> color_map { [0 rgb <0.80, 0.60, 0.38>] [1 rgb <0.66, 0.45, 0.27>] } }
        finish { diffuse 0.8 }
      }
    }
    intersection {
      cone { 0, 0.025, <0, 0, 0.29>, 0.095 }
      sphere { <0, 0, 0.3>, 0.3 }
      pigment { rgb C*0.8 } finish { diffuse 0.8 specular 0.15 }
    }
    cylinder { <0, 0, Long - 0.01>, <0, 0, Long + 0.01>, 0.11 pigment { rgb C*0.7 } }
    translate 0.433*y
  }
#end

// Colours go once around the wheel; the pencils stand in a fan, tips along an arc.
#macro Hue(T) <pow(0.5 + 0.5*cos(2*pi*T), 1.5), pow(0.5 + 0.5*cos(2*pi*(T - 1/3)), 1.5)*0.8, pow(0.5 + 0.5*cos(2*pi*(T - 2/3)), 1.5)> #end
#declare Many = 13;
#for (I, 0, Many - 1)
  object {
    Pencil(Hue(I/Many)*0.75 + 0.02, 7)
    translate <0, 0, -7.6> rotate (I - (Many - 1)/2)*-7.9*y translate <0.6, 0, 5.6>
  }
#end
