#version 3.8;
// Colours by functions of the place: a component each, and one for what shines through.
global_settings { assumed_gamma 1 }
camera { location <1.6, 2, -4> look_at 0 angle 38 }
light_source { <-3, 6, -5> 1 }
plane { y, -1 pigment { checker rgb 0.2 rgb 0.8 scale 0.4 } }
box {
  -1, 1
  pigment {
    user_defined {
      function { 0.5 + 0.5*x },
      function { 0.5 + 0.5*sin(9*y + 3*x) },
      function { 0.5 - 0.5*z }
    }
  }
}
sphere {
  <1.4, -0.5, -1.2>, 0.5
  pigment {
    user_defined { function { 1 }, , function { 0.3 }, , function { select(sin(25*x)*sin(25*y), 1, 0) } }
    rotate 30*z
    translate <1.4, -0.5, -1.2>
  }
}
