"""Rooms, slabs, wedges and columns: trees of boxes, tubes and half spaces turned inside out, along the axes, nested as builders nest them."""
from rng import block, lines
from words import common

AXES = ("x", "y", "z")


def scene(r):
    parts = [common.HEADER, common.camera(r), common.light(r), r.some(.3, common.light(r)), common.background(r), r.some(.6, common.floor(r))]
    parts += [block(*tree(r, r.whole(2, 3)), look(r), r.some(.3, f"rotate {r.vec(-180, 180)}"), r.some(.15, "inverse"),
                    r.some(.4, f"translate {r.box((-.6, .6), (-.2, .5), (-.6, .6))}")) for _ in range(r.whole(1, 2))]
    return lines(*parts)


def tree(r, depth):
    word = r.pick("union", "intersection", "difference", "difference", "merge", "merge")
    first = block(*bounded(r)) if word in ("intersection", "difference") else ""
    return word, lines(first, *[operand(r, depth - 1) for _ in range(r.whole(2, 4))])


def operand(r, depth):
    if depth > 0 and r.chance(.6):
        word, body = tree(r, depth)
    else:
        word, body = r.pick(bounded, halves, halves, tube)(r)
    return block(word, body, r.some(.3, look(r)), r.some(.1, "inverse"), r.some(.15, f"rotate {r.pick(90, 180, -90)}*{r.pick(*AXES)}"))


def bounded(r):
    low, high = [r.num(-1.1, 0) for _ in range(3)], [r.num(.1, 1.1) for _ in range(3)]
    return "box", f"<{', '.join(low)}>, <{', '.join(high)}>"


def halves(r):
    """A half space, a slab of two or a column of four, each the inverse of the half space that its normal points out of."""
    axes = [r.pick(*AXES)] if r.chance(.6) else list(AXES[:2] if r.chance(.5) else AXES[1:])
    planes = []
    for axis in axes:
        planes.append(f"plane {{ {axis}, {r.num(-.9, .1)} inverse }}")
        planes += [f"plane {{ -{axis}, {r.num(-.9, -.2)} inverse }}"] if r.chance(.8) else []
    if len(planes) == 1:
        return "plane", planes[0].split("{")[1].rsplit("}", 1)[0]
    return "intersection", lines(*planes)


def tube(r):
    axis, radius = r.pick(*AXES), r.num(.15, .7)
    return "cylinder", f"-{r.num(.2, 1.2)}*{axis}, {r.num(.2, 1.2)}*{axis}, {radius}" + r.some(.1, " open")


def look(r):
    return lines(common.pigment(r), common.finish(r))
