"""Patterns with their modifiers in pigments, normals and textures; maps of maps; warps; functions; pictures."""
from rng import block, lines
from words import common, patterns
from words.patterns import interpolate


def scene(r):
    parts = [common.HEADER, patterns.NOISE, common.camera(r), common.light(r), common.background(r),
             block("plane", "y, -1.037", r.pick(pigment(r), common.pigment(r)))]
    for _ in range(r.whole(1, 3)):
        word, body = common.solid(r, 1)
        parts += [block(word, body, r.some(.12, "uv_mapping"), look(r, 2), common.place(r, 1.2))]
    return lines(*parts)


def look(r, depth):
    kind = r.whole(0, 9)
    if kind < 4:
        return lines(pigment(r), r.some(.4, normal(r)), r.some(.5, common.finish(r)))
    if kind < 6:
        return lines(block("texture", pigment(r), r.some(.3, normal(r))), *(block("texture", pigment(r, clear=True)) for _ in range(r.whole(1, 2))))
    if kind < 8:
        return texture(r, depth)
    if kind == 8:
        return lines(common.pigment(r), normal(r), common.finish(r))
    return block("texture", "material_map { png \"picture.png\" map_type " + r.pick("0", "1", "2") + " "
                 + " ".join(f"texture {{ {common.pigment(r)} {common.finish(r)} }}" for _ in range(3)) + " }", r.some(.6, patterns.move(r)))


def texture(r, depth):
    """A texture of textures, `depth` deep at most."""
    if depth == 0 or r.chance(.3):
        return block("texture", r.pick(pigment(r), common.pigment(r)), r.some(.3, normal(r)), r.some(.3, common.finish(r)))
    listed = r.chance(.25)
    if listed:
        word, count = r.pick(("checker", 2), ("brick", 2), ("hexagon", 3), ("square", 4), ("triangular", 6), ("cubic", 6))
        inner = ", ".join(texture(r, depth - 1) for _ in range(count))
        return block("texture", f"{word} {inner}", patterns.modifiers(r))
    return block("texture", patterns.pattern(r), block("texture_map", *entries(r, lambda: texture(r, depth - 1)[len("texture {"):-1])),
                 patterns.modifiers(r))


def entries(r, inner):
    """Entries of a map, 2 to 4 of them with rising values."""
    values = sorted(r.real(0, 1) for _ in range(r.whole(2, 4)))
    return [f"[{value:g} {inner()}]" for value in values]


def color(r, clear):
    return f"rgb{r.pick('f', 't')} <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}>" if clear else r.color()


def pigment(r, clear=False, depth=2):
    kind = r.whole(0, 11)
    if kind < 6:
        return block("pigment", patterns.pattern(r), r.some(.9, block(r.pick("color_map", "color_map", "colour_map"), *entries(r, lambda: color(r, clear)))), patterns.modifiers(r))
    if kind < 8 and depth:
        return block("pigment", patterns.pattern(r), block("pigment_map", *entries(r, lambda: pigment(r, clear, depth - 1)[len("pigment {"):-1])), patterns.modifiers(r))
    if kind == 8 and depth:
        word, count = r.pick(("checker", 2), ("brick", 2), ("hexagon", 3), ("square", 4), ("triangular", 6), ("cubic", 6), ("object { sphere { 0, .7 } ", 2))
        each = (lambda: pigment(r, clear, depth - 1)) if r.chance(.3) else (lambda: color(r, clear))
        inner = ", ".join(each() for _ in range(count))
        return block("pigment", f"{word} {inner}" + (" }" if "object" in word else ""),
                     r.some(.3, "brick_size <.5, .2, .3> mortar .05") if word == "brick" else "", patterns.modifiers(r))
    if kind == 9 and depth:
        values = "\n".join(f"[{r.num(.2, 2)} {pigment(r, clear, 0)[len('pigment {'):-1]}]" for _ in range(r.whole(2, 3)))
        return block("pigment", "average", block("pigment_map", values), patterns.modifiers(r))
    if kind == 10:
        return block("pigment", block("image_map", f"png \"picture.png\" gamma 1 map_type {r.pick('0', '0', '1', '2', '5')} {interpolate(r)}",
                                      r.some(.2, "once"), r.some(.2, f"transmit all {r.num(0, .6)}")), patterns.modifiers(r))
    return block("pigment", f"function {{ {patterns.formula(r)} }}", block("color_map", *entries(r, lambda: color(r, clear))), patterns.modifiers(r))


def normal(r):
    kind = r.whole(0, 9)
    if kind < 3:
        return block("normal", f"{r.pick('bumps', 'dents', 'ripples', 'waves', 'wrinkles')} {r.num(.05, .9)}", r.some(.1, "no_bump_scale"), patterns.modifiers(r))
    if kind < 6:
        return block("normal", patterns.pattern(r, f" {r.num(.05, .9)}"), r.some(.2, f"accuracy {r.num(.005, .1)}"), patterns.modifiers(r))
    if kind == 6:
        return block("normal", patterns.pattern(r, f" {r.num(.05, .9)}"),
                     block("slope_map", *entries(r, lambda: f"<{r.num(0, 1)}, {r.num(-1, 1)}>")), patterns.modifiers(r))
    if kind == 7:
        return block("normal", patterns.pattern(r),
                     block("normal_map", *entries(r, lambda: f"{r.pick('bumps', 'wrinkles', 'ripples', 'granite')} {r.num(.1, .7)} scale {r.num(.2, .8)}")), patterns.modifiers(r))
    if kind == 8:
        return block("normal", f"bump_map {{ png \"picture.png\" gamma 1 {interpolate(r)} bump_size {r.num(.2, 2)} }}", patterns.modifiers(r))
    return block("normal", f"{r.pick('checker', 'brick', 'hexagon')} {r.num(.1, .8)}", patterns.modifiers(r))
