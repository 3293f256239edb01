// The same as the scene of this name; z is up.
include <round.scad>
module block(low, high) { translate(low) cube(high - low); }
difference() {
    block([-1.5, -1.5, -1.5], [1.5, 1.5, 1.5]);
    difference() {
        block([-1, -1.5, -1.5], [1, 1.5, 1.5]);
        difference() { block([-0.6, -1, -1.5], [0.6, 1, 1.5]); rod(0.35, -1.5, 1.5); }
    }
    block([-1.5, -0.5, 0.5], [1.5, 0.5, 1.5]);
}
