"""Textures of many layers and maps of them, with mirrors, colours of thin films, metals, glass and normals in every layer."""
from rng import block, lines
from scenes import finishes, lights
from words import common, patterns


def scene(r):
    settings = block("global_settings", "assumed_gamma 1", r.some(.25, f"max_trace_level {r.whole(2, 9)}"), r.some(.15, f"adc_bailout {r.num(0, .1)}"), r.some(.1, f"irid_wavelength rgb {r.vec(.2, .8)}"))
    parts = ["#version " + r.pick("3.7", "3.7", "3.7", "3.6", "3.5") + ";", patterns.NOISE, settings, common.camera(r), common.background(r), common.light(r), r.some(.4, lights.light(r))]
    parts += [f"#declare Coat{at} = {coat(r)}" for at in range(3)]
    parts += [block("plane", "y, -1.037", r.pick(common.pigment(r), look(r)))]
    parts += [thing(r) for _ in range(r.whole(2, 3))]
    return lines(*parts)


def layer(r, clear):
    """One texture: what it lets through, how it is bent and how it shines."""
    pigment = common.pigment(r) if not clear else seen_through(r)
    return block("texture", pigment, r.some(.4, normal(r)), finishes.finish(r) if r.chance(.7) else "", r.some(.3, patterns.move(r)))


def seen_through(r):
    low, high = (f"rgb{r.pick('f', 't')} <{r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(.3, 1)}, {r.num(0, 1)}>" for _ in range(2))
    return r.made(lambda: lights.see_through(r), lambda: f"pigment {{ {r.pick('bozo', 'wood', 'marble', 'granite', 'leopard', 'gradient y')} color_map {{ [{r.num(0, .4)} {low}] [{r.num(.5, 1)} {high}] }} scale {r.num(.2, .8)} }}",
                  lambda: f"pigment {{ checker {low} {high} scale {r.num(.2, .6)} }}")


def normal(r):
    size, scale = r.num(.1, .8), f"scale {r.num(.1, .6)}"
    return r.made(lambda: f"normal {{ {r.pick('bumps', 'dents', 'ripples', 'waves', 'wrinkles', 'quilted')} {size} {scale} }}", lambda: f"normal {{ {r.pick('granite', 'gradient x', 'marble', 'leopard', 'brick', 'checker')} {size} {scale} }}",
                  lambda: f"normal {{ average normal_map {{ [1 bumps {size} {scale}] [{r.num(.3, 2)} gradient y {size} sine_wave {scale}] }} }}",
                  lambda: f"normal {{ {r.pick('radial frequency 6', 'gradient x', 'bozo')} normal_map {{ [0 ripples {size} {scale}] [.6 wrinkles {size} {scale}] [1 dents .4] }} {r.some(.4, 'no_bump_scale')} }}",
                  lambda: f"normal {{ wood {size} slope_map {{ [0 <0, 1>] [.5 <1, 0>] [1 <0, -1>] }} {scale} }}")


def coat(r):
    """One to three layers: declared, so that maps may name it."""
    layers = [layer(r, False)] + [layer(r, True) for _ in range(r.pick(0, 1, 1, 2))]
    return lines(*layers)


def entry(r):
    return r.pick("Coat0", "Coat1", "Coat2", layer(r, r.chance(.3))[len("texture {"):-1], f"Coat{r.whole(0, 2)} scale {r.num(.4, 2)}", f"Coat{r.whole(0, 2)} rotate {r.vec(-90, 90)}")


def look(r):
    kind = r.whole(0, 6)
    if kind < 2:
        return coat(r) if r.chance(.6) else f"texture {{ Coat{r.whole(0, 2)} {r.some(.4, patterns.move(r))} {r.some(.3, finishes.finish(r))} }}"
    if kind == 2:
        return block("texture", "average", block("texture_map", *(f"[{r.num(.2, 2)} {entry(r)}]" for _ in range(r.whole(2, 3)))))
    if kind == 3:
        word, count = r.pick(("checker", 2), ("brick", 2), ("hexagon", 3))
        return block("texture", word, *(f"texture {{ {entry(r)} }}" for _ in range(count)), f"scale {r.num(.2, .7)}", r.some(.3, patterns.move(r)))
    if kind == 4:
        return block("texture", r.pick("bozo", "gradient y", "spherical"), f"texture_map {{ [.4 {entry(r)}] [.6 {entry(r)}] }}", r.some(.4, f"scale {r.num(.3, 1.5)}"), r.some(.3, patterns.turbulence(r)))
    values = sorted(r.real(0, 1) for _ in range(r.whole(2, 4)))
    return block("texture", r.pick("bozo", "gradient x", "radial", "onion", "marble", "granite", "wood", "crackle", "aoi", "slope { y }"), block("texture_map", *(f"[{v:g} {entry(r)}]" for v in values)), patterns.modifiers(r))


def thing(r):
    word, body = common.solid(r, 1)
    inner = f"interior_texture {{ {entry(r)} }}" if r.chance(.12) else ""
    return block(word, body, look(r), inner, r.some(.5, finishes.interior(r)), common.place(r, 1.2), r.some(.08, "double_illuminate"), r.some(.06, "no_reflection"))
