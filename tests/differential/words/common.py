"""What scenes of several classes share: a stage to stand on, plain solids, colours, finishes, places."""
from rng import block, lines

HEADER = "#version 3.7;\nglobal_settings { assumed_gamma 1 }"


def camera(r):
    """An ordinary camera above the floor at y = -1, some units before the origin."""
    return block("camera", f"location {r.box((-3, 3), (.5, 3), (-6, -4))}",
                 f"look_at {r.box((-.4, .4), (-.5, .3), (-.4, .4))}", f"angle {r.num(35, 60)}")


def light(r):
    """An ordinary point light."""
    return f"light_source {{ {r.box((-8, 8), (4, 9), (-9, -3))}, {r.color(.6, 1)} }}"


def background(r):
    return f"background {{ {r.color(.1, .8)} }}"


def floor(r, finish=""):
    return block("plane", "y, -1", f"pigment {{ checker {r.color(.3, 1)} {r.color(0, .6)} scale {r.num(.4, 1)} }}", finish)


def solid(r, size=1.0):
    """Word and body of a solid of about `size` around the origin."""
    s = lambda low, high: r.num(low * size, high * size)
    v = lambda low, high: r.vec(low * size, high * size)
    kind = r.whole(0, 6)
    if kind == 0:
        return "sphere", f"0, {s(.6, 1)}"
    if kind == 1:
        return "box", f"{v(-.9, -.4)}, {v(.4, .9)}"
    if kind == 2:
        return "cylinder", f"{v(-.8, -.2)}, {v(.2, .8)}, {s(.25, .6)}" + r.some(.15, " open")
    if kind == 3:
        return "cone", f"{v(-.8, -.2)}, {s(.4, .8)}, {v(.2, .8)}, {s(0, .35)}" + r.some(.15, " open")
    if kind == 4:
        return "torus", f"{s(.5, .75)}, {s(.12, .3)} rotate <{r.num(-90, 90)}, 0, 0>"
    if kind == 5:
        return "superellipsoid", f"<{r.num(.2, 1.2)}, {r.num(.2, 1.2)}> scale {s(.5, .8)}"
    return "quadric", (f"<{r.num(.8, 2)}, {r.num(.8, 2)}, {r.num(.8, 2)}>, {r.vec(-.3, .3)}, {r.vec(-.2, .2)}, -.5"
                       f" scale {s(.8, 1)}")


def place(r, spread=1.5):
    """Transformations that put a solid somewhere on the stage."""
    return lines(r.some(.4, f"rotate {r.vec(-180, 180)}"), r.some(.25, f"scale {r.vec(.5, 1.4)}"),
                 r.some(.1, f"matrix < 1, {r.num(-.3, .3)}, 0, {r.num(-.3, .3)}, 1, 0, 0, {r.num(-.3, .3)}, 1, 0, 0, 0 >"),
                 f"translate {r.box((-spread, spread), (-.5, .7), (-spread, spread))}")


def pigment(r):
    """A plain opaque pigment."""
    return r.pick(f"pigment {{ {r.color()} }}", f"pigment {{ {r.color()} }}",
                  f"pigment {{ checker {r.color()} {r.color()} scale {r.num(.2, .5)} }}",
                  f"pigment {{ gradient {r.pick('x', 'y', 'z')} color_map {{ [0 {r.color()}] [1 {r.color()}] }} scale {r.num(.3, 1.2)} }}",
                  f"pigment {{ bozo color_map {{ [0 {r.color()}] [1 {r.color()}] }} scale {r.num(.3, .8)} }}")


def finish(r):
    """Highlights and light of its own; neither mirrors nor glass."""
    return block("finish", r.some(.5, f"ambient {r.num(0, .4)}"), r.some(.6, f"diffuse {r.num(.3, 1)}"),
                 r.some(.2, f"brilliance {r.num(.5, 4)}"),
                 r.some(.3, f"phong {r.num(.2, 1)} phong_size {r.num(5, 80)}"),
                 r.some(.3, f"specular {r.num(.2, 1)} roughness {r.num(.005, .1)}"), r.some(.15, "metallic"),
                 r.some(.1, f"emission {r.num(0, .3)}"), r.some(.15, f"reflection {r.num(.1, .6)}"))


def thing(r, size=1.0, spread=1.5):
    """A plain solid with a plain look."""
    word, body = solid(r, size)
    return block(word, body, pigment(r), finish(r), place(r, spread))


def things(r, low, high):
    return lines(*(thing(r, .8) for _ in range(r.whole(low, high))))
