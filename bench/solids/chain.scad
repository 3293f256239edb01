// The same as the scene of this name; z is up.
include <round.scad>
module link() { rotate_extrude($fn = sides(1.02)) translate([0.8, 0]) circle(0.22, $fn = sides(0.22)); }
for (i = [-2:2]) translate([1.1 * i, 0, 0]) rotate([(i + 2) % 2 * 90, 0, 0]) link();
