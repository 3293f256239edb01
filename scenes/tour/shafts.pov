// Sun through a rose window: dust (a scattering medium) shows the shafts, stone hides the rest.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
#default { finish { ambient 0 } }

camera { location <-2.7, 2.0, -11.8> right 4/3*x look_at <0.9, 3.85, 2> angle 56 }
#declare Sun = <-15, 20, 34>;
light_source { Sun rgb <1.0, 0.76, 0.44>*6.5 parallel point_at 0 }
light_source { <3, 6, -9> rgb <0.68, 0.55, 0.46>*0.75 fade_distance 8 fade_power 1 media_interaction off shadowless }
sky_sphere { pigment { rgb <1.6, 1.35, 1.0> } }

#declare Stone = texture { pigment { granite scale 3 color_map { [0 rgb <0.36, 0.32, 0.28>] [1 rgb <0.56, 0.51, 0.45>] } } normal { granite 0.15 scale 2 } finish { diffuse 0.75 } }
// The rose: a round hole in the wall, and in it a tracery of eight petals around an eye.
#declare Petals = union {
  cylinder { -z, z, 0.55 }
  #for (A, 0, 315, 45)
    union { cylinder { <1.45, 0, -1>, <1.45, 0, 1>, 0.50 } cylinder { <2.08, 0, -1>, <2.08, 0, 1>, 0.22 rotate 22.5*z } rotate A*z }
  #end
}
difference {
  box { <-6, 0, 5>, <6, 11, 5.7> }
  object { Petals translate <0, 6.0, 5.3> }
  #for (X, -3, 3, 3) union { box { <-0.5, 0.9, 4>, <0.5, 2.3, 7> } cylinder { <0, 2.3, 4>, <0, 2.3, 7>, 0.5 } translate X*x } #end
  texture { Stone }
}
difference {
  box { <-7, -1, -14>, <7, 12, 6> }
  box { <-6, 0, -13>, <6, 11, 7> }
  texture { Stone }
}
box { <-6, 0, -13>, <6, 0.01, 5> pigment { checker rgb <0.34, 0.27, 0.22>, rgb <0.16, 0.13, 0.12> scale 1.0 rotate 45*y } finish { diffuse 0.7 reflection { 0.03, 0.35 } } }
#for (Z, -8, 2, 5)
  #for (X, -4.4, 4.4, 8.8)
    union {
      #for (A, 0, 270, 90) cylinder { <0.34, 0, 0>, <0.34, 11, 0>, 0.26 rotate (A + 45)*y } #end
      cylinder { 0, 11*y, 0.42 } box { <-0.8, 0, -0.8>, <0.8, 0.5, 0.8> } box { <-0.65, 0.5, -0.65>, <0.65, 0.75, 0.65> }
      texture { Stone } translate <X, 0, Z>
    }
  #end
#end
box {
  <-6.1, -0.1, -13.1>, <6.1, 11.1, 5.6> hollow pigment { rgbt 1 }
  interior { media { scattering { 1, <0.060, 0.054, 0.046> extinction 0.5 } method 3 intervals 1 samples 60 } }
}
