// A ring of brass throws the cusp of a parallel light; a glass pane before it is passed through.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.04 gather 20, 80 radius 0.25, 1.2 jitter 0.6 } }
camera { location <0, 4, -4> look_at <0, 0, 0> angle 45 }
light_source { <6, 8, 3> rgb <1, 0.95, 0.9> parallel point_at 0 photons { reflection on refraction off } }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }
difference {
  cylinder { 0, 0.6 * y, 1.2 }
  cylinder { -y, y, 1.12 }
  pigment { rgb <0.9, 0.7, 0.35> } finish { ambient 0.05 diffuse 0.3 metallic specular 0.6 reflection { 0.75 metallic } }
  photons { target reflection on refraction off }
}
box { <1.5, 1, -1>, <1.6, 3, 2> pigment { rgbf <0.7, 0.9, 1, 0.8> } finish { ambient 0 diffuse 0.1 } interior { ior 1.02 } photons { pass_through } }
