"""Scenes as they were written for POV-Ray 1.0 to 3.5: what #version changes, and words that have had others since."""
from rng import block, lines
from words import common


def scene(r):
    version = r.pick("1.0", "2.0", "3.0", "3.1", "3.5", "3.1", "3.0", "")
    number = float(version or 1)
    parts = [f"#version {version}" + (";" if number >= 3.1 else "") if version else "", camera(r), r.some(.8, f"background {{ {color(r)} }}"),
             r.some(.4, settings(r, number))]
    parts += [light(r) for _ in range(r.whole(1, 2))]
    parts += [r.some(.3, fog(r)), floor(r, number)]
    parts += [thing(r, number) for _ in range(r.whole(2, 4))]
    return lines(*parts)


def camera(r):
    return block("camera", f"location {r.box((-3, 3), (.5, 3), (-6, -4))}", r.some(.4, f"direction <0, 0, {r.num(1, 2)}>"), r.some(.3, "up <0, 1, 0>"),
                 r.some(.4, "right <1.33, 0, 0>"), r.some(.2, "sky <0, 1, 0>"), f"look_at {r.vec(-.4, .4)}")


def settings(r, number):
    return block("global_settings", r.some(.5, f"assumed_gamma {r.pick('1', '1.8', '2.2')}"), r.some(.3, f"ambient_light {color(r)}"), r.some(.3, f"max_trace_level {r.whole(2, 7)}"),
                 r.some(.3, f"adc_bailout {r.num(0, .05)}"), r.some(.2, f"noise_generator {r.whole(1, 3)}") if number >= 3.5 else "")


def color(r):
    """In the ways of all times."""
    a, b, c, d = (r.num(0, 1) for _ in range(4))
    return r.pick(f"color red {a} green {b} blue {c}", f"color red {a} blue {b}", f"rgb <{a}, {b}, {c}>", f"color rgb <{a}, {b}, {c}>", f"rgb {a}", f"colour rgb <{a}, {b}, {c}>",
                  f"color red {a} green {b} blue {c} filter {d}" if r.chance(.2) else f"rgb <{a}, {b}, {c}>")


def second(r):
    """The second colour of an entry of a map, which wants the word."""
    return "color " + color(r).replace("color ", "").replace("colour ", "")


def light(r):
    where = r.box((-7, 7), (4, 9), (-8, -2))
    return block("light_source", where, f"color rgb {r.num(.5, 1.1)}",
                 r.some(.25, f"spotlight point_at <0, 0, 0> radius {r.num(5, 15)} falloff {r.num(16, 40)} tightness {r.num(0, 20)}"),
                 r.some(.15, f"area_light <2, 0, 0>, <0, 0, 2>, {r.whole(2, 4)}, {r.whole(2, 4)}" + r.some(.4, " adaptive 1")), r.some(.2, f"fade_distance {r.num(3, 10)} fade_power {r.pick('1', '2')}"))


def fog(r):
    return block("fog", f"distance {r.num(5, 30)}", color(r), r.some(.3, "fog_type 2 fog_offset -.5 fog_alt .5"))


def floor(r, number):
    return block("plane", "<0, 1, 0>, -1", texture(r, number))


def thing(r, number):
    word, body = common.solid(r, .9)
    bounds = r.some(.1, "bounded_by { sphere { <0, 0, 0>, 2 } }")
    if r.chance(.25):
        other, other_body = common.solid(r, .8)
        word, body = r.pick("union", "intersection", "difference", "merge" if number >= 2 else "union"), lines(f"{word} {{ {body} }}", f"{other} {{ {other_body} translate {r.vec(-.4, .4)} }}")
    return block(word, body, bounds, *(texture(r, number) for _ in range(2 if r.chance(.2) else 1)), common.place(r, 1.3))


def texture(r, number):
    body = [pigment(r, number), r.some(.3, normal(r)), r.some(.7, finish(r, number)), r.some(.2, f"scale {r.num(.4, 2)}"), r.some(.1, f"rotate {r.vec(-90, 90)}")]
    return block("texture", *body)


def pigment(r, number):
    if r.chance(.35):
        clear = r.some(.5, f" {r.pick('filter', 'alpha') if number < 3 else r.pick('filter', 'transmit')} {r.num(.2, 1)}")
        return f"pigment {{ color red {r.num(0, 1)} green {r.num(0, 1)} blue {r.num(0, 1)}{clear} }}"
    pattern = r.pick("agate", "bozo", "granite", "leopard", "marble", "onion", "radial", "spotted", "wood", "wrinkles", "gradient x", "gradient <0, 1, 0>", "crackle", "bumps", "dents",
                     "mandel 20", "checker", "hexagon", "brick")
    if pattern in ("checker", "hexagon", "brick"):
        count = 3 if pattern == "hexagon" else 2
        return block("pigment", f"{pattern} " + ", ".join(color(r) for _ in range(count)), r.some(.5, f"scale {r.num(.2, .7)}"))
    middle = r.num(.2, .8)
    entries = r.made(lambda: [f"[0 {color(r)}]", f"[{middle} {color(r)}]", f"[1 {color(r)}]"],
                     lambda: [f"[0, {middle} {color(r)} {second(r)}]", f"[{middle}, {r.pick('1', '1.001')} {color(r)} {second(r)}]"])
    return block("pigment", pattern, r.some(.85, block(r.pick("color_map", "colour_map"), *entries)), r.some(.4, f"turbulence {r.pick(r.num(0, 1), r.vec(0, 1))}"),
                 r.some(.2, f"octaves {r.whole(1, 7)}"), r.some(.2, f"frequency {r.num(.5, 4)}"), r.some(.2, f"phase {r.num(0, 1)}"), r.some(.2, f"quick_color {color(r)}"), f"scale {r.num(.2, 1)}")


def normal(r):
    return block("normal", f"{r.pick('bumps', 'dents', 'ripples', 'waves', 'wrinkles')} {r.num(.1, .8)}", r.some(.4, f"frequency {r.num(.5, 5)}"), r.some(.3, f"phase {r.num(0, 1)}"),
                 r.some(.3, f"turbulence {r.num(0, .6)}"), f"scale {r.num(.2, 1)}")


def finish(r, number):
    body = [r.some(.5, f"ambient {r.num(0, .5)}"), r.some(.6, f"diffuse {r.num(.2, 1)}"), r.some(.2, f"brilliance {r.num(.5, 4)}"), r.some(.3, f"phong {r.num(.1, 1)} phong_size {r.num(5, 90)}"),
            r.some(.3, f"specular {r.num(.1, 1)} roughness {r.num(.005, .1)}"), r.some(.3, f"reflection {r.num(.05, .6)}"), r.some(.15, "metallic")]
    if number < 3.5:
        body += [r.some(.3, f"refraction {r.pick('1', r.num(.3, 1))} ior {r.num(1.05, 1.8)}"), r.some(.1, f"caustics {r.num(.1, 1)}")]
    return block("finish", *body)
