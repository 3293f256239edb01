// A chrome flange: a difference of a union with fillets and 19 cuts.
// bench: +W640 +H480 -A
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <3.2, 4.2, -5.4> look_at <0, 0.4, 0> angle 40 }
light_source { <-7, 10, -6> rgb 0.9 }
light_source { <8, 6, -3> rgb 0.4 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.30, 0.28, 0.26>] [0.4 rgb <0.75, 0.80, 0.86>] [1 rgb <0.25, 0.40, 0.65>] } } }
plane { y, 0 pigment { checker rgb 0.75, rgb <0.35, 0.30, 0.28> scale 0.5 } finish { diffuse 0.8 } }

#declare Neck_Fillet = difference {  // the ring where the neck meets the plate, its cross section a hollow quarter circle
  cylinder { 0.5*y, 0.8*y, 1.25 }
  torus { 1.25, 0.3 translate 0.8*y }
}
difference {
  union {
    cylinder { 0.1*y, 0.5*y, 2 }
    cylinder { 0, 0.4*y, 1.9 }
    torus { 1.9, 0.1 translate 0.1*y }
    torus { 1.9, 0.1 translate 0.4*y }
    cylinder { 0.5*y, 1.8*y, 0.95 }
    torus { 0.87, 0.08 translate 1.8*y }
    cylinder { 0, 1.88*y, 0.87 }
    object { Neck_Fillet }
  }
  cylinder { -y, 3*y, 0.62 }
  cone { 1.7*y, 0.6, 2*y, 0.8 }
  torus { 0.95, 0.05 translate 1.2*y }
  #for (I, 0, 7)
    cylinder { <1.62, -1, 0>, <1.62, 1, 0>, 0.16 rotate (45*I + 10)*y }
    cone { <1.62, 0.4, 0>, 0.15, <1.62, 0.52, 0>, 0.26 rotate (45*I + 10)*y }
  #end
  pigment { rgb <0.55, 0.57, 0.60> }
  finish { ambient 0.05 diffuse 0.25 specular 0.9 roughness 0.01 metallic reflection { 0.65 metallic } }
}
