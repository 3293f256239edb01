"""One solid with many parts: blobs, outlines, sweeps, meshes, fields, formulas and polynomials."""
import math

from rng import block, lines
from scenes import functions, solids
from words import common

from hunting.sizes import drawn, loop, spot


def big_blob(r, look):
    count = r.amount(20, 3000)
    size = 2.5 / count ** r.real(.25, .4)
    part = r.pick(f"sphere {{ {spot(1.4, -1, 1.2)}, {drawn(.6 * size, 1.4 * size)}, {r.num(.4, 1.5)}",
                  f"#declare A = {spot(1.4, -1, 1.2)}; cylinder {{ A, A + {size:.3f}*<rand(S), rand(S), rand(S)>, {drawn(.4 * size, size)}, {r.num(.4, 1.5)}")
    each = r.some(.3, f"pigment {{ {r.color()} }}")
    return f"blob {{ threshold {r.num(.2, .7)} {loop(count, f'{part} {each} }}')} {look()} {r.some(.15, 'sturm')} }}"


def outline(count, radius, wobble):
    return [f"<{rho * math.cos(turn):.4f}, {rho * math.sin(turn):.4f}>" for at in range(count)
            for turn in (2 * math.pi * at / count,) for rho in (radius * (1 + wobble * math.sin(7 * turn + at * 2.4)),)]


def long_prism(r, look):
    count = r.amount(10, 600)
    points = outline(count, 1.4, r.real(0, .3))
    kind = r.pick("linear_spline", "quadratic_spline", "cubic_spline")
    points = {"linear_spline": points + points[:1], "quadratic_spline": points[-1:] + points + points[:1], "cubic_spline": points[-1:] + points + points[:2]}[kind]
    sweep = r.pick("linear_sweep", "linear_sweep", "conic_sweep")
    prism = block("prism", sweep, kind, f".2, .9, {len(points)},", ", ".join(points), r.some(.2, "open"), r.some(.15, "sturm"))
    return lines(f"#declare Plate = {prism}", used(r, "Plate", look))


def used(r, name, look):
    """A few of it, or one with holes, or under many others of itself."""
    spread = f"object {{ {name} {look()} {r.some(.6, f'rotate {r.vec(-180, 180)}')} translate {r.vec(-.5, .5)} }}"
    return r.made(lambda: spread, lambda: spread, lambda: lines(*(f"object {{ {name} {look()} scale {r.num(.2, .7)} rotate {r.vec(-180, 180)} translate {r.vec(-1.3, 1.3)} }}" for _ in range(r.amount(2, 60)))),
                  lambda: f"difference {{ object {{ {name} }} " + " ".join(f"object {{ {name} scale {r.num(.2, .5)} rotate {r.vec(-180, 180)} translate {r.vec(-.8, .8)} }}" for _ in range(r.amount(1, 20))) + f" {look()} }}",
                  lambda: f"intersection {{ object {{ {name} }} sphere {{ {r.vec(-.2, .2)}, {r.num(.8, 1.2)} }} {look()} }}")


def long_lathe(r, look):
    kind, count = r.pick("linear_spline", "quadratic_spline", "cubic_spline", "sor"), r.amount(8, 300)
    points = ", ".join(f"<{.5 + .4 * math.sin(at * r.real(.2, .5)):.3f}, {-1.2 + 2.4 * at / (count - 1):.4f}>" for at in range(count))
    body = block("sor", f"{count},", points) if kind == "sor" else block("lathe", kind, f"{count},", points, r.some(.2, "sturm"))
    return lines(f"#declare Vase = {body}", used(r, "Vase", look))


def long_sweep(r, look):
    kind, count = r.pick("linear_spline", "cubic_spline", "b_spline"), r.amount(8, 300)
    points = ", ".join(f"<{1.5 * math.cos(at * .5):.3f}, {-.9 + 2 * at / count:.3f}, {1.5 * math.sin(at * .5):.3f}>, {r.num(.03, .2)}" for at in range(count))
    return lines(f"#declare Spring = {block('sphere_sweep', kind, f'{count},', points)}", used(r, "Spring", look))


def long_polygon(r, look):
    points = outline(r.amount(20, 3000), 1.4, r.real(0, .3))
    holes = [outline(r.whole(4, 40), .1, 0) for _ in range(r.whole(0, 4))]
    all_points = points + points[:1] + [p for hole in holes for p in hole + hole[:1]]
    return lines(f"#declare Sheet = polygon {{ {len(all_points)}, {', '.join(all_points)} }}", *(f"object {{ Sheet {look()} rotate {r.vec(-60, 60)} translate {r.vec(-.5, .5)} }}" for _ in range(r.amount(1, 20))))


def field(r, look):
    count = r.amount(60, 1000)
    formula = r.made(lambda: f"function {count}, {count} {{ .5 + .5*sin({functions.value(r, functions.Made(), r.whole(1, 3))}) }}",
                     lambda: f"function {count}, {count} {{ pattern {{ {r.pick('bozo', 'granite', 'wrinkles', 'crackle', 'agate', 'leopard')} scale {r.num(.05, .5)} }} }}",
                     lambda: f"function {count}, {count} {{ pigment {{ {r.pick('bozo', 'granite', 'wood', 'marble')} turbulence {r.num(0, 1)} scale {r.num(.1, .5)} }} }}")
    return block("height_field", formula, r.some(.5, "smooth"), r.some(.3, f"water_level {r.num(.1, .5)}"), f"translate -.5 scale <{r.num(3, 7)}, {r.num(.3, 2)}, {r.num(3, 7)}>", look(), f"translate {r.num(-1, 0)}*y")


def sheet(r, look):
    """A mesh, a mesh2 or loose triangles over a wavy grid, written by a loop."""
    n = r.amount(8, 200)
    height = f"#declare H = function (x, z) {{ {r.num(.1, .5)}*sin({r.num(1, 6)}*x)*cos({r.num(1, 6)}*z) + {r.num(0, .2)}*sin({r.num(8, 20)}*(x + z)) }}\n#macro At(I, J) <4*I/{n} - 2, H(4*I/{n}, 4*J/{n}), 4*J/{n} - 2> #end"
    smooth = r.chance(.4)
    corner = lambda i, j: f"At(I+{i}, J+{j}), y + <{r.num(-.2, .2)}, 0, 0>" if smooth else f"At(I+{i}, J+{j})"
    face = lambda *corners: f"{'smooth_triangle' if smooth else 'triangle'} {{ {', '.join(corner(i, j) for i, j in corners)} {{}} }}"
    textured = r.some(.3, "texture { Face[mod(I + J, 4)] }")
    alone = r.pick(False, False, True)
    inner = look() if alone else textured
    faces = "\n".join(face(*c).replace("{}", inner) for c in (((0, 0), (1, 0), (0, 1)), ((1, 0), (1, 1), (0, 1))))
    rows = f"#for (I, 0, {n - 1}) #for (J, 0, {n - 1})\n{faces}\n#end #end"
    declared = "#declare Face = array[4];" + " ".join(f"#declare Face[{k}] = texture {{ {common.pigment(r)} {common.finish(r)} }}" for k in range(4))
    return lines(height, declared, rows if alone else f"mesh {{ {rows} {look()} }}")


def patches(r, look):
    before, word, body = solids.patch(r)
    body = body.replace("u_steps 1", "u_steps 5").replace("v_steps 1", f"v_steps {r.whole(1, 6)}")
    return loop(r.amount(1, 400), f"{word} {{ {body} {look()} scale {drawn(.2, .9)} rotate <360*rand(S), 360*rand(S), 0> translate {spot()} }}")


def polynomials(r, look):
    order = r.whole(3, 9)
    terms = [f"xyz({a}, {b}, {c}): {r.num(-.5, .5)}" for a in range(order + 1) for b in range(order + 1 - a) for c in range(order + 1 - a - b) if r.chance(.25)]
    even = order - order % 2
    closed = [f"xyz({even}, 0, 0): 1", f"xyz(0, {even}, 0): 1", f"xyz(0, 0, {even}): 1"]
    terms = [term for term in terms if not any(term.startswith(known.split(":")[0]) for known in closed)] + closed
    return lines(*(f"polynomial {{ {order}, {', '.join(terms)} {r.some(.4, 'sturm')} {look()} scale {r.num(.3, .9)} rotate {r.vec(-90, 90)} translate {r.vec(-1.2, 1.2)} bounded_by {{ sphere {{ 0, 2.5 }} }} }}" for _ in range(r.amount(1, 20))))


def formulas(r, look):
    """Isosurfaces of deep formulas that call each other, with functions of every make."""
    made = functions.Made()
    makers = (functions.formula_of, functions.formula_of, functions.pattern_of, functions.pigment_of, functions.spline_of, functions.transform_of, functions.nested_of)
    parts = [r.pick(*makers)(r, made) for _ in range(r.whole(1, 8))]
    for _ in range(r.whole(1, 4)):
        base = r.pick("x*x + y*y + z*z - .6", "max(abs(x), max(abs(y), abs(z))) - .7", "sqrt(x*x + z*z) - .5", "y - .2", "sqrt(pow(sqrt(x*x + z*z) - .7, 2) + y*y) - .25", "pow(abs(x), 2.4) + pow(abs(y), 3.1) + pow(abs(z), 2.2) - .5")
        parts.append(block("isosurface", f"function {{ {base} + {r.num(.03, .2)}*sin({functions.value(r, made, r.whole(2, 5))}) }}", r.pick("contained_by { box { -1, 1 } }", "contained_by { sphere { 0, 1.2 } }"),
                           f"max_gradient {r.pick('3', '6', '12', '25')} accuracy {r.pick('.001', '.001', '.0001')}", r.some(.2, "open"), r.some(.2, "all_intersections"), r.some(.15, "evaluate 3, 1.2, .95"), look(), common.place(r)))
    return lines(*parts)


def julias(r, look):
    return lines(*(block("julia_fractal", f"<{r.num(-.3, .1)}, {r.num(0, .6)}, {r.num(-.5, 0)}, {r.num(-.1, .1)}>", r.pick("quaternion", "quaternion", "hypercomplex"),
                         r.pick("sqr", "sqr", "cube", "exp", "sin", "sqr"), f"max_iteration {r.whole(5, 30)}", f"precision {r.whole(20, 200)}", look(), common.place(r)) for _ in range(r.amount(1, 30))))


def texts(r, look):
    words = "".join(chr(r.whole(33, 126)) for _ in range(r.amount(4, 200))).replace('"', "q").replace("\\", "b")
    rows = r.amount(1, 12)
    return lines(*(f'text {{ ttf "{r.pick("timrom.ttf", "cyrvetic.ttf", "crystal.ttf")}" "{words[at:] or words}", {r.num(.1, .5)}, 0 scale {r.num(.15, .6)} translate <-2.2, {1.2 - at * .3:.2f}, {r.num(-1, 1)}> {look()} }}' for at in range(rows)))


LARGE = {shape.__name__: shape for shape in (big_blob, long_prism, long_lathe, long_sweep, long_polygon, field, sheet, patches, polynomials, formulas, julias, texts)}
