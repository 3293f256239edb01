"""Declared objects with every modifier, placed with others: what a copy keeps, what it adds and what it takes over."""
from rng import block, lines
from scenes import csg, lights
from words import common


def scene(r):
    names = ["First", "Second", "Third"]
    parts = [common.HEADER, common.camera(r), common.background(r), common.floor(r), common.light(r), r.some(.3, lights.light(r))]
    if r.chance(.3):
        parts += [f"#default {{ {r.pick(common.pigment(r), common.finish(r), texture(r))} }}"]
    parts += [f"#declare Coat = {texture(r)}", f"#declare Stuff = material {{ {texture(r)} {r.some(.6, 'interior { ior 1.3 }')} }}"]
    parts += [f"#declare {name} = {made(r, names[:at])}" for at, name in enumerate(names)]
    if r.chance(.3):
        parts += [f"#default {{ {texture(r)} }}"]
    parts += [placed(r, names) for _ in range(r.whole(2, 4))]
    return lines(*parts)


def texture(r):
    color = r.pick(common.pigment(r), common.pigment(r), lights.see_through(r),
                   f"pigment {{ bozo color_map {{ [0 {r.color()}] [1 rgbt <1, 1, 1, {r.num(.3, 1)}>] }} scale {r.num(.2, .6)} }}")
    return block("texture", color, common.finish(r), r.some(.2, f"normal {{ {r.pick('bumps', 'wrinkles', 'gradient x')} {r.num(.2, .8)} scale {r.num(.1, .5)} }}"),
                 r.some(.3, f"scale {r.num(.4, 2)}"), r.some(.2, f"rotate {r.vec(-90, 90)}"))


def coat(r):
    return r.pick("texture { Coat }", texture(r), common.pigment(r), common.finish(r), "material { Stuff }", "material { Stuff scale .5 }",
                  texture(r) + " " + texture(r), "texture { Coat scale .5 }", f"texture {{ Coat }} interior_texture {{ {r.pick('Coat', 'pigment { rgb <.9, .4, .2> }')} }}")


def modifier(r):
    return r.pick("no_shadow", "no_image", "no_reflection", "double_illuminate", "hollow", "hollow off", "inverse", csg.clip(r),
                  f"bounded_by {{ sphere {{ 0, {r.num(2, 4)} }} }}", f"interior {{ ior {r.num(1, 1.5)} }}",
                  f"rotate {r.vec(-90, 90)}", f"scale {r.num(.5, 1.3)}", f"translate {r.vec(-.4, .4)}", f"scale {r.vec(.5, 1.3)}",
                  "bounded_by { clipped_by }")


def modifiers(r, most):
    return r.shuffled([modifier(r) for _ in range(r.whole(0, most))] + [coat(r) for _ in range(r.whole(0, 2))])


def made(r, known):
    if known and r.chance(.3):
        return block("object", r.pick(*known), *modifiers(r, 3))
    if r.chance(.5):
        word, body = common.solid(r, .8)
        return block(word, body, *modifiers(r, 3))
    parts = []
    for _ in range(r.whole(2, 3)):
        if known and r.chance(.5):
            parts.append(block("object", r.pick(*known), *modifiers(r, 2)))
        else:
            word, body = common.solid(r, .8)
            parts.append(block(word, body, *modifiers(r, 2)))
    return block(r.pick("union", "union", "merge", "intersection", "difference"), *parts, *modifiers(r, 2))


def placed(r, names):
    return block(r.pick("object", "object", "union"), f"object {{ {r.pick(*names)} {' '.join(modifiers(r, 2))} }}", *modifiers(r, 1), common.place(r, 1)) \
        if r.chance(.3) else block("object", r.pick(*names), *modifiers(r, 2), common.place(r, 1))
