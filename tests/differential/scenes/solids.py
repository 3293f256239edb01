"""Every solid with all its parameters, one or two in a scene, on a stage with a shadow."""
import math

from rng import block, lines
from words import common
from words.patterns import NOISE


def scene(r):
    parts = [common.HEADER, NOISE, common.camera(r), common.light(r), common.background(r), r.some(.8, common.floor(r))]
    for _ in range(r.whole(1, 2)):
        parts.append(thing(r, r.pick(*KINDS)))
    return lines(*parts)


def thing(r, kind):
    before, word, body = kind(r)
    look = [common.pigment(r), common.finish(r)] if r.chance(.85) or word in CLEARLESS else [f"pigment {{ rgbt <{r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(.3, .8)}> }}"]
    solid = lambda *more: block(word, body, *look, r.some(.1, "inverse") if word in CLOSED else "", *more)
    turn = lines(r.some(.7, f"rotate {r.vec(-180, 180)}"), r.some(.2, f"scale {r.vec(.6, 1.3)}"), f"translate {r.box((-1, 1), (-.2, .5), (-.8, .8))}")
    if word in CLOSED and r.chance(.25):
        other, other_body = common.solid(r, .8)
        return lines(before, block(r.pick("difference", "intersection", "union", "merge"), solid(), block(other, other_body, common.pigment(r)), turn))
    return lines(before, solid(turn))


def plain(r):
    return ("", *common.solid(r, 1))


def disc(r):
    return "", "disc", f"{r.vec(-.3, .3)}, {r.vec(-1, 1)[:-1]} + .1>, {r.num(.5, 1.2)}" + r.some(.5, f", {r.num(.1, .4)}")


def blob(r):
    parts = [f"threshold {r.num(.2, .9)}"]
    for _ in range(r.whole(1, 4)):
        strength = r.pick(r.num(.5, 2), r.num(.5, 2), r.num(-1, -.3))
        parts.append(r.pick(f"sphere {{ {r.vec(-.5, .5)}, {r.num(.6, 1.2)}, {strength} {r.some(.3, common.pigment(r))} {r.some(.2, 'scale <1, .6, 1>')} }}",
                            f"cylinder {{ {r.vec(-.7, -.1)}, {r.vec(.1, .7)}, {r.num(.3, .8)}, {strength} }}"))
    return "", "blob", lines(*parts, r.some(.1, "sturm"), r.some(.1, "hierarchy off"))


def outline(r, count, low, high):
    """Points around the origin, turning once: no edge crosses another."""
    turns = sorted(r.unit() for _ in range(count))
    points = []
    for i, turn in enumerate(turns):
        angle, radius = 2 * math.pi * (i + .6 * turn) / count, r.real(low, high)
        points.append(f"<{radius * math.cos(angle):.3f}, {radius * math.sin(angle):.3f}>")
    return points


def prism(r):
    kind = r.pick("linear_spline", "linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline")
    sweep = r.pick("linear_sweep", "linear_sweep", "conic_sweep") if kind != "x" else ""
    heights = f"{r.num(-.5, 0)}, {r.num(.3, .8)}" if sweep == "linear_sweep" else f"{r.num(.1, .5)}, {r.num(.7, 1.1)}"
    points = outline(r, r.whole(4, 7), .5, 1)
    if kind == "linear_spline":
        points = points + points[:1]
    elif kind == "quadratic_spline":
        points = points[-1:] + points + points[:1]
    elif kind == "cubic_spline":
        points = points[-1:] + points + points[:2]
    else:
        points = [p for a, b, c, d in [(points[i], points[i], points[(i + 1) % 4], points[(i + 1) % 4]) for i in range(4)] for p in (a, b, c, d)] if len(points) == 4 else \
            ["<0, -.8>", "<1, -.8>", "<.9, .2>", "<.3, .8>", "<.3, .8>", f"<-.6, {r.num(.3, .9)}>", "<-1, -.4>", "<0, -.8>"]
    return "", "prism", lines(sweep, kind, f"{heights}, {len(points)},", ", ".join(points), r.some(.2, "open"), r.some(.15, "sturm"))


def lathe(r):
    kind = r.pick("linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline")
    count = 4 * r.whole(1, 2) if kind == "bezier_spline" else r.whole(5, 7)
    points = [f"<{r.num(.15, 1)}, {-.9 + 1.8 * i / (count - 1):.3f}>" for i in range(count)]
    if kind == "bezier_spline" and count == 8:
        points[4] = points[3]
    return "", "lathe", lines(kind, f"{count},", ", ".join(points), r.some(.25, "sturm"))


def sor(r):
    count = r.whole(4, 7)
    return "", "sor", lines(f"{count},", ", ".join(f"<{r.num(.25, .9)}, {-1.2 + 2.4 * i / (count - 1):.3f}>" for i in range(count)), r.some(.3, "open"), r.some(.2, "sturm"))


def polynomial(r):
    kind = r.whole(0, 2)
    bowl = lambda: r.num(.7, 1.5)
    if kind == 0:
        return "", "poly", f"2, <{bowl()}, {r.num(-.5, .5)}, {r.num(-.5, .5)}, {r.num(-.3, .3)}, {bowl()}, {r.num(-.5, .5)}, {r.num(-.3, .3)}, {bowl()}, {r.num(-.3, .3)}, -.6>"
    if kind == 1:  # x^4 + y^4 + z^4 and lower terms
        a = [r.num(-.4, .4) if r.chance(.2) else "0" for _ in range(35)]
        a[0], a[20], a[30], a[34] = bowl(), bowl(), bowl(), "-.5"
        return "", r.pick("quartic", "quartic", "poly"), "{}<" + ", ".join(a) + ">" + r.some(.3, " sturm")
    word = r.pick("polynomial")
    return "", word, f"4, xyz(4, 0, 0): {bowl()}, xyz(0, 4, 0): {bowl()}, xyz(0, 0, 4): {bowl()}, xyz(1, 1, 1): {r.num(-1, 1)}, xyz(2, 0, 0): {r.num(-1, .5)}, xyz(0, 0, 0): -.5" + r.some(.3, " sturm")


def quartic(r):
    before, word, body = polynomial(r)
    return before, word, body.replace("{}", "4, " if word == "poly" else "")


def isosurface(r):
    formula, gradient = r.pick(("x*x + y*y + z*z - .7", 4), ("abs(x) + abs(y) + abs(z) - .9", 2), ("x*x*x*x + y*y*y*y + z*z*z*z - .4", 8), ("sqrt(x*x + z*z) - .4 - .2*sin(5*y)", 2.5),
                               ("x*x + y*y + z*z - .6 + .3*f_noise3d(4*x, 4*y, 4*z)", 6), ("max(abs(x), abs(z)) - .6 + .1*cos(8*y)", 2.5), ("y - .3*sin(4*x)*cos(4*z)", 3))
    container = r.pick("contained_by { box { -.9, .9 } }", f"contained_by {{ sphere {{ 0, {r.num(.7, 1)} }} }}", "contained_by { box { <-1, -.8, -.9>, <.9, .8, 1> } }")
    return "", "isosurface", lines(f"function {{ {formula} }}", container, f"max_gradient {gradient}", r.some(.3, f"threshold {r.num(-.1, .2)}"), r.some(.3, f"accuracy {r.num(.0005, .01)}"),
                                   r.some(.3, f"max_trace {r.whole(2, 6)}"), r.some(.2, "all_intersections"), r.some(.3, "open"))


def parametric(r):
    functions, low, high = r.pick((("sin(u)*cos(v)", "sin(u)*sin(v)", "cos(u)"), "<0, 0>", "<pi, 2*pi>"), (("u", "v", "u*v"), "<-.8, -.8>", "<.8, .8>"),
                                  (("cos(u)*(.6 + .25*cos(v))", ".25*sin(v)", "sin(u)*(.6 + .25*cos(v))"), "<0, 0>", "<2*pi, 2*pi>"))
    return "", "parametric", lines(*(f"function {{ {f} }}" + ("," if i < 2 else "") for i, f in enumerate(functions)), low + ", " + high, "contained_by { box { -1.1, 1.1 } }", "max_gradient 3",
                                   f"accuracy {r.pick('.01', '.02')}", "precompute 10 x, y, z")


def julia(r):
    hyper = r.chance(.4)
    return "", "julia_fractal", lines(f"<{r.num(-.3, .1)}, {r.num(0, .6)}, {r.num(-.5, 0)}, {r.num(-.1, .1)}>", r.some(.7, r.pick("quaternion", "hypercomplex")) if hyper else "quaternion",
                                      r.pick("sqr", "sqr", "cube") if not hyper else "sqr", f"max_iteration {r.whole(4, 8)}", f"precision {r.whole(10, 40)}",
                                      r.some(.3, f"slice <{r.num(-.2, .2)}, 0, 0, 1>, {r.num(-.3, .3)}"))


def height_field(r):
    kind = r.pick("png \"picture.png\"", f"function {r.whole(8, 24)}, {r.whole(8, 24)} {{ (sin(x*{r.num(3, 9)})*cos(y*{r.num(3, 9)}) + 1)/2 }}",
                  f"function {r.whole(8, 24)}, {r.whole(8, 24)} {{ pattern {{ bozo scale .3 }} }}")
    return "", "height_field", lines(kind, r.some(.4, "smooth"), r.some(.3, f"water_level {r.num(.1, .5)}"), "translate -.5", f"scale <2, {r.num(.5, 1.2)}, 2>")


def patch(r):
    points = [f"<{x * .6 - .9:.2f}, {r.num(-.6, .6)}, {z * .6 - .9:.2f}>" for z in range(4) for x in range(4)]
    return "", "bicubic_patch", lines(f"type {r.whole(0, 1)} flatness {r.pick('0', '.01', '.1')} u_steps {r.whole(1, 4)} v_steps {r.whole(1, 4)}", ", ".join(points))


def mesh(r):
    faces = []
    for _ in range(r.whole(3, 8)):
        corners = [r.vec(-1, 1) for _ in range(3)]
        if r.chance(.3):
            normals = [r.vec(.2, 1) for _ in range(3)]
            faces.append("smooth_triangle { " + ", ".join(f"{c}, {n}" for c, n in zip(corners, normals)) + " }")
        else:
            faces.append("triangle { " + ", ".join(corners) + " }")
    return "", "mesh", lines(*faces, r.some(.3, "hierarchy off"))


def mesh2(r):
    """An octahedron with moved corners, closed, so it may have an inside."""
    d = lambda: r.num(.6, 1)
    corners = [f"<{d()}, 0, 0>", f"<-{d()}, 0, 0>", f"<0, {d()}, 0>", f"<0, -{d()}, 0>", f"<0, 0, {d()}>", f"<0, 0, -{d()}>"]
    faces = ["<0, 2, 4>", "<2, 1, 4>", "<1, 3, 4>", "<3, 0, 4>", "<2, 0, 5>", "<1, 2, 5>", "<3, 1, 5>", "<0, 3, 5>"]
    return "", "mesh2", lines(f"vertex_vectors {{ 6, {', '.join(corners)} }}", r.some(.4, f"normal_vectors {{ 6, {', '.join(corners)} }}"), f"face_indices {{ 8, {', '.join(faces)} }}",
                              r.some(.7, f"inside_vector {r.pick('x', 'y', '<.3, 1, .2>')}"))


def polygon(r):
    outer = outline(r, r.whole(3, 7), .7, 1.1)
    inner = outline(r, r.whole(3, 5), .2, .5) if r.chance(.4) else []
    points = outer + outer[:1] + inner + inner[:1]
    return "", "polygon", f"{len(points)}, " + ", ".join(points)


def triangle(r):
    if r.chance(.5):
        return "", "triangle", ", ".join(r.vec(-1.2, 1.2) for _ in range(3))
    return "", "smooth_triangle", ", ".join(f"{r.vec(-1.2, 1.2)}, {r.vec(.2, 1)}" for _ in range(3))


def text(r):
    return "", "text", f"ttf \"{r.pick('timrom.ttf', 'cyrvetic.ttf', 'crystal.ttf')}\" \"{r.pick('Ag', 'R8', 'pov', 'Q')}\", {r.num(.1, .5)}, {r.pick('0', '.1*x', r.num(0, .2))} translate <-.5, -.3, 0> scale 1.4"


def sphere_sweep(r):
    kind = r.pick("linear_spline", "cubic_spline", "b_spline")
    count = r.whole(2, 4) if kind == "linear_spline" else r.whole(4, 6)
    points = [f"<{-1 + 2 * i / (count - 1):.3f}, {r.num(-.5, .5)}, {r.num(-.5, .5)}>, {r.num(.1, .35)}" for i in range(count)]
    return "", "sphere_sweep", lines(kind, f"{count},", ", ".join(points), r.some(.4, f"tolerance {r.pick('1e-4', '1e-6', '.001')}"))


def ovus(r):
    bottom = r.real(.5, .9)
    return "", "ovus", f"{bottom}, {r.num(.1, bottom * .95)}"


KINDS = (plain, plain, disc, blob, blob, prism, prism, lathe, lathe, sor, quartic, quartic, isosurface, isosurface, parametric, julia, height_field, patch, mesh, mesh2, polygon, triangle, text,
         sphere_sweep, ovus)
CLOSED = ("sphere", "box", "cylinder", "cone", "torus", "superellipsoid", "quadric", "blob", "prism", "lathe", "sor", "poly", "quartic", "polynomial", "isosurface", "julia_fractal", "height_field",
          "mesh2", "text", "sphere_sweep", "ovus")
CLEARLESS = ("isosurface", "julia_fractal", "parametric")  # their far sides are issue enough by themselves
