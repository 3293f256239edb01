// The same as the scene of this name; z is up.
include <round.scad>
sphere(1, $fn = sides(1));
