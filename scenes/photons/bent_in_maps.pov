// Photons off mirrors whose normals are bent within texture maps: the maps' turning turns what bends them.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.02 gather 20, 60 radius 0.3 } }
camera { location <0, 0.5, 0> look_at <0, 5, 0> right x * 4 / 3 sky z angle 110 }
light_source { <0, 4, 0> rgb 0.8 photons { reflection on refraction off } }
plane { y, 5 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.9 } }
#declare Slope = texture {
  pigment { rgb 0 }
  normal { gradient x 2 scale 10 translate -5 * x }
  finish { ambient 0 diffuse 0 reflection 1 }
}
#macro Tile(Place, Turn, Stretch)
  box { <-0.4, -0.1, -0.4>, <0.4, 0, 0.4>
    texture { gradient y texture_map { [0 Slope] [1 Slope] } rotate y * Turn scale Stretch }
    photons { target reflection on }
    translate Place
  }
#end
Tile(<-0.6, 0, -0.6>, 90, 1)
Tile(<0.6, 0, -0.6>, 180, 1)
Tile(<-0.6, 0, 0.6>, 0, <1, 1, 3>)
Tile(<0.6, 0, 0.6>, 45, <1, 2, 1>)
