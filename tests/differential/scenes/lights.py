"""All kinds of lights with all their parameters, and air: fogs, skies and background."""
from rng import block, lines
from words import common


def scene(r):
    settings = block("global_settings", "assumed_gamma 1", r.some(.2, f"ambient_light {r.color()}"),
                     r.some(.1, f"max_trace_level {r.whole(1, 8)}"), r.some(.1, f"adc_bailout {r.num(0, .05)}"))
    parts = ["#version 3.7;", settings, common.camera(r), r.some(.8, common.background(r)), common.floor(r, r.some(.5, common.finish(r)))]
    parts += [light(r) for _ in range(r.whole(1, 3))]
    parts += [thing(r) for _ in range(r.whole(2, 5))]
    if r.chance(.25):
        parts += [fog(r) for _ in range(r.whole(1, 2))]
    if r.chance(.2):
        parts += [sky(r)]
    return lines(*parts)


def light(r):
    where = r.box((-7, 7), (3, 8), (-8, 1))
    body = [f"{where}, {r.color(.4, 1.1)}"]
    cone = r.pick("", "", "spotlight", "spotlight", "cylinder")
    if cone:
        body.append(spot(r, cone))
    if r.chance(.35):
        body.append(area(r))
    if r.chance(.2):
        body.append("parallel" + r.some(.7, f" point_at {r.vec(-1, 1)}") if not cone else "parallel")
    if r.chance(.12):
        body.append("shadowless")
    if r.chance(.35):
        body.append(f"fade_distance {r.num(1, 14)}" + r.some(.85, f" fade_power {r.pick('1', '2', '3', '1.5', '.5', '0', '1000')}"))
    if r.chance(.08):
        body.append(f"projected_through {{ cylinder {{ <0, 2, 0>, <0, 2.1, 0>, {r.num(.3, 3)} }} }}")
    if r.chance(.12):
        body.append(f"looks_like {{ sphere {{ 0, {r.num(.1, .5)} {common.pigment(r)} finish {{ ambient 1 }} }} }}")
    if r.chance(.15):
        body.append(r.pick(f"translate {r.vec(-1, 1)}", f"rotate {r.vec(-30, 30)}", f"scale {r.num(.6, 1.3)}",
                           f"rotate y*{r.num(-90, 90)} translate {r.vec(-1, 1)}", f"scale {r.vec(.5, 1.5)}"))
    return block("light_source", *body)


def spot(r, word):
    radius = r.real(3, 30)
    return " ".join([word, r.some(.9, f"radius {radius if word == 'spotlight' else r.num(.4, 2)}"),
                     r.some(.9, f"falloff {r.num(max(radius - 2, 3), 45) if word == 'spotlight' else r.num(.8, 4)}"),
                     r.some(.6, f"tightness {r.pick('0', '1', '10', '100', '.5', r.num(0, 50))}"),
                     r.some(.9, f"point_at {r.box((-1, 1), (-1, .5), (-1, 1))}")])


def area(r):
    """An area light without jitter, whose points POV-Ray moves at random."""
    axes = r.pick(("x", "z"), ("x", "y"), ("<1, 0, .5>", "<-.5, 0, 1>"), ("y", "z"), ("<1, .3, 0>", "<0, .4, 1>"))
    count = r.pick((1, 3), (2, 2), (3, 3), (4, 2), (5, 5), (9, 9), (17, 17), (3, 6))
    circular = r.chance(.3) and min(count) > 1
    size = r.num(.5, 4)
    return " ".join([f"area_light {axes[0]}*{size}, {axes[1]}*{size}, {count[0]}, {count[1]}",
                     r.some(.5, f"adaptive {r.whole(0, 4)}"), "circular" if circular else "",
                     "orient" if circular and r.chance(.6) else "", r.some(.3, f"area_illumination {r.pick('on', 'on', 'off')}")])


def thing(r):
    word, body = common.solid(r, .8)
    return block(word, body, see_through(r) if r.chance(.2) else common.pigment(r), common.finish(r), common.place(r),
                 r.some(.1, "no_shadow"), r.some(.1, "double_illuminate"), r.some(.08, "hollow"))


def see_through(r):
    return f"pigment {{ rgbft <{r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(0, .6)}, {r.num(0, .4)}> }}"


def fog(r):
    color = r.pick(r.color(.4, 1), f"rgbf <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, .8)}>",
                   f"rgbt <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, .8)}>",
                   f"rgbft <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, .5)}, {r.num(0, .5)}>")
    body = [f"distance {r.num(2, 25)}", color]
    if r.chance(.5):
        body += ["fog_type 2", f"fog_offset {r.num(-1.5, .5)}", f"fog_alt {r.num(.1, 2)}",
                 r.some(.3, f"up {r.pick('x', 'z', '<.3, 1, .2>', '-y')}")]
    if r.chance(.4):
        body += [f"turbulence {r.pick(r.num(0, 1), r.vec(0, 1))}", f"turb_depth {r.num(0, 1)}", r.some(.4, f"octaves {r.whole(1, 8)}"),
                 r.some(.3, f"omega {r.num(.2, .8)}"), r.some(.3, f"lambda {r.num(1.5, 3)}")]
    body += [r.some(.2, r.pick(f"scale {r.num(.5, 2)}", f"rotate {r.vec(-40, 40)}", f"translate {r.vec(-1, 1)}"))]
    return block("fog", *body)


def sky(r):
    layers = [block("pigment", r.pick("gradient y", "bozo", "agate", "wrinkles", "gradient <1, 1, 0>", "granite", "spherical"),
                    f"color_map {{ [0 {r.color()}] [{r.num(.3, .6)} {r.color()}] [1 rgbt <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {layer * r.real(0, 1):g}>] }}",
                    r.some(.5, f"scale {r.num(.2, 2)}"), r.some(.3, f"turbulence {r.num(0, 1)}"), r.some(.3, f"translate {r.vec(-1, 1)}"))
              for layer in range(r.whole(1, 2))]
    return block("sky_sphere", *layers, r.some(.2, f"emission {r.color(.3, 1)}"), r.some(.3, f"rotate {r.vec(-90, 90)}"))
