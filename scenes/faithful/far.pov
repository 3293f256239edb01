// --faithful: POV-Ray's solids have no crossings beyond 1e7 units, camera, mirrored, straight on or shadow rays alike; boxes and a few
// others have them up to 2e10. The ground ends before the horizon; the shadow of one of two equal plates in front of the light is missing.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4e6, 0> look_at <0, 3e6, 1e7> angle 60 }
background { rgb <0.3, 0.4, 0.7> }
light_source { <3e7, 6e7, -3e7> rgb 1 }

plane { y, 0 pigment { checker rgb <1, 0.9, 0.7> rgb <0.6, 0.4, 0.3> scale 1e6 } }
sphere { <0, 3e6, 8e6>, 1e6 pigment { rgb <0.2, 0.6, 0.2> } finish { reflection 0.4 } }
sphere { <2e6, 3e6, 1.1e7>, 1.5e6 pigment { rgb <0.9, 0.1, 0.1> } }
sphere { <-4.6e6, 1.5e6, 9e6>, 2e6 pigment { rgbt <1, 1, 0.2, 0.5> } }
difference {
  box { <-9e6, 0, 1e7>, <-6e6, 6e6, 1.3e7> }
  sphere { <-6e6, 4e6, 1.1e7>, 2e6 }
  pigment { rgb <0.1, 0.5, 1> }
}
box { <4e6, 0, 1.2e7>, <7e6, 5e6, 1.5e7> pigment { rgb <0.2, 0.9, 0.9> } }
superellipsoid { <0.5, 0.5> scale 1.5e6 translate <6e6, 7e6, 1.2e7> pigment { rgb <0.9, 0.2, 0.9> } }
// Between the ground and the light, 2e7 up.
disc { <7e6, 2e7, -4e6>, y, 8e5 pigment { rgb 1 } }
box { <9e6, 2e7, -5e6>, <1.1e7, 2.0001e7, -3e6> pigment { rgb 1 } }
