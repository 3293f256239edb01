// Shadows across light groups: every object casts them for every light, mirrors and glass show each object by its own lights, and a
// group's object that lets light through tints the light of the scene.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 3, -7> look_at <0, .2, 0> angle 48 }
light_source { <-4, 7, -6>, rgb <.6, .6, .5> spotlight radius 20 falloff 30 point_at 0 }
light_source { <5, 5, -2>, rgb <.3, .35, .5> }
plane { y, -1 pigment { checker rgb .9 rgb .5 } }
plane { -z, -5 pigment { rgb .4 } finish { reflection .5 } }
light_group {
    light_source { <2, 5, -5>, rgb <1, .3, .2> spotlight radius 8 falloff 14 tightness 10 point_at <-1.6, 0, 0> }
    light_source { <-6, 2, 0>, rgb <0, .4, .5> parallel point_at <-1.6, 0, 0> }
    sphere { <-1.6, 0, 0>, 1 pigment { rgbf <1, .8, .6, .5> } finish { phong .5 } interior { ior 1.4 } }
    box { <-3.4, -1, .6>, <-2.8, .6, 1.2> pigment { rgb 1 } no_shadow }
    global_lights on
}
light_group {
    light_source { <0, 6, 3>, rgb .9 fade_distance 4 fade_power 2 area_light 2*x, 2*z, 4, 4 adaptive 1 }
    light_source { <3, 1, -6>, rgb <.2, .4, 0> shadowless }
    cylinder { <1.2, -1, .4>, <1.2, .8, .4>, .6 pigment { rgb <.8, .9, 1> } finish { reflection .3 } }
    torus { .8, .2 rotate 70*x translate <2.7, 0, -.6> pigment { gradient y color_map { [0 rgbt <.2, .5, .9, .6>] [1 rgb 1] } scale .3 } double_illuminate }
    global_lights off
}
