// The same as the scene of this name; z is up.
include <round.scad>
difference() {
    sphere(2, $fn = sides(2));
    sphere(1.94, $fn = sides(2));
    for (i = [0:2]) rotate(60 * i) rotate([90, 0, 0]) rod(0.8, -3, 3);
    rod(1, 1, 3);
}
