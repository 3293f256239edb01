// Twenty stones: patterns, maps of colours, pigments and textures, layers, and normals that bend the light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
#default { finish { ambient 0 diffuse 0.75 specular 0.65 roughness 0.008 reflection { 0.02, 0.22 } } }

camera { location <0, 8.6, -4.4> right 4/3*x look_at <0, 0, -0.12> angle 35.2 }
light_source { <-7, 9, 5> rgb <1.0, 0.94, 0.85>*1.15 area_light <2, 0, 2>, sqrt(8)*y, 5, 5 adaptive 1 circular orient }
light_source { <8, 8, -5> rgb <0.6, 0.75, 1.0>*0.4 }
sky_sphere { pigment { gradient y color_map { [0.3 rgb <0.10, 0.12, 0.15>] [1 rgb <0.9, 0.95, 1>] } } }

#macro Bands(A, B, C, D) color_map { [0 rgb A] [0.35 rgb B] [0.6 rgb C] [1 rgb D] } #end
#declare Red = <0.50, 0.05, 0.03>; #declare Sand = <0.85, 0.68, 0.45>; #declare Night = <0.02, 0.05, 0.16>;
#declare Sea = <0.03, 0.28, 0.30>; #declare Bone = <0.90, 0.86, 0.78>; #declare Moss = <0.10, 0.22, 0.06>; #declare Plum = <0.24, 0.04, 0.18>;
#declare Flecks = texture { pigment { rgb Night } } texture { pigment { bozo scale 0.07 color_map { [0.62 rgbt 1] [0.66 rgb <1, 0.7, 0.25>] } } finish { metallic } }
// Each in a ring of brass, on slate; five make a row.
#declare Set = 0;
#macro Stone(T)
  union {
    sphere { 0, 1 scale <0.44, 0.30, 0.44> texture { T } }
    torus { 0.45, 0.045 pigment { rgb <0.80, 0.55, 0.22> } finish { metallic diffuse 0.5 reflection { 0.3 metallic } } }
    translate <(mod(Set, 5) - 2)*1.1, 0.02, (1.5 - int(Set/5))*1.1>
  }
  #declare Set = Set + 1;
#end
Stone(texture { pigment { agate scale 0.55 Bands(Red, Sand, Bone, Plum) } })
Stone(texture { pigment { marble turbulence 0.9 scale 0.35 Bands(Bone, Bone, Sea, Night) } })
Stone(texture { pigment { granite scale 0.9 Bands(Night, Plum, Sand, Bone) } })
Stone(texture { pigment { crackle scale 0.22 color_map { [0 rgb <0.95, 0.70, 0.25>] [0.10 rgb Sea*0.5] [0.6 rgb Sea] } } })
Stone(texture { pigment { crackle solid scale 0.16 Bands(Red, Sand, Plum, Night) } normal { crackle 0.6 scale 0.16 } })
Stone(texture { pigment { onion scale 0.13 translate 0.3*x turbulence 0.12 Bands(Sand, Red, Bone, Moss) } })
Stone(texture { pigment { leopard scale 0.045 turbulence 0.25 Bands(Night, Night, Sand, Bone) } })
Stone(texture { pigment { spiral1 3 rotate 90*x turbulence 0.1 Bands(Plum, Bone, Sea, Night) } })
Stone(texture { pigment { rgb Sea } normal { dents 1.6 scale 0.22 } })
Stone(texture { pigment { rgb Red } normal { quilted 1.2 scale 0.16 } })
Stone(texture { pigment { wood turbulence 0.12 scale 0.10 rotate 4*x translate <0.2, 0.1, 0> Bands(Sand, Sand*0.7, Red*0.4, Sand) } })
Stone(texture { pigment { radial frequency 12 pigment_map { [0.4 rgb Bone] [0.5 granite scale 0.3 Bands(Night, Sea, Sea, Bone)] } } })
Stone(texture { slope { y, 0.5, 1 } texture_map { [0.3 pigment { rgb Moss }] [0.7 pigment { bozo scale 0.06 Bands(Moss, Sand, Bone, Bone) }] } })
Stone(texture { pigment { julia <0.353, 0.288>, 30 rotate 90*x scale 0.33 Bands(Night, Sea, Bone, Sand) } })
Stone(texture { pigment { wrinkles scale 0.25 Bands(Plum, Plum, Red, Sand) } normal { wrinkles 0.9 scale 0.25 } })
Stone(texture { pigment { hexagon rgb Bone, rgb Red, rgb Night scale 0.10 } normal { dents 0.4 scale 0.1 } })
Stone(texture { pigment { waves frequency 3 scale 0.12 turbulence 0.2 Bands(Sea, Night, Sea, Bone) } })
Stone(Flecks)
Stone(texture { pigment { rgb Bone } normal { ripples 0.7 frequency 4 scale 0.3 } })
Stone(texture { pigment { cells scale 0.12 turbulence 0.05 Bands(Sand, Red, Moss, Sea) } normal { facets 0.12 scale 0.4 } })
plane { y, 0 pigment { rgb <0.035, 0.04, 0.048> } normal { granite 0.12 scale 0.7 } finish { specular 0.15 roughness 0.05 reflection 0 } }
