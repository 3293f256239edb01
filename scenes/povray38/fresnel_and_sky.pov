#version 3.8;
// Light of radiosity under `fresnel`: less of it is left at grazing angles. All light is the white sky's, so no sample of it is a matter of chance.
global_settings { assumed_gamma 1 radiosity { count 50 recursion_limit 1 error_bound 0.5 } }
camera { location <0, 1, -5> look_at <0, 0, 0> angle 50 }
background { rgb 1 }
#default { finish { ambient 0 diffuse 0.8 } }
plane {
  y, -1.1
  texture {
    checker
    texture { pigment { rgb <0.6, 0.5, 0.4> } finish { fresnel } }
    texture { pigment { rgb <0.3, 0.6, 0.9> } finish { fresnel 0.6 } normal { bumps 0.3 scale 0.3 } }
  }
  interior { ior 1.5 }
}
