// What glass does with light: photons go from the lamp through a ball, a ring, and a drop, each of its own colour.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 photons { spacing 0.018 autostop 0 jitter 0 } }
#default { finish { ambient 0 } }

camera { location <0, 5.4, -9.5> right 4/3*x look_at <-0.1, 0.35, -0.5> angle 38.5 }
light_source { <7, 6.0, 8> rgb <1.0, 0.90, 0.76>*1.5 photons { refraction on reflection on } }
light_source { <-8, 9, -9> rgb <0.5, 0.62, 0.85>*0.28 area_light 4*x, 4*y, 4, 4 adaptive 1 photons { refraction off reflection off } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.20, 0.22, 0.26>] [0.4 rgb <0.06, 0.07, 0.10>] [0.8 rgb <0.7, 0.75, 0.8>] } } }
plane { y, 0 pigment { rgb <0.72, 0.68, 0.62> } finish { diffuse 0.7 } }

#macro Glass(C, Far)
  pigment { rgbf <1, 1, 1, 0.98> }
  finish { diffuse 0 specular 0.9 roughness 0.002 reflection { 0.01, 1 fresnel on } conserve_energy }
  interior { ior 1.5 fade_color C fade_distance Far fade_power 1001 dispersion 1.03 dispersion_samples 7 }
  photons { target refraction on reflection on collect off }
#end
sphere { <0.1, 1.1, 0.6>, 1.1 Glass(<0.95, 0.97, 0.98>, 2) }
torus { 0.78, 0.30 translate <-2.3, 0.30, -0.5> Glass(<0.02, 0.24, 0.68>, 0.5) }
sor {
  7, <0, -0.2>, <0.52, 0>, <0.92, 0.35>, <0.78, 0.95>, <0.30, 1.6>, <0.05, 2.1>, <0, 2.2>
  translate <2.35, 0, -0.4> Glass(<0.85, 0.16, 0.05>, 0.8)
}
sphere { <0.75, 0.32, -2.0>, 0.32 Glass(<0.10, 0.65, 0.25>, 0.5) }
sphere { <-0.55, 0.24, -2.5>, 0.24 Glass(<0.75, 0.15, 0.55>, 0.4) }
