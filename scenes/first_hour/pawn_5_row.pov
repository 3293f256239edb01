// First hour, pawn, step 5: a loop sets two rows of pawns, no two of them of the same piece of wood.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <-3, 5, -10> look_at <0.2, 0.6, 1.2> angle 48 }
light_source { <-5, 8, -6> rgb 1 }
light_source { <6, 4, -6> rgb 0.3 shadowless }
background { rgb <0.55, 0.62, 0.70> }
plane {
  <0, 1, 0>, 0
  pigment { checker rgb <0.85, 0.80, 0.70>, rgb <0.25, 0.17, 0.12> scale 2 translate <1, 0, 1> }
  finish { reflection 0.12 }
}

#declare Pawn = lathe {
  bezier_spline 20,
  <0.00, 0.00>, <0.30, 0.00>, <0.60, 0.00>, <0.80, 0.00>
  <0.80, 0.00>, <0.90, 0.10>, <0.90, 0.30>, <0.70, 0.35>
  <0.70, 0.35>, <0.35, 0.50>, <0.28, 1.00>, <0.24, 1.50>
  <0.24, 1.50>, <0.60, 1.52>, <0.60, 1.64>, <0.26, 1.66>
  <0.26, 1.66>, <0.66, 1.85>, <0.55, 2.50>, <0.00, 2.50>
}

#macro Wood(Light, Dark, Seed)
  texture {
    pigment {
      wood
      turbulence 0.06
      color_map { [0 rgb Light] [1 rgb Dark] }
      rotate <86, 0, 8>
      scale 0.22
      translate Seed*<3.7, 1.3, 5.1>
    }
    finish { diffuse 0.75 specular 0.5 roughness 0.02 }
  }
#end

#for (I, -2, 2)
  object { Pawn Wood(<0.86, 0.68, 0.44>, <0.58, 0.37, 0.19>, I) translate <2*I, 0, 0> }
  object { Pawn Wood(<0.36, 0.20, 0.12>, <0.16, 0.08, 0.05>, I + 9) translate <2*I, 0, 4> }
#end
