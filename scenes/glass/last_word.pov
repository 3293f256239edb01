// Old keywords of finishes change the one interior of a statement: the last word stays, and holds for parts before it
// (docs/povray/03, 8.7).
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 0, -14>
  look_at 0
  angle 34
}
light_source { <-8, 14, -20> rgb 1 }
plane { -z, -3 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.15, 0.3, 0.5> scale 0.7 } }

#declare Clear = pigment { rgbt <0.95, 0.98, 1, 0.9> }
#declare Ball = sphere { 0, 0.85 pigment { Clear } }
#declare Bare = sphere { 0, 0.85 }
#declare Weak = sphere { 0, 0.3 pigment { Clear } finish { ior 1.15 } translate <0.95, -0.7, 0> }
#declare Strong = sphere { 0, 0.3 pigment { Clear } finish { ior 1.7 } translate <0.95, 0.7, 0> }
#declare Dim = sphere { 0, 0.3 pigment { Clear } finish { refraction 0.5 } translate <0.95, 0, 0> }

#macro At(Column, Row) translate <Column * 2.6 - 2.7, 2.2 - Row * 2.2, 0> #end

union { object { Ball } object { Strong } At(0, 0) }
union { object { Strong } object { Ball } object { Weak } At(1, 0) }
union { union { object { Ball } object { Weak } } object { Strong } At(2, 0) }

union { object { Bare } object { Strong } pigment { Clear } finish { ior 1.15 } At(0, 1) }
union { object { Weak } object { Bare } pigment { Clear } finish { ior 1.7 } At(1, 1) }
union { union { object { Ball } object { Strong } interior { ior 1.3 } } object { Weak } At(2, 1) }

union { object { Ball } object { Dim } At(0, 2) }
union { object { Dim } object { Ball } object { Strong } At(1, 2) }
difference { object { Ball } object { Strong translate <-0.4, -0.3, -0.3> } At(2, 2) }
