// First hour, flange, step 4: a fillet between plate and neck, a groove for the seal, and steel that mirrors a sky.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 5, -7> look_at <0, 0.3, 0> angle 36 }
light_source { <-6, 9, -5> rgb 1 }
light_source { <8, 5, -3> rgb 0.4 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.30, 0.28, 0.25>] [0.3 rgb <0.16, 0.20, 0.28>] [1 rgb <0.75, 0.85, 1>] } } }

#declare Radius = 2;
#declare Thick = 0.4;
#declare Holes = 6;
#declare Fillet = 0.25;

difference {
  union {
    cylinder { <0, 0, 0>, <0, Thick, 0>, Radius }
    cylinder { <0, 0, 0>, <0, 1.2, 0>, 1 }
    difference {                                    // fillet: a ring less a torus
      cylinder { <0, 0, 0>, <0, Thick + Fillet, 0>, 1 + Fillet }
      torus { 1 + Fillet, Fillet translate <0, Thick + Fillet, 0> }
    }
  }
  cylinder { <0, -1, 0>, <0, 2, 0>, 0.7 }
  torus { 0.85, 0.06 translate <0, 1.2, 0> }        // groove
  #for (I, 1, Holes)
    cylinder { <1.6, -1, 0>, <1.6, 1, 0>, 0.2 rotate <0, 360/Holes*I, 0> }
  #end
  pigment { rgb <0.55, 0.58, 0.64> }
  finish { ambient 0 diffuse 0.45 specular 0.8 roughness 0.02 metallic reflection { 0.35 metallic } }
}
