#version 3.8;
// 300 entries in a map, a comma behind the last number of a matrix, and `grey`.
global_settings { assumed_gamma 1 }
camera { location -4*z look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }
#declare Ink = rgb <0.2, 0.5, 0.9>;
box { -1, 1
    pigment {
        gradient y
        color_map { #for (I, 0, 299) [I/299 rgb <I/299, 0.5 + 0.4*sin(tau*I/60), Ink.grey>] #end }
        scale 2 translate -y
    }
    matrix <1, 0, 0, 0.2, 1, 0, 0, 0, 1, 0, 0, 0,>
    rotate <20, 30, 0>
}
