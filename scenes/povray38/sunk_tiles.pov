#version 3.8;
// As ../csg/sunk_tiles.pov: 3.8 shows whole tiles, or parts up to the edges of boxes. Tiles of a floor whose tops lie in the top of the slab that holds them: which of the two shows goes from ray to ray by the order in which
// POV-Ray comes to their boxes.
global_settings { assumed_gamma 1 }
camera { location <-6, 4, -12> look_at <-1, 0, -2> angle 45 right x*4/3 }
light_source { <-20, 40, -30>, 1 }
background { rgb <0.6, 0.7, 0.9> }
#declare Tile = box { <-0.9, -2, -0.9>, <0.9, 0.3, 0.9> pigment { rgb <0.7, 0.2, 0.1> } finish { ambient 0.2 } }
union {
  #for (X, -4, 4, 2) #for (Z, -4, 4, 2) object { Tile translate <X, 0, Z> } #end #end
  box { <-5.5, -0.4, -5.5>, <5.5, 0.3, 5.5> pigment { rgb <0.2, 0.5, 0.2> } }
  finish { reflection 0.15 }
}
sphere { <-1.2, 1.4, -2>, 1.1 pigment { rgb <0.9, 0.8, 0.3> } finish { reflection 0.3 } }
cylinder { <2, 0.3, 1>, <2, 3, 1>, 0.4 pigment { rgb <0.3, 0.3, 0.9> } }
