// A ball cut from a gyroid, the surface that parts space into two mazes; a lamp burns in its middle.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
#default { finish { ambient 0 } }

camera { location <0, 2.2, -13> right 4/3*x look_at <0, -0.12, 0> angle 40 }
light_source { <-12, 14, -12> rgb <0.75, 0.85, 1.00>*0.9 area_light 3*x, 3*y, 4, 4 adaptive 1 circular orient }
light_source { <14, 3, 6> rgb <1.0, 0.45, 0.35>*0.7 }
light_source { 0 rgb <1.0, 0.35, 0.18>*0.9 fade_distance 2 fade_power 2 shadowless }
light_source { 0 rgb <1.0, 0.62, 0.28>*2.6 fade_distance 1.6 fade_power 2 }
sphere { 0, 0.30 pigment { rgb 1 } finish { diffuse 0 emission <1.6, 1.15, 0.6> } no_shadow }

#declare Wave = 2.6;
#declare Gyroid = function(x, y, z) { sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x) }
isosurface {
  // Between two sheets: thin at the rim, thicker inside.
  function { abs(Gyroid(x*Wave + pi/4, y*Wave + pi/4, z*Wave + pi/4)) - 0.34 + 0.045*(x*x + y*y + z*z)/2 }
  contained_by { sphere { 0, 2.9 } }
  max_gradient 6 accuracy 0.0005 all_intersections
  pigment {
    spherical scale 2.95
    color_map { [0 rgb <0.95, 0.80, 0.62>] [0.05 rgb <0.90, 0.42, 0.26>] [0.30 rgb <0.70, 0.12, 0.24>] [0.7 rgb <0.9, 0.45, 0.2>] }
  }
  finish { diffuse 0.8 specular 0.35 roughness 0.02 }
  rotate <20, 28, 8>
}
light_source { <3, 4, -14> rgb <0.5, 0.4, 0.9>*0.16 shadowless }
plane { y, -2.92 pigment { rgb <0.05, 0.045, 0.085> } finish { diffuse 0.8 reflection { 0.03, 0.35 } } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.055, 0.04, 0.095>] [0.35 rgb <0.02, 0.015, 0.05>] [1 rgb <0.01, 0.01, 0.03>] } } }
