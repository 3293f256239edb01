"""Finishes and interiors: every parameter of both, mirrors, glass, layers, inner textures, flags of objects."""
from rng import block, lines
from words import common


def scene(r):
    settings = block("global_settings", "assumed_gamma 1", r.some(.2, f"ambient_light {r.color()}"),
                     r.some(.3, f"max_trace_level {r.whole(1, 12)}"), r.some(.15, f"adc_bailout {r.num(0, .1)}"),
                     r.some(.15, f"irid_wavelength rgb {r.vec(.2, .8)}"))
    parts = ["#version 3.7;", settings, common.camera(r), common.background(r), common.floor(r, r.some(.4, finish(r)))]
    parts += [common.light(r) for _ in range(r.whole(1, 2))]
    parts += [thing(r) for _ in range(r.whole(2, 4))]
    return lines(*parts)


def thing(r):
    word, body = common.solid(r, .9)
    glass = r.chance(.45)
    look = [texture(r, glass)]
    if r.chance(.15):
        look += [texture(r, True)]
    if r.chance(.1):
        look = [f"material {{ {lines(*look)} {interior(r)} }}"]
    elif glass or r.chance(.1):
        look += [interior(r)]
    if r.chance(.12):
        look += [block("interior_texture", pigment(r, r.chance(.5)), finish(r))]
    flags = [r.some(.06, "no_shadow"), r.some(.05, "no_image"), r.some(.06, "no_reflection"), r.some(.08, "double_illuminate"),
             r.some(.08, "hollow")]
    return block(word, body, *look, *flags, common.place(r, 1.3))


def texture(r, clear):
    normal = r.some(.15, f"normal {{ {r.pick('bumps', 'ripples', 'wrinkles', 'dents')} {r.num(.1, .6)} scale {r.num(.2, .6)} }}")
    return block("texture", pigment(r, clear), normal, finish(r))


def pigment(r, clear):
    if not clear:
        return common.pigment(r)
    color = r.vec(.3, 1)[1:-1]
    kind = r.pick(f"rgbf <{color}, {r.num(.3, 1)}>", f"rgbt <{color}, {r.num(.3, 1)}>", f"rgbft <{color}, {r.num(.2, .6)}, {r.num(.1, .4)}>")
    return r.pick(f"pigment {{ {kind} }}", f"pigment {{ {kind} }}", f"pigment {{ checker {kind} {r.color()} scale .4 }}")


def finish(r):
    """A finish of everything but crand, which is random, and subsurface."""
    body = [r.some(.4, f"ambient {r.pick(r.num(0, .4), r.color(0, .3))}"),
            r.some(.6, f"diffuse {r.some(.2, 'albedo ')}{r.num(.2, 1)}{r.some(.15, ', ' + r.num(0, .6))}"),
            r.some(.15, f"emission {r.pick(r.num(0, .4), r.color(0, .4))}"), r.some(.2, f"brilliance {r.num(.2, 5)}")]
    if r.chance(.35):
        body += [f"phong {r.some(.2, 'albedo ')}{r.num(.1, 1)}", r.some(.7, f"phong_size {r.num(1, 120)}")]
    if r.chance(.35):
        body += [f"specular {r.some(.2, 'albedo ')}{r.num(.1, 1)}", r.some(.7, f"roughness {r.pick(r.num(.001, .02), r.num(.02, .3))}")]
    body += [r.some(.25, "metallic" + r.some(.5, f" {r.num(0, 1)}"))]
    if r.chance(.4):
        body += [reflection(r), r.some(.4, "conserve_energy")]
        body += [r.some(.15, f"reflection_exponent {r.num(.4, 2)}") if "{" not in body[-2] else ""]
    if r.chance(.15):
        body += [block("irid", r.num(.1, .7), r.some(.8, f"thickness {r.num(.05, 1)}"), r.some(.6, f"turbulence {r.num(0, 1)}"))]
    return block("finish", *body)


def reflection(r):
    if r.chance(.4):
        return f"reflection {r.pick(r.num(.1, .9), r.color(0, .9))}"
    return block("reflection", r.pick(r.num(.1, .9), r.color(0, .9), f"{r.num(0, .4)}, {r.num(.4, 1)}", f"{r.color(0, .4)}, {r.color(.4, 1)}"),
                 r.some(.3, f"fresnel {r.pick('on', 'off')}"), r.some(.3, f"falloff {r.num(.5, 6)}"), r.some(.3, f"exponent {r.num(.4, 2)}"),
                 r.some(.3, "metallic" + r.some(.4, f" {r.num(0, 1)}")))


def interior(r):
    body = [r.some(.85, f"ior {r.pick(r.num(1.05, 2.4), r.num(1.05, 2.4), r.num(.5, .95))}"), r.some(.3, f"caustics {r.num(0, 3)}")]
    if r.chance(.35):
        body += [f"fade_distance {r.num(.1, 3)}", r.some(.9, f"fade_power {r.pick('1', '2', '3', '1000', '1500', '.5')}"), r.some(.5, f"fade_color {r.color()}")]
    if r.chance(.12) and "ior" in body[0]:
        body += [f"dispersion {r.num(.95, 1.15)}", r.some(.6, f"dispersion_samples {r.whole(2, 12)}")]
    return block("interior", *body)
