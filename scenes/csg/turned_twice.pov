// A union that is turned inside out twice, by itself and by what it is an operand of, has lost the surfaces inside of it, as a merge has; so has one with
// two `inverse` of its own. The left one was never turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 0.6, -9> look_at 0 angle 40 }
light_source { <-5, 9, -8> rgb 1 shadowless }
background { rgb <0.3, 0.5, 0.8> }
#declare Glass = texture { pigment { rgbt <1, 0.8, 0.6, 0.6> } finish { ambient 0.5 diffuse 0.5 } }
#declare Pair = union { sphere { -0.3*x, 0.7 } box { -0.4, <0.9, 0.5, 0.4> } texture { Glass } }
object { Pair translate -2.1*x }
intersection {
  box { -3, 3 translate -3.4*y inverse texture { Glass } }
  object { Pair inverse }
  inverse
}
object { union { Pair inverse } inverse translate 2.1*x }
union { sphere { -0.3*x, 0.5 } cylinder { 0, <0.9, 0.5, 0.4>, 0.3 } texture { Glass } inverse inverse translate <0, 1.4, 0> }
