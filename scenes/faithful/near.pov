// --faithful: crossings nearer than 1e-4 to a start are skipped, of shadow rays 1e-3, of blobs 0.01, whatever the scale and also those
// of the solid that the ray leaves: a scene a hundredth wide loses shadows and far sides, a thin plate has one side.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0.003, -0.006> look_at <0, 0.0005, 0.0003> angle 44 }
background { rgb <0.3, 0.5, 0.8> }
light_source { <-0.005, 0.009, -0.005> rgb 1 }

box { <-0.01, -0.001, -0.01>, <0.01, 0, 0.01> pigment { checker rgb 1 rgb 0.3 scale 0.001 } }
sphere { <-0.0006, 0.001, 0>, 0.001 pigment { rgbt <1, 0.8, 0.5, 0.5> } interior { ior 1.3 } }
box { <0.0008, -0.0003, 0>, <0.0022, 0.001, 0.0015> pigment { rgb <0.2, 0.7, 0.3> } finish { reflection 0.3 } }
box { <-0.0006, 0.0003, -0.0022>, <0.0012, 0.00036, -0.0012> pigment { rgbt <1, 0.3, 0.3, 0.6> } interior { ior 1.5 } finish { reflection 0.3 } }
blob {
  threshold 0.5
  sphere { <-0.0025, 0.0008, 0>, 0.0015, 1 }
  sphere { <-0.0025, 0.0016, 0.0006>, 0.0012, 1 }
  pigment { rgbt <0.5, 0.8, 1, 0.5> }
}
