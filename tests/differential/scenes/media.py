"""Media in objects and everywhere: densities, kinds of scattering, ways of sampling, what holds them, and the lights in them.
Nothing that POV-Ray samples at random."""
from rng import block, lines
from scenes import lights
from words import common, patterns


def scene(r):
    settings = block("global_settings", "assumed_gamma 1", r.some(.2, f"max_trace_level {r.whole(3, 9)}"))
    version = r.pick("3.7", "3.7", "3.7", "3.6", "3.1")
    parts = [f"#version {version};", patterns.NOISE, settings, common.camera(r), r.some(.7, common.background(r)), r.some(.85, common.floor(r))]
    parts += [lamp(r) for _ in range(r.whole(1, 3))]
    parts += [common.thing(r, .6) for _ in range(r.whole(0, 2))]
    parts += [holder(r) for _ in range(r.whole(1, 3))]
    if r.chance(.3):
        parts += [media(r, everywhere=True) for _ in range(r.whole(1, 2))]
    if r.chance(.15):
        parts += [lights.fog(r)]
    return lines(*parts)


def lamp(r):
    """A light, most of them of a kind that reaches only part of a ray."""
    body = [f"{r.box((-6, 6), (2, 7), (-6, 3))}, {r.color(.5, 1.4)}"]
    kind = r.pick("", "", "spotlight", "spotlight", "cylinder", "parallel", "area", "shadowless")
    if kind in ("spotlight", "cylinder"):
        body.append(lights.spot(r, kind))
    elif kind == "area":
        body.append(lights.area(r))
    elif kind:
        body.append(kind)
    body += [r.some(.3, f"fade_distance {r.num(2, 9)} fade_power {r.pick('1', '2')}"), r.some(.12, "media_interaction off"),
             r.some(.35, f"media_attenuation {r.pick('on', 'on', 'off')}")]
    return block("light_source", *body)


def holder(r):
    """Something clear that is filled."""
    kind = r.whole(0, 5)
    look = block("texture", "pigment { " + r.pick("rgbt 1", "rgbt 1", "rgbf 1", "rgbf <.9, .7, .8, .8>", "rgbt <.4, .6, 1, .7>") + " }",
                 "finish { ambient 0 diffuse 0" + r.some(.2, " reflection .2") + " }")
    hollow = r.some(.9, "hollow")
    if kind < 3:
        word, body = common.solid(r, r.real(.8, 1.6))
        return block(word, body, look, inside(r), hollow, common.place(r), r.some(.06, "no_shadow"))
    parts = [block(*common.solid(r, r.real(.7, 1.2)), r.some(.25, inside(r)), common.place(r, .6)) for _ in range(2)]
    return block(r.pick("union", "merge", "difference", "intersection"), *parts, look, inside(r), hollow, common.place(r))


def inside(r):
    return block("interior", *(media(r) for _ in range(r.pick(1, 1, 1, 2, 3))), r.some(.15, f"ior {r.num(1, 1.6)}"),
                 r.some(.1, f"fade_distance {r.num(.5, 3)} fade_power {r.pick('1', '2', '1001')}"))


def media(r, everywhere=False):
    strength = .12 if everywhere else 1.2
    body = r.few(1, 3, [f"emission {amount(r, strength)}", f"absorption {amount(r, strength)}", scattering(r, strength), scattering(r, strength)])
    body += [sampling(r)]
    body += [density(r) for _ in range(r.pick(0, 1, 1, 1, 2))]
    body += [r.some(.25, patterns.move(r))]
    return block("media", *body)


def amount(r, strength):
    return r.pick(r.color(0, strength), f"rgb {r.num(0, strength)}")


def scattering(r, strength):
    kind = r.whole(1, 5)
    return f"scattering {{ {kind}, {amount(r, strength)} {r.some(.7, f'eccentricity {r.num(-.8, .8)}') if kind == 5 else ''} {r.some(.4, f'extinction {r.num(0, 1.5)}')} }}"


def sampling(r):
    """Methods 2 and 3 without jitter, and never more samples than the least."""
    if r.chance(.3):
        return f"method 2 samples {r.whole(1, 9)} intervals {r.whole(1, 5)} " + r.some(.3, f"ratio {r.num(.1, .95)}")
    return "method 3 " + r.some(.6, f"samples {r.whole(1, 14)} ") + r.some(.4, f"intervals {r.whole(1, 3)} ") \
        + r.some(.4, f"aa_level {r.whole(1, 4)} ") + r.some(.4, f"aa_threshold {r.pick('.3', '.1', '.03')} ") + r.some(.3, f"ratio {r.num(.1, .95)}")


def density(r):
    pattern = r.pick("spherical", "spherical scale 1.5", "cylindrical", "planar", "boxed", "bozo", "granite", "wrinkles", "agate", "crackle", "marble",
                     "gradient y", "onion", "spiral1 3", "leopard", "wood", "radial", "cells", f"function {{ {patterns.formula(r)} }}",
                     "density_file df3 \"density.df3\" interpolate 1 translate -.5 scale 2", "density_file df3 \"density.df3\" translate -.5 scale 2")
    if r.chance(.08):
        return block("density", r.pick(r.color(0, 1.5), f"rgb {r.num(.3, 2)}"))
    steps = sorted(r.real(0, 1) for _ in range(r.whole(1, 3)))
    entries = " ".join(f"[{at:g} rgb {r.pick(r.num(0, 1.4), '0', r.vec(0, 1.2))}]" for at in (0, *steps, 1))
    return block("density", pattern, r.some(.75, f"color_map {{ {entries} }}"),
                 r.some(.5, patterns.modifiers(r)))
