// What the camera stands inside of: for POV-Ray the clip of an object does not count there, and an interior that two objects share
// counts once for each of them. Both balls hold the camera, the nearer one but for its clip.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at <0.3, 0.1, 0> angle 50 }
background { rgb <0.4, 0.6, 0.9> }
#default { finish { ambient 1 diffuse 0 } }
plane { -z, -6 pigment { checker rgb <0.8, 0.3, 0.2> rgb <0.9, 0.9, 0.7> } }
union {
  sphere { <0, 0, -3>, 3.2 clipped_by { plane { -z, 1.5 } } }
  sphere { <0.8, 0, -4>, 2.5 }
  pigment { rgbt <0.9, 1, 0.9, 0.8> } interior { ior 1.3 }
}
