// Seven hundred copies of two objects, turned, stretched, some of glass: from the 257th on they share their parts.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

camera { location <0, 9, -12> look_at <0, 0, 0.6> angle 50 }
light_source { <6, 12, -9>, rgb 0.9 }
light_source { <-8, 6, -3>, rgb 0.4 }
plane { y, -0.6 pigment { checker rgb 0.75, rgb <0.45, 0.5, 0.55> } }

#declare Lamp = union {
  difference {
    cylinder { -0.4*y, 0.4*y, 0.35 }
    cylinder { -0.3*y, 0.5*y, 0.25 }
    box { <-0.5, -0.1, -0.08>, <0.5, 0.15, 0.08> pigment { rgb <0.9, 0.8, 0.2> } }
    pigment { bozo color_map { [0 rgb <0.8, 0.3, 0.2>] [1 rgb <0.3, 0.1, 0.3>] } scale 0.2 }
    finish { phong 0.5 }
  }
  sphere { 0.55*y, 0.18 }
  torus { 0.35, 0.05 translate -0.4*y pigment { rgb <0.2, 0.5, 0.8> } finish { reflection 0.3 } }
  blob { threshold 0.5
    sphere { <0.3, 0.1, 0>, 0.25, 1 }
    sphere { <-0.3, 0.1, 0>, 0.25, 1 }
  }
  box { <-0.06, 0.3, -0.06>, <0.06, 0.8, 0.06> pigment { rgbt <0.7, 1, 0.8, 0.6> } interior { ior 1.3 } }
  mesh {
    triangle { <-0.3, 0.75, 0>, <0.3, 0.75, 0>, <0, 1, 0.1> }
    triangle { <-0.3, 0.75, 0>, <0, 1, 0.1>, <0, 0.7, 0.3> }
    pigment { rgb <0.9, 0.9, 0.95> }
  }
}

#declare Drop = difference {
  sphere { 0, 0.5 }
  sphere { <0.2, 0.3, -0.2>, 0.3 }
  cylinder { -x, x, 0.12 }
  cylinder { -z, z, 0.12 }
  cylinder { -y, y, 0.12 }
  sphere { <-0.2, 0.3, 0.2>, 0.15 }
  sphere { <-0.3, -0.1, -0.3>, 0.15 }
  sphere { <0.3, -0.2, -0.3>, 0.15 }
}

#for (I, 0, 701)
  #local X = mod(I, 27) - 13;
  #local Z = 15 - int(I/27);
  #if (mod(I + int(I/27), 2) = 0)
    object { Lamp
      #if (mod(I, 3) = 0) pigment { rgb <0.3, 0.7, 0.3> } #end
      rotate <0, 37*I, 5*sin(I)> scale <0.5, 0.5 + 0.2*cos(I), 0.6> translate <0.6*X, 0, 0.6*Z> }
  #else
    object { Drop
      #if (mod(I, 5) = 0) pigment { rgbt <0.8, 0.9, 1, 0.8> } finish { specular 0.4 } interior { ior 1.4 }
      #else pigment { granite scale 0.3 } #end
      scale 0.6 + 0.1*sin(I) rotate <20*I, 0, 31*I> translate <0.6*X, 0, 0.6*Z> }
  #end
#end
