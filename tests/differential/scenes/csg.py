"""Trees of union, intersection, difference and merge; bounds, clips, inverse, open; plain and of glass."""
from rng import block, lines
from words import common


def scene(r):
    parts = [common.HEADER, common.camera(r), common.light(r), r.some(.3, common.light(r)), common.background(r),
             r.some(.8, common.floor(r))]
    parts += [top(r) for _ in range(r.whole(1, 2))]
    return lines(*parts)


def top(r):
    clear = r.chance(.3)
    return block(*tree(r, r.whole(1, 3), clear), look(r, clear), r.some(.2, clip(r)), r.some(.12, "inverse") if not clear else "",
                 r.some(.1, "hollow"), r.some(.3, f"rotate {r.vec(-180, 180)}"), r.some(.2, f"scale {r.vec(.6, 1.3)}"),
                 r.some(.5, f"translate {r.box((-.8, .8), (-.3, .6), (-.8, .8))}"))


def tree(r, depth, clear):
    """(word, body) of an operator with operands, which are trees down to `depth`."""
    word = r.pick("union", "intersection", "difference", "merge")
    body = [operand(r, depth - 1, clear) for _ in range(r.whole(2, 4))]
    body += [r.some(.05, "split_union off") if word == "union" else ""]
    body += [r.some(.12, "cutaway_textures") if word in ("intersection", "difference") else ""]
    return word, lines(*body)


def operand(r, depth, clear):
    if depth > 0 and r.chance(.5):
        word, body = tree(r, depth, clear)
    elif r.chance(.15):
        word, body = "plane", f"{r.vec(-1, 1)[:-1]} + .01>, {r.num(-.2, .6)}"
    else:
        word, body = common.solid(r, .9)
    return block(word, body, r.some(.45, look(r, clear)), r.some(.1, clip(r)), r.some(.08, "inverse"), r.some(.1, common.place(r, .6)),
                 r.some(.4, f"translate {r.vec(-.6, .6)}"))


def look(r, clear):
    if not clear:
        return lines(common.pigment(r), common.finish(r))
    color = r.vec(.4, 1)[1:-1]
    return lines(f"pigment {{ {r.pick('rgbf', 'rgbt')} <{color}, {r.num(.3, .95)}> }}", common.finish(r),
                 r.some(.5, f"interior {{ ior {r.num(1.1, 1.8)} }}"))


def clip(r):
    word, body = common.solid(r, .9)
    solid = r.pick(f"{word} {{ {body} translate {r.vec(-.4, .4)} }}", f"plane {{ {r.pick('x', 'y', 'z', '<1, 1, .3>', '-z')}, {r.num(-.3, .6)} }}",
                   f"box {{ -{r.num(.5, 1)}, {r.num(.3, 1)} }}", f"sphere {{ {r.vec(-.3, .3)}, {r.num(.6, 1.2)} inverse }}")
    return f"clipped_by {{ {solid} }}" + r.some(.2, " bounded_by { clipped_by }")
