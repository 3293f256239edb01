// Letters (text) cut into a board of walnut and gilded, and the shavings that came out.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
#default { finish { ambient 0 } }

camera { location <1.6, 7.2, -8.2> right 4/3*x look_at <0.05, 0, -0.62> angle 39.5 }
light_source { <-8, 9, 4> rgb <1.0, 0.86, 0.66>*1.35 area_light <2, 0, 2>, sqrt(8)*y, 5, 5 adaptive 1 circular orient }
light_source { <6, 10, -8> rgb <0.55, 0.65, 0.85>*0.42 }

// Wood: rings about z, and over them fine dark pores that are drawn out along the grain.
#declare Shine = finish { diffuse 0.75 specular 0.22 roughness 0.035 }
#macro Wood(Dark, Light, Ring, Turn, Place)
  texture {
    pigment { wood turbulence <0.06, 0.05, 0.1> octaves 4 scale <Ring, Ring, 3*Ring> rotate Turn translate Place
      color_map { [0 rgb Light] [0.55 rgb (Light + Dark)/2] [0.88 rgb Dark] [1 rgb Light] } }
    finish { Shine }
  }
  texture {
    pigment { granite scale <0.05, 0.05, 1.6> rotate Turn
      color_map { [0.05 rgbt <0.04, 0.015, 0.01, 0.15>] [0.30 rgbt <0.04, 0.015, 0.01, 1>] } }
    finish { Shine }
  }
#end
#declare Word = text { ttf "timrom.ttf" "whittle" 1, 0 scale <2.3, 2.5, 1> }
#declare Wide = max_extent(Word).x;
difference {
  superellipsoid { <0.05, 0.12> rotate 90*x scale <3.6, 0.4, 1.55> translate -0.4*y }
  object {
    Word translate <-Wide/2, -0.82, 0> rotate 90*x translate 0.93*y
    pigment { rgb <1.0, 0.66, 0.22> } finish { diffuse 0.75 metallic specular 0.8 roughness 0.06 reflection { 0.12 metallic } }
  }
  Wood(<0.085, 0.036, 0.018>, <0.26, 0.13, 0.065>, 0.30, <2, 87, 0>, <0, 1.1, 1.9>)
}
object { plane { y, -0.8 } Wood(<0.34, 0.21, 0.11>, <0.50, 0.35, 0.21>, 0.8, <1, 22, 0>, <0, -2.2, 0>) }
// Shavings: strips that roll up, as prisms whose outline is a spiral there and back again.
#declare Dice = seed(12);
#macro Curl(Turns, Wide)
  prism {
    linear_spline 0, Wide, 83
    #for (I, 0, 40) , <cos(I*Turns*pi/20), sin(I*Turns*pi/20)>*(0.06 + 0.005*I) #end
    #for (I, 40, 0, -1) , <cos(I*Turns*pi/20), sin(I*Turns*pi/20)>*(0.053 + 0.005*I) #end
    , <0.06, 0>
    pigment { rgb <0.62, 0.40, 0.22> } finish { diffuse 0.85 specular 0.1 }
    rotate 90*z
  }
#end
#for (I, 0, 21)
  object { Curl(1 + 1.6*rand(Dice), 0.10 + 0.30*rand(Dice)) rotate <360*rand(Dice), 360*rand(Dice), 0>
    translate <-3.3 + 6.6*rand(Dice), -0.6, -2.1 - 0.8*rand(Dice)> }
#end
