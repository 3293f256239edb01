// A row of things before and behind the plane of focus.
// bench: +W320 +H240 -A
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <-1.5, 2.2, -7> look_at <0, 0.6, 1> angle 40
  focal_point <0, 0.6, 0> aperture 0.45 blur_samples 37 confidence 0.95 variance 1/10000
}
light_source { <-6, 9, -7> rgb 0.95 }
background { rgb <0.6, 0.7, 0.8> }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.25, 0.35, 0.45> scale 0.5 } finish { reflection 0.1 } }
#for (I, 0, 8)
  union {
    sphere { 1.1*y, 0.35 }
    cone { 0, 0.45, 0.9*y, 0.15 }
    torus { 0.4, 0.08 translate 0.08*y }
    pigment { rgb <0.9 - 0.07*I, 0.3 + 0.04*I, 0.2 + 0.08*I> }
    finish { specular 0.5 }
    translate <0.55*I - 2.2, 0, 1.2*I - 3.6>
  }
#end
