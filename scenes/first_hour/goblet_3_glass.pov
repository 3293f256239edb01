// First hour, goblet, step 3: glass is a clear colour, a mirror by Fresnel's law, and an interior that bends light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }

camera { location <0, 5, -9> look_at <0.5, 1.9, 0> angle 38 }
light_source { <-6, 9, -6> rgb 1 }
background { rgb <0.75, 0.80, 0.85> }
plane { <0, 1, 0>, -0.01 pigment { checker rgb 0.9, rgb <0.45, 0.52, 0.65> translate <0.5, 0, 0.5> } }

#declare Outside = lathe {
  bezier_spline 24,
  <0.00, 0.00>, <0.40, 0.00>, <0.80, 0.00>, <1.10, 0.00>
  <1.10, 0.00>, <1.16, 0.04>, <1.12, 0.10>, <1.00, 0.12>
  <1.00, 0.12>, <0.30, 0.20>, <0.12, 0.35>, <0.12, 0.90>
  <0.12, 0.90>, <0.12, 1.50>, <0.10, 1.70>, <0.25, 1.85>
  <0.25, 1.85>, <1.00, 2.15>, <1.35, 2.90>, <1.00, 4.00>
  <1.00, 4.00>, <0.70, 4.00>, <0.30, 4.00>, <0.00, 4.00>
}

#declare Inside = lathe {
  bezier_spline 12,
  <0.00, 1.98>, <0.95, 2.10>, <1.25, 2.95>, <0.93, 4.00>
  <0.93, 4.00>, <0.89, 4.14>, <0.82, 4.32>, <0.70, 4.50>
  <0.70, 4.50>, <0.50, 4.60>, <0.25, 4.65>, <0.00, 4.65>
}

#declare Glass = material {
  texture {
    pigment { rgbf <0.97, 0.99, 0.98, 1> }
    finish { ambient 0 diffuse 0 specular 0.8 roughness 0.003 reflection { 0, 1 fresnel } conserve_energy }
  }
  interior { ior 1.5 }
}

#declare Goblet = difference { object { Outside } object { Inside } }

object { Goblet material { Glass } }
