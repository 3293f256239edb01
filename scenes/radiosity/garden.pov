// Sun and sky with all defaults: a mirror, a pane, layers, and what hides from gathered light.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { } }
camera { location <1.5, 2.2, -5> look_at <0, 0.7, 0> angle 48 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.75, 0.7>] [0.5 rgb <0.35, 0.55, 0.9>] } } }
light_source { <40, 50, -25>, rgb <0.9, 0.85, 0.75> area_light x * 4, y * 4, 3, 3 }
plane {
  y, 0
  texture { pigment { checker rgb <0.35, 0.5, 0.25>, rgb <0.65, 0.6, 0.45> scale 0.7 } finish { diffuse 0.8 } }
  texture { pigment { bozo color_map { [0.4 rgbt 1] [0.7 rgbt <0.3, 0.25, 0.2, 0.4>] } scale 0.5 } finish { diffuse 0.7 } }
}
sphere { <-1.1, 0.8, 0.4>, 0.8 pigment { rgb 0.9 } finish { diffuse 0.2 reflection 0.7 } }
box { <0.2, 0, -0.3>, <1, 1.2, 0.5> rotate y * 25 pigment { rgb <0.85, 0.3, 0.2> } finish { diffuse 0.8 phong 0.4 } }
box { <-0.6, 0, -1.4>, <0.5, 0.9, -1.38> hollow pigment { rgbf <0.8, 0.9, 1, 0.8> } finish { diffuse 0.3 } interior { ior 1.2 } }
box { <-3, 0, 2>, <3, 1.8, 2.1> pigment { rgb <0.9, 0.9, 0.85> } finish { diffuse 0.8 } no_radiosity }
