// A ball of coloured glass gathers light on a floor and on a wall; its shadow is dark where photons bring the light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { spacing 0.05 } }
camera { location <0, 3.5, -6> look_at <0.2, 0.8, 0.5> angle 42 }
light_source { <5, 9, -2> rgb 1.2 photons { refraction on reflection off } }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.6 } finish { ambient 0.05 diffuse 0.7 phong 0.3 phong_size 20 } }
plane { x, -2.2 pigment { rgb <0.8, 0.75, 0.7> } finish { ambient 0.05 diffuse 0.7 brilliance 1.5 } }
sphere { <0, 1.1, 0>, 1
  pigment { rgbf <0.95, 0.85, 0.6, 0.9> } finish { ambient 0 diffuse 0.05 specular 0.5 conserve_energy reflection { 0.05, 0.9 fresnel } }
  interior { ior 1.5 fade_distance 1.5 fade_power 1 fade_color <0.9, 0.6, 0.3> }
  photons { target refraction on reflection off collect off } }
