// Objects of a light_group go by its own lights, those of a group within by that one's; all objects cast shadows, and the groups'
// lights reach nothing else. The group on the right takes the lights of the whole scene too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at 0 angle 50 }
background { rgb <0.3, 0.5, 0.8> }
light_source { <5, 9, -5> rgb <0.2, 0.6, 0.2> }
plane { y, -1 pigment { checker rgb 1, rgb 0.5 } }
sphere { <-3.2, 2, -1.6>, 0.4 pigment { rgb 1 } }
light_group {
    light_source { <-6, 9, -6> rgb <1, 0.2, 0.2> }
    sphere { <-2.5, 0, 0>, 1 pigment { rgb 1 } finish { phong 0.6 } }
    union {
        box { <-1.2, -0.5, -1>, <-0.2, 0.5, 0> }
        cylinder { <0.4, -1, 0>, <0.4, 1, 0>, 0.3 }
        light_source { <0, 2, -6> rgb 0.2 }     // deeper than the group's operands: a light of the whole scene
        pigment { rgb 1 }
    }
    light_group {
        light_source { <0, 9, 0> rgb <0.2, 0.2, 1> }
        sphere { <-1, 1.2, 1>, 0.7 pigment { bozo color_map { [0 rgb 1] [1 rgb 0.5] } } }
        global_lights
    }
    global_lights off
}
#declare Group = light_group {
    light_source { <3, 6, -6> rgb <0.8, 0.2, 0.2> area_light x, z, 3, 3 adaptive 1 }
    difference { sphere { 0, 0.8 } box { <-1, 0, -1>, 1 } pigment { rgb 1 } rotate -30*x }
    torus { 0.9, 0.15 pigment { rgbf <1, 1, 1, 0.4> } finish { reflection 0.2 } }
    global_lights
}
light_group { Group translate 2.3*x }
light_group { Group scale 0.6 translate <2.2, 0, -2.5> }
