#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
sphere { 0, 1
  pigment {
    gradient x  // here
    color_map { [0 rgb 0] [0.8 rgb 1] [0.5 rgb x] }
  }
}
