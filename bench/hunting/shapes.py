"""Many of one solid: each kind of the differential's, scattered, in unions, in CSG, in copies of copies."""
from rng import block, lines
from scenes import csg, halves, meshes, solids, standard
from words import common

from hunting.sizes import drawn, loop, spot, turned

HEAVY = ("parametric", "isosurface", "julia")  # a few of them are enough


def scatter(r, pieces, count, look, group=""):
    """Declared pieces in many places, small if they are many; `group` is the word of what holds them, if anything does."""
    name = f"P{r.whole(0, 10**6)}"
    size = min(1, 2.4 / count ** r.real(.33, .5))
    declared = [f"#declare {name} = array[{len(pieces)}];"] + [f"#declare {name}[{at}] = {piece}" for at, piece in enumerate(pieces)]
    inner = look() if not group or r.chance(.5) else ""
    one = f"object {{ {name}[mod(I, {len(pieces)})] {inner} scale {drawn(.6 * size, 1.2 * size)} {turned()} translate {spot()} }}"
    many = loop(count, one)
    return lines(*declared, f"{group} {{\n{many}\n{'' if inner else look()} }}" if group else many)


def of_kind(kind):
    """The maker of scenes with many of a kind of solid."""
    def shape(r, look):
        before, pieces = [], []
        for _ in range(r.whole(1, 3)):
            text, word, body = kind(r)
            before.append(text)
            pieces.append(block(word, body))
        heavy = kind.__name__ in HEAVY
        count = r.amount(1, 40) if heavy else r.amount(4, 6000)
        group = "" if heavy or count < 4 else r.pick("", "", "", "union", "union", "merge" if count < 400 else "union")
        if kind in (solids.disc, solids.patch, solids.mesh, solids.polygon, solids.triangle) and group == "merge":
            group = "union"
        return lines(*before, scatter(r, pieces, count, look, group))
    return shape


def cuts(r, look):
    """One solid less, or within, many others."""
    word, body = common.solid(r, 1.6)
    kind = r.pick(solids.plain, solids.plain, solids.plain, solids.blob, solids.prism, solids.lathe, solids.sor, solids.ovus, solids.sphere_sweep, solids.text)
    _, other, other_body = kind(r)
    count = r.amount(4, 3000)
    size = 1.5 / count ** r.real(.2, .5)
    cut = f"object {{ Cut scale {drawn(.5 * size, size)} {turned()} translate {spot(1.2, -1.2, 1.2)} }}"
    inner = r.some(.3, look())
    return lines(f"#declare Cut = {block(other, other_body)}", f"difference {{ {block(word, body)}\n{loop(count, cut)}\n{inner} {'' if inner else look()} }}")


def trees(r, look):
    """Operators in operators, as deep as nobody writes by hand."""
    clear = r.chance(.3)
    parts = []
    for at in range(r.amount(1, 12)):
        word, body = csg.tree(r, r.whole(3, 6), clear)
        parts.append(block(word, body, look(), f"scale {r.num(.4, 1)} translate {r.vec(-1.2, 1.2)}"))
    return lines(*parts)


def rooms(r, look):
    return lines(*(block(*halves.tree(r, r.whole(3, 6)), look(), f"scale {r.num(.3, 1)} rotate {r.vec(-180, 180)} translate {r.vec(-1.2, 1.2)}")
                   for _ in range(r.amount(1, 20))))


def shells(r, look):
    """One in another in another: what is seen through all of them."""
    word, body = common.solid(r, 1.4)
    count = r.amount(3, 300)
    return loop(count, f"{word} {{ {body} scale {r.num(.9, 1)} + .1*I/{count} {look()} {r.some(.3, 'hollow')} rotate {r.num(0, 3)}*I*{r.pick('x', 'y', 'z')} }}")


def copies(r, look):
    """Unions of copies of unions of copies."""
    word, body = common.solid(r, .8)
    few, levels = r.whole(3, 16), r.whole(2, 4)
    parts = [f"#declare Twig0 = {block(word, body, r.some(.4, look()))}"]
    for level in range(1, levels + 1):
        inside = r.some(.3, look())
        one = f"object {{ Twig{level - 1} {r.some(.2, look())} scale {drawn(.2, .7)} {turned()} translate {spot(1, -1, 1)} }}"
        parts.append(f"#declare Twig{level} = {r.pick('union', 'union', 'union', 'merge' if few ** level < 200 else 'union')} {{ {loop(few, one)} {inside} }}")
    number = r.amount(1, 200)
    size = min(1, 2 / number ** .4)
    return lines(*parts, loop(number, f"object {{ Twig{levels} {look()} scale {size * r.real(.5, 1.5):.3f} {turned()} translate {spot()} }}"))


def hair(r, look):
    """Thin things in thousands."""
    count = r.amount(200, 30000)
    one = r.pick("cylinder { A, B, .006", "cone { A, .012, B, 0", "triangle { A, B, B + .05*x", "box { A, A + .03", "sphere { A, .02", "torus { .06, .01 rotate <90*rand(S), 0, 0> translate A",
                 "cylinder { A, B, .006 open", "superellipsoid { <.3, .3> scale .03 translate A", "sphere { A, .02 scale <1, 2, 1>", "disc { A, B - A, .03")
    many = loop(count, f"#declare A = {spot()}; #declare B = A + <{drawn(-.2, .2)}, {drawn(.1, .5)}, {drawn(-.2, .2)}>;\n{one} {look() if r.chance(.3) else 'texture { Hair }'} }}")
    dressed = f"#declare Hair = texture {{ pigment {{ {r.color()} }} {common.finish(r)} }}"
    return lines(dressed, many if r.chance(.5) else f"union {{ {many} {r.some(.4, 'split_union off')} }}")


def library(r, look):
    """Isosurfaces of the functions of functions.inc and shapes of shapes.inc."""
    made = r.pick(standard.surface, standard.surface, standard.made_shape, standard.letters)
    pieces = [made(r) for _ in range(r.whole(1, 3))]
    count = r.amount(1, 12) if made is standard.surface else r.amount(2, 400)
    return lines(*standard.includes(), scatter(r, [f"object {{ {piece} }}" for piece in pieces], count, look))


def painted(r, look):
    """Meshes with textures of faces and corners, outlines with charts on them."""
    declared = [f"#declare Look{at} = {meshes.texture(r)}" for at in range(4)]
    pieces = [block(*meshes.made(r, True)) for _ in range(r.whole(1, 3))]
    return lines(*declared, scatter(r, pieces, r.amount(3, 2000), lambda: ""))


def clipped(r, look):
    word, body = common.solid(r, .9)
    pieces = [block("union", block(word, body), *(csg.clip(r) for _ in range(r.whole(1, 4)))) for _ in range(r.whole(1, 3))]
    return scatter(r, pieces, r.amount(4, 2000), look)


SHAPES = {kind.__name__: of_kind(kind) for kind in dict.fromkeys(solids.KINDS)} | {
    shape.__name__: shape for shape in (cuts, trees, rooms, shells, copies, hair, library, painted, clipped)}
