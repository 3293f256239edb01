"""Glass and filled things that are declared once and placed often: nested, overlapping, in CSG, with interiors of their own or their parents'."""
from rng import block, lines
from scenes import lights
from words import common


def scene(r):
    names = ["Thing", "Other"]
    parts = [common.HEADER, common.camera(r), common.background(r), common.floor(r), common.light(r)]
    if r.chance(.4):
        parts += [f"#declare Inside = {interior(r)}"]
    else:
        parts += ["#declare Inside = interior { ior 1.3 }"]
    for at, name in enumerate(names):
        parts += [f"#declare {name} = {made(r, names[:at])}"]
    parts += [placed(r, names) for _ in range(r.whole(2, 4))]
    if r.chance(.5):
        parts += [common.thing(r, .5)]
    if r.chance(.3):
        parts += [repainted(r)]
    return lines(*parts)


def interior(r):
    return block("interior", r.some(.8, f"ior {r.num(.8, 1.6)}"),
                 r.some(.4, f"fade_distance {r.num(.3, 2)} fade_power {r.pick('1', '2', '1000')} fade_color {r.color()}"),
                 r.some(.15, f"caustics {r.num(.3, 1)}"), r.some(.1, f"dispersion {r.num(1, 1.1)} dispersion_samples {r.whole(2, 5)}"),
                 r.some(.15, f"media {{ method 3 intervals 1 samples 5, 5 {r.pick('absorption', 'emission')} {r.color(0, .7)} }}"))


def look(r):
    """A pigment light passes, an interior or none, a finish."""
    return lines(lights.see_through(r) if r.chance(.85) else common.pigment(r),
                 r.pick("", interior(r), interior(r), "interior { Inside }", f"interior {{ Inside ior {r.num(1, 1.6)} }}"),
                 block("finish", r.some(.3, f"reflection {r.num(.05, .3)}"), r.some(.2, f"specular {r.num(.2, .8)}"),
                       r.some(.1, f"ior {r.num(1, 1.5)}")), r.some(.3, "hollow"))


def made(r, known):
    if r.chance(.5):
        word, body = common.solid(r, .9)
        return block(word, body, look(r))
    operands = [f"object {{ {r.pick(*known)} {common.place(r, .4)} }}" if known and r.chance(.5) else piece(r) for _ in range(r.whole(2, 3))]
    return block(r.pick("union", "union", "merge", "intersection", "difference"), *operands, r.some(.6, look(r)))


def piece(r):
    word, body = common.solid(r, .9)
    return block(word, body, r.some(.5, look(r)), common.place(r, .3))


def placed(r, names):
    name = r.pick(*names)
    near = f"scale {r.num(.4, 1.4)} translate {r.vec(-.3, .3)}" if r.chance(.6) else common.place(r, 1)
    if r.chance(.15):
        return block(r.pick("union", "merge", "difference"), f"object {{ {name} }}", f"object {{ {name} {near} }}", r.some(.3, look(r)))
    return block("object", name, near, r.some(.2, look(r)), r.some(.1, "hollow"))


def pattern(r):
    """A pigment that may change what stands there: without a map as often as not."""
    return block("pigment", r.pick("rgb <.3, .6, .9>", "bozo", "agate", "gradient y", "checker", "wood", "marble", "radial", "leopard", "brick"),
                 r.some(.4, move(r)))


def move(r):
    return r.pick(f"translate {r.vec(-.5, .5)}", f"scale {r.num(.2, 1.5)}", f"rotate {r.vec(-90, 90)}", "")


def repainted(r):
    """Textures whose pigments are written anew, before and after they and what they are on have moved."""
    word, body = common.solid(r, .7)
    look = block("texture", pattern(r), move(r), r.some(.5, pattern(r)), move(r))
    once = r.pick("texture { Look }", block("texture", "Look", r.some(.7, pattern(r)), move(r)), pattern(r))
    return lines(f"#declare Look = {look}", f"#declare Painted = {block(word, body, once, move(r), r.some(.5, pattern(r)))}",
                 block("object", "Painted", move(r), r.some(.6, pattern(r)), common.place(r)))
