"""Solids that POV-Ray 3.8 added or draws otherwise, alone, in CSG with all others, clipped, bounded and turned inside out; its cameras by
functions and its lights that fade by a power alone."""
from rng import block, lines
from scenes import solids
from words import common
from words.patterns import NOISE

HEADER = "#version {};\nglobal_settings {{ assumed_gamma 1 }}"


def scene(r):
    parts = [HEADER.format(r.pick("3.8", "3.8", "3.8", "3.7")), NOISE, camera(r), light(r), r.some(.3, light(r)), common.background(r), r.some(.8, common.floor(r))]
    return lines(*parts, *(thing(r) for _ in range(r.whole(1, 3))))


def camera(r):
    """An ordinary one mostly; else one of 3.8's, with a view of the same stage."""
    if r.chance(.75):
        return common.camera(r)
    x, y, z = r.num(-1, 1), r.num(.3, 1.5), r.num(-6, -4)
    bent = r.pick("", f" + {r.num(-.2, .2)}*x*y", f" + {r.num(-.1, .1)}*sin({r.num(2, 9)}*y)", f" + {r.num(-.3, .3)}*x*x")
    return block("camera", "user_defined",
                 r.pick(f"location <{x}, {y}, {z}>", block("location", f"function {{ {x}{bent} }}", f"function {{ {y} + {r.num(0, 2)}*y }}", f"function {{ {z} }}"),
                        block("location", f"function {{ {r.num(2, 4)}*u }}, function {{ {r.num(2, 3)}*v }}, function {{ {z} }}")),
                 r.pick(block("direction", f"function {{ x{bent} }}", f"function {{ y*.75 - {r.num(0, .2)} }}", "function { 1 }"), f"direction <{r.num(-.1, .1)}, {r.num(-.2, 0)}, 1>",
                        block("direction", f"function {{ sin(x*{r.num(.8, 1.5)}) }}, function {{ sin(y*{r.num(.5, 1.2)}) - .1 }}, function {{ cos(x*1.2)*cos(y) }}")),
                 r.some(.2, f"normal {{ bumps {r.num(.05, .3)} scale {r.num(.1, .5)} }}"))


def light(r):
    if r.chance(.6):
        return common.light(r)
    power = r.real(.3, 2.5)
    kind = r.pick("", "", f"spotlight point_at <{r.num(-.5, .5)}, 0, 0> radius {r.num(10, 20)} falloff {r.num(25, 40)}", "shadowless")
    fade = r.pick(f"fade_power {power:g}", f"fade_power {power:g} fade_distance 0", f"fade_distance {r.num(2, 9)} fade_power {power:g}", f"fade_power {-power / 8:g}", "fade_power 0")
    strength = 9 ** power if "fade_distance" not in fade and "-" not in fade and fade != "fade_power 0" else 1
    return f"light_source {{ {r.box((-7, 7), (4, 8), (-8, -3))}, rgb {r.vec(.5, 1)}*{strength:.3g} {kind} {fade} }}"


def ends(r):
    return f"{r.vec(-.8, -.2)}, {{}}, {r.vec(.2, .8)}, {{}}"


def lemon(r):
    first, second = r.pick((0, 0), (r.real(0, .5), r.real(0, .5)), (r.real(.1, .5), 0), (0, r.real(.1, .5)))
    return "", "lemon", ends(r).format(f"{first:g}", f"{second:g}") + f", {r.pick(r.num(1.4, 2), r.num(2, 6), r.num(.3, 1.5))}" + r.some(.25, " open") + r.some(.2, " sturm")


def ovus(r):
    bottom = r.real(.3, .9)
    top = r.pick(r.real(.05, bottom), r.real(.05, bottom), r.real(bottom, bottom * 1.8))
    far = bottom * r.real(1, 1.8)
    least = (bottom + top + far) / 2
    extra = r.few(0, 3, [f"radius {least * r.real(1.01, 2):.3f}", f"distance {far:.3f}", f"precision {r.pick('1e-4', '1e-6', '.01')}"])
    return "", "ovus", f"{bottom:g}, {top:.3f} " + " ".join(extra) + r.some(.2, " sturm")


def torus(r):
    major = r.real(.2, .7)
    minor = r.pick(major * r.real(.2, .95), major * r.real(1.05, 2), major * r.real(1.05, 2))
    kind = r.pick("", "union", "merge", "difference", "intersection") if minor > major else r.pick("", "", "union", "merge", "difference")
    return "", "torus", f"{r.some(.1, '-')}{major:g}, {r.some(.1, '-')}{minor:.3f} {kind}" + r.some(.2, " sturm")


def isosurface(r):
    before, word, body = solids.isosurface(r)
    return before, word, lines(body, r.pick("polarity on", "polarity off", f"polarity {r.num(-1, 1)}", ""))


def mesh(r):
    """Closed, with an inside: a tetrahedron's or octahedron's faces as single triangles."""
    d = lambda: r.num(.6, 1)
    c = [f"<{d()}, 0, 0>", f"<-{d()}, 0, 0>", f"<0, {d()}, 0>", f"<0, -{d()}, 0>", f"<0, 0, {d()}>", f"<0, 0, -{d()}>"]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    one = lambda f: f"smooth_triangle {{ {', '.join(f'{c[i]}, {c[i]}' for i in f)} }}" if r.chance(.3) else f"triangle {{ {', '.join(c[i] for i in f)} }}"
    return "", "mesh", lines(*map(one, faces), f"inside_vector {r.pick('x', 'y', '<.3, 1, .2>')}")


def bezier_prism(r):
    """Outlines of two to four curves, closed, with open ends or cut to a cone."""
    corners = [(float(p[1:-1].split(",")[0]), float(p[1:-1].split(",")[1])) for p in solids.outline(r, r.whole(2, 4) + 1, .5, 1)]
    points = []
    for at, a in enumerate(corners):
        b = corners[(at + 1) % len(corners)]
        bend = lambda share: f"<{a[0] + (b[0] - a[0]) * share + r.real(-.2, .2):.3f}, {a[1] + (b[1] - a[1]) * share + r.real(-.2, .2):.3f}>"
        points += [f"<{a[0]:g}, {a[1]:g}>", bend(.3), bend(.7), f"<{b[0]:g}, {b[1]:g}>"]
    sweep = r.pick("linear_sweep", "conic_sweep")
    heights = f"{r.num(-.5, 0)}, {r.num(.3, .8)}" if sweep == "linear_sweep" else f"{r.num(.1, .5)}, {r.num(.7, 1.1)}"
    return "", "prism", lines(sweep, "bezier_spline", f"{heights}, {len(points)},", ", ".join(points), r.some(.2, "open"), r.some(.2, "sturm"))


def triangle(r):
    before, word, body = solids.triangle(r)
    return before, word, lines(body, block("interior_texture", common.pigment(r), common.finish(r)))


def julia(r):
    c = f"<{r.num(-.3, .1)}, {r.num(0, .6)}, {r.num(-.5, 0)}, {r.num(-.1, .1)}>"
    function = r.pick("sqr", "cube", "sin", "cos")  # of the others every second digit shows in 3.7, too
    return "", "julia_fractal", lines(c, "hypercomplex", function, f"max_iteration {r.whole(4, 8)}", f"precision {r.whole(10, 40)}", r.some(.3, f"slice <{r.num(-.2, .2)}, 0, 0, 1>, {r.num(-.3, .3)}"))


NEW = (lemon, lemon, lemon, ovus, ovus, ovus, torus, torus, torus, isosurface, mesh, bezier_prism, triangle, julia)
BOUNDLESS = ("triangle", "smooth_triangle")
CLOSED = (*solids.CLOSED, "lemon", "mesh")


def look(r, word):
    if r.chance(.8) or word in solids.CLEARLESS:
        return lines(common.pigment(r), common.finish(r))
    return lines(f"pigment {{ rgbt <{r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(.3, .8)}> }}", r.some(.5, f"interior {{ ior {r.num(1, 1.6)} }}"))


def clip(r):
    """An object to clip or to bound with."""
    word, body = r.pick(("plane", f"{r.pick('x', 'y', '-y', '-z', '<1, 1, 0>')}, {r.num(-.2, .4)}"), ("sphere", f"<{r.num(-.4, .4)}, {r.num(-.2, .4)}, {r.num(-.4, .4)}>, {r.num(.5, 1)}"),
                        ("box", f"{r.vec(-.8, -.3)}, {r.vec(.2, .8)}"), (lambda made: made[1:])(r.pick(lemon, torus, ovus)(r)))
    return f"{word} {{ {body} {r.some(.25, 'inverse')} }}"


def solid(r, kind):
    before, word, body = kind(r)
    closed = word in CLOSED
    modifiers = lines(r.some(.15, "inverse") if closed else "", r.some(.2, f"clipped_by {{ {clip(r)} }}"), r.some(.1, f"bounded_by {{ {r.pick('box { -2.5, 2.5 }', 'sphere { 0, 2.5 }', 'clipped_by')} }}"),
                      r.some(.1, "hollow") if closed else "", r.some(.1, "no_shadow"), r.some(.1, "double_illuminate"))
    if "clipped_by {" not in modifiers:
        modifiers = modifiers.replace("bounded_by { clipped_by }", "")
    uv = r.some(.1, "uv_mapping")
    return before, word, lambda *more: block(word, body, uv, look(r, word), modifiers, *more)


def turn(r):
    return lines(r.some(.7, f"rotate {r.vec(-180, 180)}"), r.some(.25, f"scale {r.vec(.6, 1.3)}"), r.some(.08, "matrix <1, .2, 0, -.1, 1, .3, 0, .1, 1, 0, 0, 0>"), f"translate {r.box((-1, 1), (-.2, .5), (-.8, .8))}")


def thing(r):
    before, word, one = solid(r, r.pick(*NEW))
    if word not in CLOSED or r.chance(.55):
        return lines(before, one(turn(r)))
    before2, word2, other = solid(r, r.pick(*NEW, *(plain,) * 8))
    if word2 not in CLOSED:
        before2, word2, other = solid(r, plain)
    apart = f"translate {r.box((-.5, .5), (-.4, .4), (-.5, .5))}"
    operator = r.pick("difference", "difference", "intersection", "union", "merge")
    first, second = one(), other(apart)
    turned = r.some(.12, "inverse")
    if "rgbt" in first + second:  # whole CSG turned inside out: light through clear parts of it is an open question of 3.7, too
        turned = ""
    return lines(before, before2, block(operator, first, second, r.some(.3, look(r, word)), r.some(.1, "cutaway_textures") if operator in ("difference", "intersection") else "", turned, r.some(.12, f"clipped_by {{ {clip(r)} }}"), turn(r)))


def plain(r):
    """No quadric: of what is subtracted POV-Ray 3.8 takes the box for one of the whole (spec 7c, 9)."""
    made = solids.plain(r)
    return made if made[1] != "quadric" else ("", "sphere", f"0, {r.num(.5, .9)}")
