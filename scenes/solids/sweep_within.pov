// What is seen within clear sphere sweeps of curved splines: surfaces where rays run along a segment, and flat ends.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 }
camera { location <0, 1.5, -7> look_at <0, 0.1, 0> angle 46 }
light_source { <-4, 9, -8> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
plane { y, -1.6 pigment { checker rgb 0.9 rgb 0.5 } }
#macro Bent() 6, <-1, -0.069, 0.379>, 0.181, <-0.6, 0.074, -0.409>, 0.264, <-0.2, 0.102, 0.314>, 0.315, <0.2, 0.285, 0.233>, 0.238, <0.6, 0.471, 0.208>, 0.329, <1, -0.441, 0.015>, 0.115 #end
#macro Short() 4, <-1, -0.3, 0.379>, 0.25, <-0.6, 0.074, -0.409>, 0.35, <-0.1, 0.102, 0.6>, 0.4, <0.5, 0.285, 0.233>, 0.3 #end
#declare Clear = pigment { rgbt <0.9, 0.6, 0.5, 0.6> }
sphere_sweep { b_spline Bent() pigment { Clear } scale 2 translate <-1.6, 1, 0> }
sphere_sweep { cubic_spline Bent() pigment { Clear } scale 1.5 translate <1.7, 1, 0> }
sphere_sweep { b_spline Short() pigment { rgbf <0.7, 0.9, 0.7, 0.9> } interior { ior 1.15 } scale 2 translate <-1.5, -0.9, 0> }
intersection { sphere_sweep { cubic_spline Short() scale 1.4 } plane { <0.2, 0.9, -0.3>, 0.3 } pigment { Clear } translate <0.6, -0.7, -0.5> }
sphere_sweep { cubic_spline Short() scale 1.4 clipped_by { plane { <0.3, 0.3, -0.9>, 0.1 } } pigment { rgb <0.4, 0.7, 0.9> } translate <2.6, -0.7, 0> }
