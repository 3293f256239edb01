// Wax: light goes in, wanders and comes out elsewhere (subsurface). Each flame is a lamp of its own.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 mm_per_unit 18 subsurface { samples 16, 4 } }
#default { finish { ambient 0 } }

camera { location <0, 3.0, -10> right 4/3*x look_at <0.05, 1.72, 0> angle 34 }
light_source { <-6, 8, -9> rgb <0.30, 0.42, 0.75>*0.16 }
plane { -z, -4 pigment { rgb <0.16, 0.10, 0.10> } finish { diffuse 0.8 } }
plane { y, 0 pigment { rgb <0.14, 0.07, 0.04> } finish { diffuse 0.7 specular 0.2 roughness 0.03 reflection { 0.03, 0.35 } } }

#macro Candle(Place, Tall, Wide, C)
  #local Top = Place + Tall*y;
  light_source {
    Top + 0.50*y rgb <1.0, 0.60, 0.24>*1.5 fade_distance 2.4 fade_power 2
    looks_like {
      union {                                       // The flame: a drop of light with a blue foot
        sphere { 0, 1 scale <0.105, 0.26, 0.105> translate -0.02*y pigment { rgbt <1, 1, 1, 0.25> }
          finish { diffuse 0 emission <2.0, 1.25, 0.50> } }
        cone { 0.12*y, 0.088, 0.46*y, 0 pigment { rgbt <1, 1, 1, 0.25> } finish { diffuse 0 emission <2.0, 1.1, 0.40> } }
      }
    }
  }
  cylinder { Top - 0.2*y, Top + 0.24*y, 0.022 pigment { rgb 0.02 } }
  difference {
    superellipsoid { <1, 0.12> rotate 90*x scale <Wide, Tall/2, Wide> translate Place + Tall/2*y }
    sphere { Top + 0.52*Wide*y, Wide*0.92 }
    pigment { rgb C }
    finish { diffuse 0.75 specular 0.35 roughness 0.03 subsurface { translucency <2.2, 1.0, 0.45>*1.5 } }
    interior { ior 1.4 }
  }
#end
Candle(<-1.55, 0, 0.4>, 2.5, 0.62, <0.95, 0.90, 0.80>)
Candle(<0.25, 0, -0.5>, 1.35, 0.72, <0.90, 0.55, 0.42>)
Candle(<1.75, 0, 0.7>, 1.9, 0.55, <0.80, 0.86, 0.72>)
