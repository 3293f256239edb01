"""Meshes, patches, fields and swept outlines: with textures of their corners, uv coordinates and inner textures, in CSG, copied, sheared and painted anew."""
import math

from rng import block, lines
from scenes import lights, solids
from words import common, patterns

NAMES = (("Bare", False), ("Painted", True))


def scene(r):
    parts = [common.HEADER, patterns.NOISE, common.camera(r), common.light(r), r.some(.3, common.light(r)), common.background(r), r.some(.8, common.floor(r))]
    parts += [f"#declare Look{at} = {texture(r)}" for at in range(4)]
    parts += [f"#declare {name} = {block(*made(r, painted))}" for name, painted in NAMES]
    parts += [placed(r) for _ in range(r.whole(1, 3))]
    parts += [block(*made(r, True), place(r)) for _ in range(r.whole(0, 1))]
    return lines(*parts)


def texture(r):
    return block("texture", r.pick(common.pigment(r), common.pigment(r), lights.see_through(r), chart(r)), r.some(.5, common.finish(r)),
                 r.some(.15, f"normal {{ {r.pick('bumps', 'wrinkles', 'gradient x', 'ripples')} {r.num(.2, .8)} scale {r.num(.1, .5)} }}"))


def chart(r):
    """A pigment that shows where uv coordinates run."""
    pattern = r.pick("checker", "brick", "hexagon", "gradient x", "gradient y", "radial", "wood", "boxed", "bozo", "image_map { png \"picture.png\" gamma 1 }", "leopard")
    colors = {"checker": 2, "brick": 2, "hexagon": 3}.get(pattern, 0)
    inner = f"{pattern} " + ", ".join(r.color() for _ in range(colors)) if colors else pattern
    map_ = f"color_map {{ [0 {r.color()}] [.5 {r.color()}] [1 {r.color()}] }}" if not colors and "image" not in pattern else ""
    size = r.num(.02, .05) if pattern == "brick" else r.num(.1, .5)
    return block("pigment", r.some(.5, "uv_mapping"), inner, map_, f"scale {r.pick(size, size, f'<{r.num(.1, .4)}, {r.num(.1, .4)}, 1>')}", r.some(.3, f"rotate {r.num(0, 90)}*z"),
                 r.some(.2, f"translate {r.vec(-1, 1)}"), r.some(.15, f"warp {{ turbulence {r.num(.1, .4)} }}"))


def paint(r):
    """What an object carries, or nothing."""
    return r.made(lambda: f"texture {{ Look{r.whole(0, 3)} }}", lambda: f"texture {{ uv_mapping Look{r.whole(0, 3)} }}", lambda: "uv_mapping " + chart(r), lambda: chart(r), lambda: "",
                  lambda: f"texture {{ Look{r.whole(0, 3)} }} interior_texture {{ Look{r.whole(0, 3)} }}", lambda: f"uv_mapping texture {{ Look{r.whole(0, 3)} scale .5 }}",
                  lambda: f"texture {{ {common.pigment(r)} scale {r.num(.4, 2)} }} texture {{ {lights.see_through(r)} }}")


def place(r):
    return lines(r.some(.5, f"rotate {r.vec(-180, 180)}"), r.some(.4, f"scale {r.vec(.5, 1.3)}"), r.some(.1, "scale <-1, 1, 1>"),
                 r.some(.3, f"matrix <1, {r.num(-.4, .4)}, 0, {r.num(-.4, .4)}, 1, {r.num(-.3, .3)}, 0, {r.num(-.3, .3)}, 1, 0, 0, 0>"),
                 f"translate {r.box((-1.2, 1.2), (-.3, .5), (-1, 1))}")


def copy(r):
    """A declared shape, painted as it may be: what has a texture takes no other pattern."""
    name, painted = r.pick(*NAMES)
    return name, r.some(.2, f"texture {{ {lights.see_through(r)} }}") if painted else paint(r)


def placed(r):
    if r.chance(.3):
        (a, paint_a), (b, paint_b) = copy(r), copy(r)
        return block(r.pick("union", "merge", "difference", "intersection"), f"object {{ {a} {paint_a} }}", f"object {{ {b} {paint_b} translate {r.vec(-.4, .4)} }}", place(r))
    return block("object", *copy(r), place(r), r.some(.1, "no_shadow"), r.some(.1, "double_illuminate"), r.some(.1, "hollow"))


def made(r, painted):
    """Word and body of a shape, or of one in CSG, with the looks of its own."""
    dress = lambda: paint(r) if painted else ""
    if r.chance(.35):
        word, body = closed(r)
        other, other_body = common.solid(r, .75)
        whole, half = r.chance(.5), r.chance(.5)
        operands = [block(word, body, "" if whole else dress(), r.some(.3, place(r)), r.some(.1, "inverse")),
                    block(other, other_body, "" if whole and half else dress(), f"translate {r.vec(-.5, .5)}")]
        return r.pick("difference", "intersection", "union", "merge"), lines(*r.shuffled(operands) if r.chance(.3) else operands), dress() if whole else ""
    word, body = r.made(lambda: closed(r), lambda: opened(r))
    return word, body, dress()


def closed(r):
    kind = r.pick(mesh_of_grid, mesh2_of_grid, mesh2_of_grid, solids.prism, solids.prism, solids.lathe, solids.sor, solids.height_field, solids.text, solids.sphere_sweep, solids.blob,
                  wall, plain)
    found = kind(r)
    return found[-2], found[-1]


def plain(r):
    return common.solid(r, .8)


def opened(r):
    kind = r.pick(patch, patch, solids.polygon, solids.triangle, sheet, solids.disc, solids.mesh)
    found = kind(r)
    return found[-2], found[-1] + "\ntranslate <.013, .017, .011>"  # no corner of a checker in its plane


def ring(r, around, tall):
    """Corners of a body like a ball, poles apart: (point, outward direction, u, v)."""
    bump = [[r.real(.75, 1) for _ in range(around)] for _ in range(tall)]
    corners = []
    for j in range(tall):
        for i in range(around + 1):
            up, turn = math.pi * (j + 1) / (tall + 1) - math.pi / 2, 2 * math.pi * (i % around) / around
            d = (math.cos(up) * math.cos(turn), math.sin(up), math.cos(up) * math.sin(turn))
            corners.append((tuple(bump[j][i % around] * c for c in d), d, i / around, j / (tall - 1)))
    return corners


def faces_of(around, tall):
    """Triangles of the ring and its two lids."""
    at = lambda i, j: j * (around + 1) + i
    sides = [f for j in range(tall - 1) for i in range(around) for f in ((at(i, j), at(i + 1, j), at(i, j + 1)), (at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))]
    lids = [(at(0, j), at(i, j), at(i + 1, j)) for j in (0, tall - 1) for i in range(1, around - 1)]
    return sides + lids


def vector(numbers):
    return "<" + ", ".join(f"{n:.4g}" for n in numbers) + ">"


def mesh_of_grid(r):
    around, tall = r.whole(3, 7), r.whole(2, 4)
    corners = ring(r, around, tall)
    smooth, charted, painted = r.chance(.5), r.chance(.5), r.chance(.4)
    written = []
    for face in faces_of(around, tall):
        body = ", ".join(vector(corners[c][0]) + (", " + vector(corners[c][1]) if smooth else "") for c in face)
        uv = "uv_vectors " + ", ".join(vector(corners[c][2:]) for c in face) if charted else ""
        look = f"texture {{ Look{r.whole(0, 3)} }}" if painted and r.chance(.6) else f"texture_list {{ Look{r.whole(0, 3)} Look{r.whole(0, 3)} Look{r.whole(0, 3)} }}" if painted and r.chance(.3) else ""
        written.append(f"{'smooth_triangle' if smooth else 'triangle'} {{ {body} {uv} {look} }}")
    return "mesh", lines(*written, f"inside_vector {r.pick('x', 'y', '<.3, 1, .2>')}")


def mesh2_of_grid(r):
    around, tall = r.whole(3, 8), r.whole(2, 4)
    corners = ring(r, around, tall)
    faces = faces_of(around, tall)
    listed = lambda word, entries: f"{word} {{ {len(entries)}, {', '.join(entries)} }}"
    painted, charted = r.chance(.5), r.chance(.6)
    parts = [listed("vertex_vectors", [vector(c[0]) for c in corners])]
    parts += [listed("normal_vectors", [vector(c[1]) for c in corners])] if r.chance(.5) else []
    parts += [listed("uv_vectors", [vector(c[2:]) for c in corners])] if charted else []
    indices = [vector(f) for f in faces]
    if painted:
        parts += ["texture_list { 4, " + ", ".join(f"texture {{ Look{k} }}" for k in range(4)) + " }"]
        many = r.chance(.5)
        indices = [f + ", " + ", ".join(str(r.whole(0, 3)) for _ in range(3 if many else 1)) for f in indices]
    parts += [f"face_indices {{ {len(faces)}, {', '.join(indices)} }}"]
    return "mesh2", lines(*parts, f"inside_vector {r.pick('x', 'y', '<.3, 1, .2>')}")


def sheet(r):
    """An open mesh2 over a grid."""
    n = r.whole(2, 4)
    points = [f"<{2 * i / n - 1:.3g}, {r.num(-.3, .3)}, {2 * j / n - 1:.3g}>" for j in range(n + 1) for i in range(n + 1)]
    normals = [f"<{r.num(-.4, .4)}, 1, {r.num(-.4, .4)}>" for _ in points]
    faces = [f for j in range(n) for i in range(n) for a in (j * (n + 1) + i,) for f in (f"<{a}, {a + 1}, {a + n + 1}>", f"<{a + 1}, {a + n + 2}, {a + n + 1}>")]
    parts = [f"vertex_vectors {{ {len(points)}, {', '.join(points)} }}", r.some(.5, f"normal_vectors {{ {len(points)}, {', '.join(normals)} }}")]
    if r.chance(.6):
        few = [f"<{r.num(0, 1)}, {r.num(0, 1)}>" for _ in range(5)]
        parts += [f"uv_vectors {{ 5, {', '.join(few)} }}", f"face_indices {{ {len(faces)}, {', '.join(faces)} }}",
                  f"uv_indices {{ {len(faces)}, " + ", ".join(f"<{r.whole(0, 4)}, {r.whole(0, 4)}, {r.whole(0, 4)}>" for _ in faces) + " }"]
    else:
        parts += [f"face_indices {{ {len(faces)}, {', '.join(faces)} }}"]
    return "mesh2", lines(*parts)


def patch(r):
    points = [f"<{x * .6 - .9:.2f}, {r.num(-.6, .6)}, {z * .6 - .9:.2f}>" for z in range(4) for x in range(4)]
    corners = ["<0, 0>", "<1, 0>", "<1, 1>", "<0, 1>"] if r.chance(.5) else [f"<{r.num(0, 2)}, {r.num(0, 2)}>" for _ in range(4)]
    return "bicubic_patch", lines(f"type {r.whole(0, 1)} flatness {r.pick('0', '.01', '.1')} u_steps {r.whole(1, 4)} v_steps {r.whole(1, 4)}",
                                  r.some(.4, "uv_vectors " + " ".join(corners)), ", ".join(points))


def wall(r):
    """A prism with a hole."""
    outer, inner = solids.outline(r, r.whole(3, 6), .6, 1), solids.outline(r, r.whole(3, 5), .2, .4)
    sweep = r.pick("linear_sweep", "conic_sweep")
    points = outer + outer[:1] + inner + inner[:1]
    return "prism", lines(sweep, "linear_spline", f"{r.num(.2, .5)}, {r.num(.7, 1.1)}, {len(points)},", ", ".join(points), r.some(.2, "open"))
