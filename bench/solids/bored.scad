// The same as the scene of this name; z is up.
include <round.scad>
difference() { cube(2, center = true); rod(0.5, -2, 2); }
