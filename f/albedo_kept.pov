// What a finish statement makes of `albedo` stays as it is when a later one writes another size of the highlight.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -6> look_at 0 right 8*x up 6*y }
light_source { <-5, 4, -6>, 0.6 parallel point_at 0 }
#declare Matt = finish { ambient 0 diffuse albedo 0.5 brilliance 2 }
#declare Plain = finish { ambient 0 diffuse 0.5 brilliance 2 }
#declare Phong = finish { ambient 0 diffuse 0 phong albedo 0.3 phong_size 20 }
#declare Spot = finish { ambient 0 diffuse 0 specular albedo 0.2 roughness 0.05 }
#declare White = texture { pigment { rgb 1 } finish { Matt phong albedo 0.2 } }
#macro Block(I, J) box { -0.55, 0.55 rotate <20, 30, 0> translate <I*1.3 - 3.25, 1.9 - J*1.35, 0> #end
#macro Ball(I, J) sphere { 0, 0.6 translate <I*1.3 - 3.25, 1.9 - J*1.35, 0> #end

Block(0, 0) pigment { rgb 1 } finish { Matt } }
Block(1, 0) pigment { rgb 1 } finish { Matt brilliance 1 } }
Block(2, 0) pigment { rgb 1 } finish { Matt } finish { brilliance 4 } }
Block(3, 0) texture { White finish { brilliance 0.5 } } }
Block(4, 0) texture { White finish { diffuse 0.5 } } }
Block(5, 0) pigment { rgb 1 } finish { Plain diffuse albedo 0.5 } }
Block(0, 1) pigment { rgb 1 } finish { Plain brilliance 4 } }
Block(1, 1) pigment { rgb 1 } finish { diffuse albedo 0.25 brilliance 3 diffuse 0.2 } }
Block(2, 1) pigment { rgb 1 } finish { Matt ambient 0.1 } }
Ball(3, 1) texture { White finish { phong_size 10 } } }
Ball(4, 1) texture { White finish { phong 0.3 } } }
Ball(5, 1) pigment { rgb 1 } finish { Matt specular albedo 0.1 brilliance 3 } }
Ball(0, 2) pigment { rgb 1 } finish { Phong } }
Ball(1, 2) pigment { rgb 1 } finish { Phong phong_size 5 } }
Ball(2, 2) pigment { rgb 1 } finish { Phong ambient 0 } }
Ball(3, 2) pigment { rgb 1 } finish { Spot } }
Ball(4, 2) pigment { rgb 1 } finish { Spot roughness 0.2 } }
Ball(5, 2) pigment { rgb 1 } finish { Spot specular 0.5 } }
