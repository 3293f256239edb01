"""Picture files with palettes, alpha and grey: as colours, patterns, normals, materials, heights, in all projections and interpolations."""
from rng import block, lines
from words import common, patterns

FILES = (("png", "picture.png"), ("png", "alpha.png"), ("png", "gray.png"), ("png", "gray_alpha.png"), ("png", "deep.png"), ("png", "palette.png"), ("png", "palette_alpha.png"), ("ppm", "colors.ppm"),
         ("pgm", "grays.pgm"), ("tga", "colors.tga"), ("tga", "alpha.tga"), ("gif", "palette.gif"))
PALETTES = ("palette.png", "palette_alpha.png", "palette.gif")


def scene(r):
    version = r.pick("3.7", "3.7", "3.7", "3.6", "3.5", "3.1")
    settings = block("global_settings", r.pick("assumed_gamma 1", "assumed_gamma 1", "assumed_gamma 2.2"), r.some(.1, f"max_trace_level {r.whole(2, 8)}"))
    parts = [f"#version {version};", settings, common.camera(r), common.background(r), common.light(r), r.some(.3, common.light(r)),
             block("plane", "y, -1.037", r.made(lambda: texture(r, version), lambda: common.pigment(r)))]
    parts += [thing(r, version) for _ in range(r.whole(1, 3))]
    return lines(*parts)


def file(r, version, kinds=FILES):
    word, name = r.pick(*kinds)
    gamma = r.some(.3, f"gamma {r.pick('1', '2.2', 'srgb', '1.8')}") if version == "3.7" else ""
    return f'{r.pick(word, word, word if version != "3.7" else "")} "{name}" {gamma}' if version == "3.7" and word != "pgm" else f'{word} "{name}" {gamma}', name


def projection(r):
    return lines(f"map_type {r.pick('0', '0', '0', '1', '2', '5')}", patterns.interpolate(r), r.some(.25, "once"))


def clear(r, name):
    if name in PALETTES and r.chance(.4):
        return " ".join(f"{r.pick('filter', 'transmit')} {r.whole(0, 7)}, {r.num(0, 1)}" for _ in range(r.whole(1, 3)))
    return r.some(.25, f"{r.pick('filter', 'transmit')} all {r.num(0, 1)}")


def move(r):
    return lines(r.some(.5, "translate -.5"), r.some(.7, f"scale {r.pick(r.num(.4, 2), r.vec(.4, 2))}"), r.some(.3, f"rotate {r.vec(-90, 90)}"), r.some(.2, patterns.warp(r)))


def pigment(r, version):
    def image():
        text, name = file(r, version)
        use = r.some(.1, r.pick("use_color", "use_index")) if name in PALETTES else ""
        return block("pigment", r.some(.15, "uv_mapping"), block("image_map", text, projection(r), clear(r, name), use), move(r))

    def pattern():
        text, name = file(r, version)
        return block("pigment", block("image_pattern", text, projection(r), r.some(.3, "use_alpha") if "alpha" in name else ""), f"color_map {{ [0 {r.color()}] [.5 {r.color()}] [1 {r.color()}] }}", move(r))

    def mixed():
        text, name = file(r, version)
        return block("pigment", r.pick("bozo", "gradient x", "checker"), block("pigment_map", f"[0 {r.color()}]", f"[1 {block('image_map', text, projection(r), clear(r, name))}]"), f"scale {r.num(.4, 1.2)}") \
            .replace("checker\n", "gradient y\n")

    return r.made(image, image, image, pattern if version in ("3.7", "3.6", "3.5") else image, mixed)


def normal(r, version):
    text, name = file(r, version)
    return block("normal", block("bump_map", text, projection(r), f"bump_size {r.num(.3, 3)}", r.some(.3, r.pick("use_color", "use_index") if name in PALETTES else "use_color")), move(r))


def texture(r, version):
    def materials():
        text, name = file(r, version)
        return block("texture", block("material_map", text, f"map_type {r.pick('0', '0', '1', '2', '5')}", r.some(.25, "once"), *(f"texture {{ {common.pigment(r)} {common.finish(r)} }}" for _ in range(r.whole(2, 4)))), r.some(.7, f"scale {r.pick(r.num(.4, 2), r.vec(.4, 2))}"), r.some(.3, f"rotate {r.vec(-90, 90)}"))

    def layered():
        return lines(block("texture", common.pigment(r)), block("texture", pigment(r, version), r.some(.3, normal(r, version))))

    def plain():
        return block("texture", pigment(r, version), r.some(.3, normal(r, version)), r.some(.5, common.finish(r)))

    return r.made(plain, plain, plain, materials, layered, lambda: block("texture", common.pigment(r), normal(r, version), common.finish(r)))


def thing(r, version):
    word, body = common.solid(r, 1)
    if r.chance(.2):
        kind, name = r.pick(("png", "picture.png"), ("png", "gray.png"), ("png", "deep.png"), ("png", "palette.png"), ("pgm", "grays.pgm"), ("gif", "palette.gif"), ("tga", "colors.tga"))
        word, body = "height_field", lines(f'{kind} "{name}"', r.some(.4, "smooth"), r.some(.3, f"water_level {r.num(.1, .5)}"), "translate -.5", f"scale <2, {r.num(.5, 1.2)}, 2>")
    return block(word, body, texture(r, version), r.some(.2, "interior { ior 1.2 }"), common.place(r, 1.2))
