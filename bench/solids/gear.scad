// The same as the scene of this name; z is up.
include <round.scad>
difference() {
    union() {
        rod(2.3, -0.5, 0.5);
        for (i = [0:15]) rotate(22.5 * i) translate([0, 0, -0.5])
            linear_extrude(1) polygon([[2.2, -0.34], [3, -0.16], [3, 0.16], [2.2, 0.34]]);
        rod(1, -0.9, 0.9);
    }
    rod(0.6, -1, 1);
    translate([-0.15, 0, -1]) cube([0.3, 0.8, 2]);
}
