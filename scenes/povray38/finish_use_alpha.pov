#version 3.8;
// What is cut away by opacity has no highlight and no mirror either: lace on a ball of its own, and the same without use_alpha.
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.2, -5> look_at <0, -0.1, 0> angle 40 }
light_source { <-4, 6, -5> 1 }
plane { y, -1 pigment { checker rgb 0.25 rgb 0.75 } }
#macro Lace(X, On)
  sphere {
    <X, -0.1, 0>, 0.9
    pigment {
      radial frequency 8
      color_map { [0.5 rgb <0.7, 0.5, 0.2>] [0.5 rgbt <0.7, 0.5, 0.2, 0.85>] }
      translate X*x
    }
    finish { use_alpha On phong 0.8 phong_size 12 reflection 0.3 }
  }
#end
Lace(-1.1, on)
Lace(1.1, off)
