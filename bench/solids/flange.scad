// The same as the scene of this name; z is up.
include <round.scad>
difference() {
    union() { rod(3, 0, 0.5); rod(1.6, 0.5, 1.5, 1.2); }
    rod(0.8, -1, 2);
    rod(0.95, 1.25, 2);
    for (i = [0:7]) rotate(45 * i) translate([2.3, 0, 0]) rod(0.3, -1, 1);
}
