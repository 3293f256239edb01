// A lens that dips below the floor and into glass: what a ray starts inside of is asked for each. Fog stays away from the rays of
// a pixel that come after one from inside something solid, until they leave something solid.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 0, -5> look_at 0 angle 50 aperture 2 focal_point 0 blur_samples 19 }
light_source { <-5, 9, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
fog { distance 8 rgb <0.9, 0.6, 0.8> }
plane { y, -0.3 pigment { checker rgb 1, rgb 0.3 } }
sphere { <-0.8, 0.2, 0>, 1 pigment { rgb <1, 0.2, 0.2> } }
box { <-1, -1, -5.5>, <0.1, 1, -3> pigment { rgbf 0.95 } hollow interior { ior 1.2 } }
box { <0.6, -0.8, -1.2>, <1.8, 0.6, -0.8> pigment { rgbt 0.9 } }
