"""Things whose faces lie in one place by the dozen: corners on whole numbers. Which face is seen is told by the order in which
POV-Ray asks (docs/povray/05a, 2.2 and 11.3)."""
from rng import lines


def scene(r):
    camera = f"camera {{ location <{r.pick('0', '3.1', '2.7')}, {r.pick('0', '4.2', '2.3')}, -9> look_at 0 angle 40 }}"
    return lines("#version 3.7; global_settings { assumed_gamma 1 }", camera, "light_source { <20, 30, -40> rgb 1 }",
                 *[thing(r) for _ in range(r.whole(3, 14))])


def thing(r):
    return r.made(*[lambda: box(r)] * 4, lambda: moved(r), lambda: scaled(r), lambda: plane(r), lambda: union(r), lambda: cut(r),
                  lambda: cylinder(r))


def look(r):
    mirror = r.some(.1, " finish { reflection .4 }")
    return f"pigment {{ rgb <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}> }}{mirror}"


def corner(r):
    return [r.whole(-3, 2) for _ in range(3)]


def vector(numbers):
    return "<" + ", ".join(str(n) for n in numbers) + ">"


def corners(r):
    low = corner(r)
    return f"{vector(low)}, {vector([n + r.whole(1, 3) for n in low])}"


def box(r):
    return f"box {{ {corners(r)} {look(r)} }}"


def moved(r):
    return f"box {{ {corners(r)} {look(r)} translate {vector(r.whole(-1, 1) for _ in range(3))} }}"


def scaled(r):
    return f"box {{ 0, 1 {look(r)} scale {vector(r.whole(1, 3) for _ in range(3))} translate {vector(corner(r))} }}"


def plane(r):
    return f"plane {{ {r.pick('y, -3', 'z, 3', 'x, -4')} {look(r)} }}"


def union(r):
    return f"union {{ {' '.join(box(r) for _ in range(r.whole(2, 4)))} }}"


def cut(r):
    return f"difference {{ box {{ {corners(r)} }} box {{ {corners(r)} }} {look(r)} }}"


def cylinder(r):
    foot = corner(r)
    return f"cylinder {{ {vector(foot)}, {vector([foot[0], foot[1] + r.whole(1, 3), foot[2]])}, 1 {look(r)} }}"
