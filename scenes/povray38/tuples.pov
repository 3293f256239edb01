#version 3.8;
// Several names at once: of values, and of an array.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 45 }
light_source { <4, 6, -6>, 1 }

#declare (Radius, Place, Colour) = (0.8, <-1.2, 0, 0>, rgb <0.8, 0.5, 0.2>);
#declare { Low, , High } = array[3] { -0.5, 0, 0.9 };
sphere { Place, Radius pigment { Colour } }
box { Low, High pigment { rgb <0.2, 0.6, 0.5> } rotate 25*y translate -Place }
