"""Textures: patterns, warps, maps of maps, layers, normals, finishes, pictures, functions and glass, with many of each.

A maker returns (declarations, text of a texture); shapes say it once or for each of their parts.
"""
from rng import block, lines
from scenes import coats, copies, finishes, functions, hollow, lights, media, meshes, pictures, standard, textures
from words import common, patterns

from hunting.sizes import drawn, loop, spot


def pattern_of(word):
    """The maker of pigments of one pattern, turned, bent and mixed by many modifiers."""
    def look(r):
        colors = " ".join(f"[{value:g} {textures.color(r, r.chance(.15))}]" for value in sorted(r.real(0, 1) for _ in range(r.amount(2, 60))))
        use = r.whole(0, 4)
        more = lines(patterns.modifiers(r), r.some(.5, patterns.turbulence(r)), f"scale {r.size(.03, 1)}")
        if use == 0:
            return "", lines(common.pigment(r), block("normal", f"{word} {r.num(.1, .9)}", more), common.finish(r))
        if use == 1:
            return "", block("texture", word, block("texture_map", *(f"[{at} {common.pigment(r)} {common.finish(r)}]" for at in (.2, .5, .8))), more)
        return "", lines(block("pigment", word, f"color_map {{ {colors} }}", more), r.some(.3, block("normal", f"{word} .4", more)), common.finish(r))
    return look


def any_pattern(r):
    return pattern_of(patterns.pattern(r))(r) if r.chance(.5) else pattern_of(f"crackle form {r.vec(-1, 1)} metric {r.pick('1', '2', '3', '1.5', '4')} offset {r.num(0, .5)}")(r)


def fractals(r):
    word = r.pick(f"mandel {r.amount(30, 800)}", f"julia <{r.num(-1, 1)}, {r.num(-1, 1)}>, {r.amount(30, 800)}", f"magnet {r.whole(1, 2)} mandel {r.amount(20, 300)}")
    return pattern_of(word + r.some(.4, f" exponent {r.whole(2, 6)}") * ("magnet" not in word))(r)


def warps(r):
    """Dozens to a thousand of them, one after another."""
    count = r.amount(4, 600)
    kind = r.whole(0, 4)
    one = {0: f"warp {{ black_hole {spot(1.2, -1, 1)}, {drawn(.05, .6)} strength {drawn(.2, 2)} falloff {r.whole(1, 3)} {r.some(.4, 'inverse')} {r.some(.2, 'repeat <2, 2, 2>')} }}",
           1: f"warp {{ turbulence {drawn(0, .2)} octaves {r.whole(1, 6)} }}", 2: f"rotate {drawn(0, 40)}*{r.pick('x', 'y', 'z')} warp {{ repeat {r.pick('x', 'y', 'z')}*{drawn(.5, 2)} {r.some(.5, 'flip x')} }}",
           3: f"translate {drawn(-1, 1)} {r.pick('warp { cylindrical }', 'warp { spherical }', 'warp { toroidal }', 'warp { cubic }')} scale {drawn(.7, 1.4)}",
           4: patterns.warp(r)}[kind]
    count = min(count, 40) if kind == 1 else count
    word = r.pick("bozo", "checker rgb .2, rgb .9", "gradient x", "granite", "wood", "leopard", "marble", "hexagon rgb 1, rgb .5, rgb .2", "onion", "brick")
    inner = lines(f"{word} scale {r.num(.1, .5)}", loop(count, one))
    if r.chance(.3):
        return f"#declare Bent = function {{ pigment {{ {inner} }} }}", "pigment { function { Bent(x, y, z).gray } color_map { [0 rgb <.1, .2, .5>] [1 rgb 1] } }"
    return "", r.pick(f"pigment {{ {inner} }}", f"pigment {{ rgb .8 }} normal {{ {inner.replace(word, 'bumps .5')} }}")


def nests(r):
    """Maps of maps of maps."""
    few, deep = r.whole(2, 4), r.whole(2, 5)

    def inner(depth):
        if depth == 0:
            return r.pick(r.color(), f"{r.pick('bozo', 'granite', 'wood', 'checker')} scale {r.num(.05, .4)}", f"gradient {r.pick('x', 'y')} color_map {{ [0 {r.color()}] [1 {r.color()}] }} scale {r.num(.1, .5)}")
        kind = r.whole(0, 3)
        if kind == 0:
            return "average pigment_map { " + " ".join(f"[{r.num(.3, 2)} {inner(depth - 1)}]" for _ in range(few)) + " }"
        if kind == 1:
            return f"checker pigment {{ {inner(depth - 1)} }} pigment {{ {inner(depth - 1)} }} scale {r.num(.1, .6)}"
        return f"{patterns.pattern(r)} pigment_map {{ " + " ".join(f"[{at / few:.3f} {inner(depth - 1)}]" for at in range(few)) + f" }} {r.some(.4, patterns.turbulence(r))} scale {r.num(.1, .8)}"
    return f"#declare Nest = pigment {{ {inner(deep)} }}", f"pigment {{ Nest {r.some(.5, f'scale {r.num(.3, 2)}')} }} {common.finish(r)}"


def long_maps(r):
    """Maps of hundreds of entries: colours, pigments, textures, normals."""
    count, word = r.amount(20, 800), r.pick("bozo", "granite", "gradient y", "radial", "wood", "crackle", "leopard", "marble turbulence .4")
    entry = {"color": "rgb <rand(S), rand(S), rand(S)>", "pigment": f"{r.pick('bozo', 'wood', 'granite', 'checker', 'gradient x')} scale {drawn(.1, .6)}",
             "normal": f"{r.pick('bumps', 'granite', 'ripples', 'wrinkles')} {drawn(.1, .8)} scale {drawn(.05, .4)}",
             "texture": f"pigment {{ rgb <rand(S), rand(S), rand(S)> }} finish {{ phong mod(I, 3)/3 diffuse {drawn(.4, 1)} {r.some(.3, 'reflection mod(I, 4)/20')} }} {r.some(.3, f'normal {{ bumps {drawn(0, .5)} scale .1 }}')}"}
    kind = r.pick(*entry)
    average = kind != "color" and r.chance(.4)
    entries = loop(min(count, 120), f"[1 {entry[kind]}]") if average else loop(count, f"[I/{count} {entry[kind]}]")
    map_ = f"{'average' if average else word} {kind}_map {{ {entries} }} scale {r.num(.1, 1)}"
    return "", {"color": f"pigment {{ {map_} }}", "pigment": f"pigment {{ {map_} }}", "normal": f"pigment {{ rgb .8 }} normal {{ {map_} }}", "texture": f"texture {{ {map_} }}"}[kind]


def layers(r):
    count = r.amount(3, 60)
    clear = f"{r.pick('bozo', 'wood', 'granite', 'marble turbulence .5', 'wrinkles')} color_map {{ [0 rgbt 1] [1 rgb{r.pick('f', 't')} <{drawn(.3, 1)}, {drawn(.3, 1)}, {drawn(.3, 1)}, {drawn(.5, .95)}>] }} scale {drawn(.05, .6)}"
    more = r.pick("", "", common.finish(r), coats.normal(r))
    return f"#macro Coats() texture {{ {common.pigment(r)} }} {loop(count, f'texture {{ pigment {{ {clear} }} {more} }}')} #end", "Coats()"


def coat(r):
    return lines(*(f"#declare Coat{at} = {lines(*(coats.layer(r, k > 0) for k in range(r.amount(1, 6))))}" for at in range(3))), coats.look(r)


def texture_tree(r):
    return "", textures.texture(r, r.whole(2, 5))


def normals(r):
    """Normals of normals: averages, slopes, pictures, patterns under turbulence."""
    def inner(depth):
        if depth == 0:
            return f"{r.pick('bumps', 'granite', 'ripples', 'wrinkles', 'dents', 'waves', 'crackle', 'leopard', 'agate')} {r.num(.1, .8)} {r.some(.5, patterns.turbulence(r))} scale {r.num(.03, .4)}"
        return f"{r.pick('average', 'average', 'bozo', 'gradient y', 'crackle')} normal_map {{ " + " ".join(f"[{at + 1}/{few} {inner(depth - 1)}]" for at in range(few)) + f" }} scale {r.num(.3, 1)}"
    few, deep = r.amount(2, 12), r.whole(1, 2)
    bent = block("normal", inner(deep)) if r.chance(.6) else textures.normal(r)
    return "", lines(common.pigment(r), bent, common.finish(r))


def formula(r):
    """Pigments and normals of deep functions, of pigments and patterns asked by functions."""
    made = functions.Made()
    makers = (functions.formula_of, functions.pattern_of, functions.pigment_of, functions.pigment_of, functions.spline_of, functions.transform_of, functions.nested_of)
    declared = [r.pick(*makers)(r, made) for _ in range(r.whole(1, 8))]
    depth = r.whole(2, 5)
    map_ = f"color_map {{ [0 {r.color()}] [{r.num(.3, .7)} {r.color()}] [1 {r.color()}] }}"
    text = r.made(lambda: f"pigment {{ function {{ {functions.value(r, made, depth)} }} {map_} }}", lambda: f"pigment {{ rgb .8 }} normal {{ function {{ {functions.value(r, made, depth)} }} .5 scale .4 }}",
                  lambda: f"texture {{ function {{ {functions.value(r, made, depth)} }} texture_map {{ [0 {common.pigment(r)}] [1 {common.pigment(r)} {common.finish(r)}] }} }}")
    return lines(patterns.NOISE, *declared), text


def iterated(r):
    """A function that calls itself or sums many terms."""
    count = r.amount(4, 60)
    body = r.pick(f"sum(i, 1, {count}, sin(i*(x + y/i))/i)", f"prod(i, 1, {count}, cos(x*i/{count}) + y/{count})", f"sum(i, 1, {count}, f_noise3d(x*i, y*i, z*i)/i)",
                  f"sum(i, 1, {min(count, 12)}, sum(j, 1, {min(count, 12)}, exp(-4*(pow(x*3 - mod(i, 4), 2) + pow(y*3 - mod(j, 4), 2)))))")
    return f"{patterns.NOISE}\n#declare Many = function (x, y, z) {{ {body} }}", "pigment { function { Many(x, y, z) } color_map { [0 rgb <.1, .3, .6>] [.5 rgb 1] [1 rgb <.8, .4, .1>] } }"


def images(r):
    return "", pictures.texture(r, "3.7")


def made_images(r):
    """Pictures that a function fills, averaged, interpolated, used as bumps."""
    w = r.amount(40, 700)
    source = f"function {w}, {w} {{ pigment {{ {r.pick('crackle', 'granite', 'bozo turbulence .6', 'wood turbulence .2', 'leopard')} scale {r.num(.05, .3)} color_map {{ [0 rgb 0] [.5 {r.color()}] [1 rgb 1] }} }} }}"
    picture = f"image_map {{ {source} {patterns.interpolate(r)} map_type {r.pick('0', '0', '0', '1', '2', '5')} }}"
    count = r.amount(2, 200)
    return f"#declare Picture = pigment {{ {picture} translate -.5 }}", r.made(
        lambda: "pigment { Picture }", lambda: f"pigment {{ average pigment_map {{ {loop(count, f'[1 Picture translate <{drawn(-.05, .05)}, {drawn(-.05, .05)}, 0>]')} }} }}",
        lambda: f"pigment {{ rgb .7 }} normal {{ bump_map {{ {source} bump_size {r.num(.5, 4)} {patterns.interpolate(r)} }} }}",
        lambda: f"pigment {{ rgb .7 }} normal {{ average normal_map {{ {loop(min(count, 20), f'[1 bump_map {{ {source} bump_size 2 }} translate {drawn(0, .05)}]')} }} }}")


def objects(r):
    """Patterns of what is inside of an object, alone and averaged."""
    word, body = common.solid(r, .8)
    count = r.amount(2, 400)
    solid = r.pick(f"{word} {{ {body} }}", f"union {{ {loop(count, f'{word} {{ {body} scale {drawn(.05, .3)} translate {spot(1.5, -1, 1)} }}')} }}",
                   f"difference {{ box {{ -1.5, 1.5 }} {loop(count, f'{word} {{ {body} scale {drawn(.05, .3)} translate {spot(1.5, -1, 1)} }}')} }}")
    inner = f"object {{ Stencil {r.color()}, {r.color()} }}"
    shifts = r.amount(2, 80)
    return f"#declare Stencil = {solid}", r.pick(f"pigment {{ {inner} }}", f"pigment {{ average pigment_map {{ {loop(shifts, f'[1 {inner} translate {drawn(-.1, .1)}]')} }} }}",
                                                f"texture {{ object {{ Stencil texture {{ {common.pigment(r)} }} texture {{ {common.pigment(r)} {common.finish(r)} }} }} scale .7 }}")


def finish(r):
    return "", finishes.texture(r, False)


def glass(r):
    return "", lines(finishes.texture(r, True), finishes.interior(r))


def stuff(r):
    return "", hollow.dress(r)


def filled(r):
    """Clear and full of media."""
    return "", lines(f"pigment {{ rgb{r.pick('t', 'f')} 1 }} hollow", block("interior", *(media.media(r) for _ in range(r.whole(1, 3)))))


def dispersed(r):
    return "", f"pigment {{ rgbf <.9, .95, 1, {r.num(.6, 1)}> }} finish {{ reflection {{ 0, 1 fresnel }} conserve_energy }} interior {{ ior {r.num(1.2, 1.8)} dispersion {r.num(1.01, 1.1)} dispersion_samples {r.amount(3, 30)} }}"


def library(r):
    return lines(*standard.includes()), standard.look(r)


def charts(r):
    return "", f"uv_mapping texture {{ {meshes.chart(r)} {common.finish(r)} }}"


def moved(r):
    """What one look is, moved anew for each thing that has it."""
    inner = r.pick("pigment { granite }", lights.see_through(r), common.pigment(r), coats.layer(r, False))
    if not inner.startswith("texture"):
        inner = f"texture {{ {inner} }}"
    return f"#declare Once = {inner}", f"texture {{ Once scale {drawn(.2, 2)} rotate 360*rand(S)*y translate {spot()} {r.some(.3, 'finish { phong rand(S) }')} }}"


LOOKS = {f"{word}_pattern": pattern_of(word) for word in patterns.PLAIN} | {
    look.__name__: look for look in (any_pattern, fractals, warps, nests, long_maps, layers, coat, texture_tree, normals, formula, iterated, images, made_images, objects, finish, glass, stuff, filled,
                                     dispersed, charts, moved)} | {"library_look": library}
