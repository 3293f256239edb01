// What the last bit of a ray decides (spec 7d, 6): on which side of y = 0 hits on the plane y = 0 come to lie, and
// where the steps through a fractal fall that is turned about three axes.
#version 3.8;
global_settings { assumed_gamma 1.0 }
#default { finish { emission 1 ambient 0 diffuse 0 } }

camera { location <50, 55, -75> right 4/3*x angle 40 look_at <-10, 18, 0> }

plane { y, 0 pigment { function { select(y, 0, 0.5, 1) } color_map { [0 rgb <0.1, 0.2, 0.6>] [1 rgb <1, 0.9, 0.6>] } } }

julia_fractal {
    <-0.2, 0.3, -0.2, 0.1>
    hypercomplex
    sqr
    max_iteration 6
    precision 23
    pigment { function { mod(z + 100, 1) } color_map { [0 rgb <0.2, 0, 0>] [1 rgb <0.3, 1, 0.4>] } }
    rotate <20, 30, 40>
    scale 12
    translate <-6, 24, -4>
}
