"""Looks as POV-Ray 3.8 makes them: colours by functions, potentials, repeated cells, pictures by its rules, finishes of its own, and
the patterns, maps and layers that there were, with these among them."""
import re

from rng import block, lines
from scenes import coats, textures
from words import common, patterns

HEADER = "#version {};\nglobal_settings {{ assumed_gamma 1 }}"
FILES = (("png", "picture.png"), ("png", "alpha.png"), ("png", "gray.png"), ("png", "gray_alpha.png"), ("png", "deep.png"), ("png", "palette.png"), ("png", "palette_alpha.png"),
         ("ppm", "colors.ppm"), ("pgm", "grays.pgm"), ("tga", "colors.tga"), ("tga", "alpha.tga"), ("gif", "palette.gif"))


def scene(r):
    parts = [HEADER.format(r.pick("3.8", "3.8", "3.8", "3.8", "3.7")), patterns.NOISE, common.camera(r), common.light(r), r.some(.25, common.light(r)), common.background(r)]
    parts += [block("plane", "y, -1.037", r.made(lambda: pigment(r), lambda: common.pigment(r)))]
    parts += [thing(r) for _ in range(r.whole(1, 3))]
    parts += [r.some(.15, version_between(r))]
    return with_one_repeat(lines(*parts))


CRACKLE = re.compile(r"\bcrackle( -?[\d.]+)?( repeat (?:<[^<>]*>|[\d.]+))?")


def with_one_repeat(text):
    """Crackles of different `repeat` in one scene disturb each other in POV-Ray, by the order of its pixels (spec 7b, 4)."""
    first = next((found[2] for found in CRACKLE.finditer(text) if found[2]), "")
    return CRACKLE.sub(lambda found: f"crackle{found[1] or ''}{first}", text)


def version_between(r):
    """Defaults follow the version of the moment."""
    word, body = common.solid(r, .6)
    return lines(f"#version {r.pick('3.7', '3.6', '3.8')};", r.some(.4, f"#default {{ {r.pick(common.finish(r), common.pigment(r))} }}"), r.some(.3, "#version 3.8;"),
                 block(word, body, r.some(.5, common.pigment(r)), r.some(.3, "finish { specular .4 }"), common.place(r)))


def thing(r):
    word, body = common.solid(r, 1)
    return block(word, body, r.some(.12, "uv_mapping"), look(r), r.some(.6, f"interior {{ ior {r.num(1.05, 1.9)} }}"), common.place(r, 1.2), r.some(.08, "double_illuminate"))


def look(r):
    return r.made(*[lambda: lines(pigment(r), r.some(.4, normal(r)), r.some(.6, finish(r)))] * 3,
                  lambda: lines(block("texture", pigment(r), r.some(.3, normal(r)), r.some(.5, finish(r))),
                                *(block("texture", pigment(r, True), r.some(.3, normal(r)), r.some(.7, finish(r))) for _ in range(r.whole(1, 2)))),
                  lambda: texture(r), lambda: textures.look(r, 2), lambda: lines(common.pigment(r), normal(r), finish(r)), lambda: coats.coat(r))


def texture(r):
    """A texture of textures with looks of 3.8 in it."""
    entry = lambda: lines(pigment(r), r.some(.3, normal(r)), r.some(.5, finish(r)))
    if r.chance(.3):
        word, count = r.pick(("checker", 2), ("brick", 2), ("hexagon", 3), ("square", 4), ("triangular", 6), ("cubic", 6))
        return block("texture", f"{word} " + ", ".join(block("texture", entry()) for _ in range(count)), patterns.modifiers(r))
    return block("texture", pattern(r), block("texture_map", *textures.entries(r, entry)), patterns.modifiers(r))


def pattern(r, depth=""):
    """The words of a pattern that 3.8 has, or draws otherwise, with those of all versions now and then."""
    return r.made(lambda: potential(r, depth), lambda: potential(r, depth), lambda: crackle(r, depth), lambda: crackle(r, depth),
                  lambda: f"{r.pick('marble', 'wood')}{depth} {patterns.turbulence(r)}", lambda: f"tiling {r.whole(1, 24)}{depth}",
                  lambda: f"pavement{depth} number_of_sides {r.pick('3', '4', '6')} number_of_tiles {r.whole(1, 4)} pattern 1" + r.some(.4, f" exterior {r.whole(0, 2)}") + r.some(.4, f" interior {r.whole(0, 2)}") + r.some(.3, f" form {r.whole(0, 2)}"),
                  lambda: f"image_pattern {{ {picture(r)} }}{depth}", lambda: f"pigment_pattern {{ {colors(r)} scale {r.num(.3, 1)} }}{depth}",
                  lambda: patterns.pattern(r, depth), lambda: patterns.pattern(r, depth))


def crackle(r, depth=""):
    repeat = r.pick(f"<{r.whole(0, 3)}, {r.whole(0, 3)}, {r.whole(0, 3)}>", str(r.whole(1, 4)), f"<{r.num(1, 4)}, {r.num(1, 4)}, {r.num(0, 3)}>")
    return "crackle" + depth + f" repeat {repeat}" + r.some(.4, f" form {r.vec(-1, 1)}") + r.some(.3, f" metric {r.pick('1', '2', '3', '1.5')}") + r.some(.3, f" offset {r.num(0, .5)}") \
        + (r.some(.2, " solid") if not depth else "")


def potential(r, depth=""):
    parts = [f"sphere {{ {r.vec(-.7, .7)}, {r.num(.6, 1.4)}, {r.pick(r.num(.4, 2), r.num(.4, 2), r.num(-1.5, -.3))} {r.some(.3, 'scale <1, .6, 1.2>')} }}" for _ in range(r.whole(1, 4))]
    blob = block("blob", f"threshold {r.num(.2, .8)}", *parts, r.some(.2, "inverse"), r.some(.3, patterns.move(r)))
    surface = block("isosurface", f"function {{ {r.pick('x*x + y*y + z*z - .7', 'sin(3*x) + sin(3*y) + sin(3*z)', 'abs(x) + y*y - z')} }}", "contained_by { sphere { 0, .3 } }",
                    r.some(.4, f"threshold {r.num(-.5, .8)}"), r.some(.2, "polarity on"), r.some(.2, "inverse"), r.some(.3, patterns.move(r)))
    return f"potential {{ {r.pick(blob, blob, surface)} }}" + r.some(.5, f" threshold {r.pick('on', 'off')}") + depth + r.some(.3, " " + patterns.wave(r))


def colors(r):
    """A pattern with a map of two or three colours."""
    return lines(r.pick("bozo", "granite", "wood", "marble", "radial", crackle(r), potential(r)), block("color_map", *textures.entries(r, lambda: r.color())))


def picture(r):
    word, name = r.pick(*FILES)
    gamma = r.some(.5, f"gamma {r.pick('1', '2.2', 'srgb', 'bt709', 'bt2020', '1.8')}")
    return f'{word} "{name}" {gamma} {r.some(.1, r.pick("premultiplied on", "premultiplied off"))} map_type {r.pick("0", "0", "1", "2", "5", "7")} {patterns.interpolate(r)} {r.some(.2, "once")}'


def image(r):
    clear = " ".join(f"{r.pick('filter', 'transmit')} all {r.num(0, 1.2)}" for _ in range(r.pick(0, 0, 1, 1, 2)))
    return block("image_map", picture(r), clear)


def user_defined(r, clear):
    given = [f"function {{ {patterns.formula(r)} }}" for _ in range(3)]
    if clear:
        given += [r.some(.6, f"function {{ {r.num(0, .6)}*abs(sin(x*{r.num(1, 5)})) }}"), f"function {{ {r.num(.2, .9)}*abs(cos(z*{r.num(1, 5)})) }}"]
    if r.chance(.15):
        given[r.whole(0, len(given) - 2)] = ""
    return "user_defined { " + ", ".join(given) + " }"


def pigment(r, clear=False, depth=1):
    color = lambda: textures.color(r, clear)
    inner = lambda: pigment(r, clear, depth - 1)[len("pigment {"):-1]
    made = [lambda: block("pigment", pattern(r), r.some(.9, block("color_map", *textures.entries(r, color))), patterns.modifiers(r))] * 3
    made += [lambda: block("pigment", user_defined(r, clear), r.some(.5, patterns.move(r)), r.some(.2, patterns.warp(r))), lambda: block("pigment", image(r), patterns.modifiers(r)),
             lambda: block("pigment", image(r), f"scale {r.num(.4, 2)}", r.some(.4, patterns.move(r)))]
    if depth:
        made += [lambda: block("pigment", pattern(r), block("pigment_map", *textures.entries(r, inner)), patterns.modifiers(r)),
                 lambda: block("pigment", "average", block("pigment_map", *(f"[{r.num(.2, 2)} {inner()}]" for _ in range(r.whole(2, 3)))), patterns.modifiers(r)),
                 lambda: textures.pigment(r, clear, 2),
                 lambda: block("pigment", f"{r.pick('checker', 'brick')} " + ", ".join(f"pigment {{ {inner()} }}" for _ in range(2)), patterns.modifiers(r))]
    return r.made(*made)


def normal(r):
    size = r.num(.05, .9)
    return r.made(*[lambda: block("normal", pattern(r, f" {size}"), r.some(.2, f"accuracy {r.num(.005, .1)}"), patterns.modifiers(r))] * 3,
                  lambda: block("normal", f"bump_map {{ {picture(r)} bump_size {r.num(.2, 2)} }}", patterns.modifiers(r)),
                  lambda: block("normal", pattern(r, f" {size}"), block("slope_map", *textures.entries(r, lambda: f"<{r.num(0, 1)}, {r.num(-1, 1)}>")), patterns.modifiers(r)),
                  lambda: block("normal", pattern(r), block("normal_map", *textures.entries(r, lambda: f"{pattern(r, ' ' + r.num(.1, .7))} scale {r.num(.2, .8)}")), patterns.modifiers(r)),
                  lambda: textures.normal(r))


def finish(r):
    share = r.pick("on", "off", "", r.num(0, 1), r.num(0, 1))
    mirror = r.pick("", "", f"reflection {{ {r.num(0, .3)}, {r.num(.3, .9)} {r.some(.5, 'fresnel ' + r.pick('on', 'off', '.5'))} }}", f"reflection {r.num(.1, .5)}", f"reflection {{ {r.num(.2, .8)} fresnel }}")
    parts = [r.some(.6, f"fresnel {share}"), r.some(.4, f"use_alpha {r.pick('on', 'off', '')}"), mirror, r.some(.4, f"diffuse {r.some(.2, 'albedo ')}{r.num(.3, 1)}{r.some(.3, f', {r.num(0, .7)}')}"),
             r.some(.3, f"phong {r.some(.3, 'albedo ')}{r.num(.2, 1)} phong_size {r.num(3, 60)}"), r.some(.4, f"specular {r.some(.3, 'albedo ')}{r.num(.2, 1)} roughness {r.num(.005, .1)}"),
             r.some(.2, f"ambient {r.num(0, .4)}"), r.some(.2, f"emission {r.num(0, .4)}"), r.some(.2, f"brilliance {r.num(.5, 3)}"), r.some(.15, f"metallic {r.pick('', r.num(0, 1))}"),
             r.some(.1, f"irid {{ {r.num(.1, .5)} thickness {r.num(.2, 1)} turbulence {r.num(0, .5)} }}"), r.some(.15, "conserve_energy")]
    return block("finish", *r.shuffled(parts))
