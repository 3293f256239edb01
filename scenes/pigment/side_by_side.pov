// Patterns that a tile of points looks up together: noise of all generators, sums of octaves, crackle, fractals, maps of
// pigments and layers, each on a ball of its own.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location <0, 0, -10> right 8*x up 6*y }
light_source { <-5, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.3> }

#declare Warm = color_map { [0.0 rgb <0.1, 0.05, 0.0>] [0.4 rgb <0.8, 0.3, 0.1>] [1.0 rgb <1.0, 0.95, 0.7>] }
#declare Veil = color_map { [0.2 rgbt <0.1, 0.2, 0.5, 0.1>] [0.5 rgbf <0.9, 0.9, 1.0, 0.8>] [0.9 rgbt <1, 1, 1, 1>] }
#declare Paints = array[12] {
  pigment { granite noise_generator 1 color_map { Warm } }
  pigment { wrinkles noise_generator 3 scale 0.4 color_map { Warm } }
  pigment { bozo turbulence <0.6, 0, 0.3> scale 0.3 color_map { Warm } }
  pigment { agate scale 0.6 color_map { Warm } }
  pigment { marble turbulence 0.7 scale 0.5 color_map { Warm } }
  pigment { wood turbulence 0.1 scale 0.3 rotate <20, 40, 0> color_map { Warm } }
  pigment { crackle scale 0.4 color_map { Warm } }
  pigment { crackle form <-1, 1, 0> metric 3 scale 0.4 color_map { Warm } }
  pigment { crackle solid turbulence 0.2 scale 0.3 color_map { Warm } }
  pigment { mandel 30 scale 0.6 translate 0.3*x color_map { Warm } }
  pigment { julia <-0.4, 0.6>, 25 scale 0.7 color_map { Warm } }
  pigment {
    gradient x turbulence 0.4 scale 0.7
    pigment_map {
      [0.3 leopard scale 0.05 color_map { Warm }]
      [0.7 crackle form <0, 0, 1> scale 0.2 color_map { Warm }]
    }
  }
}
#for (I, 0, 11)
  sphere {
    0, 0.9
    texture { pigment { Paints[I] } finish { ambient 0.1 diffuse 0.8 phong 0.2 } }
    #if (I = 1 | I = 5)
      texture { pigment { granite turbulence 0.4 color_map { Veil } } finish { ambient 0.1 diffuse 0.8 } }
      texture { pigment { dents scale 0.2 color_map { Veil } } normal { crackle 0.4 scale 0.3 } }
    #end
    translate <2*mod(I, 4) - 3, 2 - 2*floor(I/4), 0>
  }
#end
