"""Glass, media and fog in one another: containers that are hollow or not, nested, cut and merged, cameras and lights inside of them."""
from rng import block, lines
from scenes import lights, media
from words import common, patterns


def scene(r):
    settings = block("global_settings", "assumed_gamma 1", r.some(.3, f"max_trace_level {r.whole(3, 12)}"), r.some(.1, f"adc_bailout {r.num(0, .05)}"))
    parts = ["#version " + r.pick("3.7", "3.7", "3.6") + ";", patterns.NOISE, settings, camera(r), r.some(.8, common.background(r)), r.some(.8, floor(r))]
    parts += [f"#declare Filled = {body(r)}", f"#declare Clear = {body(r)}"]
    parts += [lamp(r) for _ in range(r.whole(1, 2))]
    parts += [common.thing(r, .5) for _ in range(r.whole(0, 2))]
    parts += [holder(r) for _ in range(r.whole(1, 3))]
    parts += [around(r)] if r.chance(.35) else []
    parts += [air(r), f"sphere {{ 0, 40 pigment {{ {r.color()} }} finish {{ ambient 1 diffuse 0 }} hollow }}"] if r.chance(.4) else []
    return lines(*parts)


def camera(r):
    return block("camera", r.some(.12, "orthographic"), f"location {r.box((-2, 2), (.3, 2), (-5, -3))}", f"look_at {r.box((-.4, .4), (-.5, .3), (-.4, .4))}", f"angle {r.num(35, 70)}")


def floor(r):
    return block("plane", "y, -1.2", f"pigment {{ checker {r.color(.3, 1)} {r.color(0, .6)} scale {r.num(.4, 1)} }}", r.some(.3, "hollow"), r.some(.1, "inverse"),
                 r.some(.1, f"interior {{ ior {r.num(1, 1.3)} }}"))


def lamp(r):
    """Some stand in the middle of things."""
    where = r.vec(-.6, .6) if r.chance(.25) else r.box((-6, 6), (2, 7), (-6, 3))
    return block("light_source", f"{where}, {r.color(.5, 1.3)}", r.some(.3, f"fade_distance {r.num(1, 6)} fade_power {r.pick('1', '2')}"), r.some(.4, f"media_attenuation {r.pick('on', 'off')}"),
                 r.some(.15, "media_interaction off"), r.some(.1, "shadowless"), r.some(.15, lights.spot(r, "spotlight")))


def air(r):
    """What fills everything, one or two of it."""
    return r.made(lambda: lights.fog(r), lambda: lights.fog(r), lambda: media.media(r, everywhere=True), lambda: lights.fog(r) + "\n" + media.media(r, everywhere=True),
                  lambda: f"fog {{ distance {r.num(4, 20)} rgbft <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, .3)}, {r.num(0, .4)}> }}")


def look(r):
    pigment = r.made(lambda: "pigment { rgbt 1 }", lambda: "pigment { rgbf 1 }", lambda: lights.see_through(r), lambda: lights.see_through(r),
                     lambda: f"pigment {{ checker rgbt <{r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(.3, 1)}> {r.color()} scale .4 }}")
    finish = block("finish", r.some(.5, "ambient 0"), r.some(.4, f"diffuse {r.num(0, .5)}"), r.some(.3, f"reflection {r.num(.05, .3)}"), r.some(.1, f"reflection {{ 0, 1 fresnel }}"),
                   r.some(.2, f"specular {r.num(.2, .8)}"), r.some(.1, "conserve_energy"))
    return block("texture", pigment, finish)


def interior(r):
    return block("interior", r.some(.7, f"ior {r.num(.8, 1.7)}"), r.some(.5, f"fade_distance {r.num(.2, 2)} fade_power {r.pick('1', '2', '1000', '1001')}" + r.some(.6, f" fade_color {r.color()}")),
                 r.some(.15, f"caustics {r.num(.2, 1)}"), r.some(.12, f"dispersion {r.num(1, 1.1)} dispersion_samples {r.whole(2, 6)}"), *(media.media(r) for _ in range(r.pick(0, 0, 1, 1, 2))))


def dress(r):
    inner = f"interior_texture {{ {r.made(lambda: common.pigment(r), lambda: lights.see_through(r))} }}"
    outer = r.some(.85, look(r))
    return lines(outer, r.some(.75, interior(r)), r.some(.5, r.pick("hollow", "hollow", "hollow on", "hollow off", "hollow no")), r.some(.1, inner) if outer else "")


def body(r):
    if r.chance(.5):
        return block(*common.solid(r, .9), dress(r))
    parts = [block(*common.solid(r, .8), r.some(.5, dress(r)), f"translate {r.vec(-.5, .5)}") for _ in range(r.whole(2, 3))]
    return block(r.pick("union", "merge", "merge", "difference", "intersection"), *parts, dress(r))


def holder(r):
    kind = r.whole(0, 4)
    turn = f"rotate {r.vec(-180, 180)} translate {r.vec(-.7, .7)}"
    if kind == 0:
        return block("object", r.pick("Filled", "Clear"), turn, r.some(.4, dress(r)))
    if kind == 1:
        return lines(block("object", "Filled", turn, f"scale {r.num(1, 1.4)}"), block("object", "Clear", turn, f"scale {r.num(.4, .7)}"))
    if kind == 2:
        return block(r.pick("union", "merge", "difference", "intersection"), block("object", "Filled", r.some(.4, r.pick("hollow", "hollow off"))),
                     block("object", "Clear", f"scale {r.num(.6, 1.2)} translate {r.vec(-.6, .6)}", r.some(.3, r.pick("hollow", "hollow off"))), r.some(.4, dress(r)), turn)
    return block(*common.solid(r, r.real(.7, 1.4)), dress(r), common.place(r, 1), r.some(.06, "no_shadow"), r.some(.05, "inverse"))


def around(r):
    """One that the camera is in."""
    word = r.pick(f"sphere {{ 0, {r.num(6, 9)}", f"box {{ <-7.137, -{r.num(.8, 2)}, -7.591>, <7.219, {r.num(5, 9)}, 7.093>", f"plane {{ y, {r.num(.5, 4)}")
    return word + " " + dress(r) + " " + r.pick("hollow", "hollow", "", "hollow off") + " }"
