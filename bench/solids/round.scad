// As many sides as a circle of radius r needs to be no farther off than `tolerance`.
tolerance = 0.01;
function sides(r) = ceil(180 / acos(1 - tolerance / r));
module rod(r, from, to, top = 0) { translate([0, 0, from]) cylinder(r1 = r, r2 = top > 0 ? top : r, h = to - from, $fn = sides(r)); }
