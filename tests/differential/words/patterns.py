"""Every pattern with its parameters, wave shapes, turbulence, warps and transformations."""
from rng import block, lines

PLAIN = ("agate", "bozo", "boxed", "bumps", "cylindrical", "dents", "granite", "leopard", "marble", "onion", "planar", "radial", "ripples",
         "spherical", "spotted", "waves", "wood", "wrinkles", "crackle", "cells", "quilted")


NOISE = "#declare f_noise3d = function { internal(76) }"


def pattern(r, depth=""):
    """The words of a pattern in a pigment, texture or normal, without those that are lists; `depth` is of normals."""
    kind = r.whole(0, 15)
    if kind < 6:
        return r.pick(*PLAIN) + depth
    if kind == 6:
        return f"gradient {r.pick('x', 'y', 'z', r.vec(-1, 1))}{depth}"
    if kind == 7:
        return "crackle" + depth + r.some(.4, f" form {r.vec(-1, 1)}") + r.some(.3, f" metric {r.pick('1', '2', '3', '1.5')}") \
            + r.some(.3, f" offset {r.num(0, .5)}") + (r.some(.2, " solid") if not depth else "")
    if kind == 8:
        return f"{r.pick('spiral1', 'spiral2')} {r.whole(1, 7)}{depth}"
    if kind == 9:
        fractal = r.pick(f"mandel {r.whole(5, 40)}", f"julia <{r.num(-1, 1)}, {r.num(-1, 1)}>, {r.whole(5, 40)}", f"magnet 1 mandel {r.whole(5, 20)}",
                         f"magnet 2 julia <{r.num(-1, 1)}, {r.num(-1, 1)}>, {r.whole(5, 20)}")
        return fractal + depth + r.some(.2, f" exponent {r.whole(2, 5)}") * ("magnet" not in fractal) + r.some(.5, f" interior {r.whole(0, 6)}, {r.num(.2, 2)}") \
            + r.some(.5, " exterior " + r.pick(*"012345678") + f", {r.whole(1, 3)}")  # 7 with less than 1 ends POV-Ray by a division
    if kind == 10:
        return f"quilted{depth} control0 {r.num(0, 1.5)} control1 {r.num(0, 1.5)}"
    if kind == 11:
        return f"function {{ {formula(r)} }}{depth}"
    if kind == 12:
        return f"slope {{ {r.pick('x', 'y', 'z', r.vec(-1, 1))}" + r.some(.3, f", {r.num(0, .3)}, {r.num(.6, 1)}") + " }" + depth
    if kind == 13:
        return f"tiling {r.whole(1, 24)}{depth}"
    if kind == 14:
        return f"image_pattern {{ png \"picture.png\" gamma 1 {interpolate(r)} {r.some(.3, 'once')} }}{depth}"
    return "aoi" + depth if r.chance(.3) else f"pigment_pattern {{ {r.pick('bozo', 'granite', 'wood', 'radial')} color_map {{ [0 {r.color()}] [1 {r.color()}] }} scale {r.num(.3, 1)} }}{depth}"


def interpolate(r):
    return r.pick("", "interpolate 2", "interpolate 3", "interpolate 4")


def formula(r):
    """A function of x, y and z that is finite everywhere."""
    inner = r.pick("x", "y", "z", "x*y", "x+z", "sqrt(x*x+y*y)", "f_noise3d(x*3, y*3, z*3)", "atan2(y, x+3)", "x*x-z*z")
    return r.pick(f"{r.num(.2, 2)}*({inner})", f"sin({inner}*{r.num(1, 5)})/2+.5", f"mod(abs({inner})*{r.num(1, 4)}, 1)", f"abs({inner})",
                  f"select({inner}, {r.num(0, 1)}, {r.num(0, 1)}, x)", f"min(1, max(0, {inner}))", f"exp(-abs({inner}))", f"pow(abs({inner}), {r.num(.3, 2)})")


def modifiers(r):
    """Some of everything that may follow a pattern, in the order that is written."""
    return lines(*r.few(0, 3, [wave(r), phase(r), turbulence(r), warp(r), warp(r), move(r), move(r), f"scale {r.num(.15, .8)}", f"scale {r.num(.15, .8)}",
                               r.some(.3, f"noise_generator {r.whole(1, 3)}")]))


def wave(r):
    return r.pick("sine_wave", "triangle_wave", "ramp_wave", "scallop_wave", "cubic_wave", f"poly_wave {r.num(.3, 3)}")


def phase(r):
    return lines(f"frequency {r.pick(r.num(.3, 5), r.num(-3, 3))}", r.some(.5, f"phase {r.num(-1, 2)}"))


def turbulence(r):
    return lines(f"turbulence {r.pick(r.num(0, 1.2), r.vec(0, 1))}", r.some(.3, f"octaves {r.whole(1, 8)}"), r.some(.3, f"omega {r.num(.2, .8)}"),
                 r.some(.3, f"lambda {r.num(1.4, 3)}"))


def move(r):
    return r.pick(f"rotate {r.vec(-180, 180)}", f"translate {r.vec(-2, 2)}", f"scale {r.vec(.2, 1.5)}", f"rotate {r.pick('x', 'y', 'z')}*{r.num(-90, 90)}")


def warp(r):
    kind = r.whole(0, 7)
    if kind == 0:
        return block("warp", f"repeat {r.pick('x', 'y', 'z')}*{r.num(.4, 1.5)}", r.some(.4, f"offset {r.vec(-.3, .3)}"), r.some(.4, f"flip {r.pick('x', 'y', '<1, 1, 0>')}"))
    if kind == 1:
        return block("warp", f"black_hole {r.vec(-.6, .6)}, {r.num(.3, 1.2)}", r.some(.6, f"strength {r.num(.2, 2)}"), r.some(.6, f"falloff {r.num(.5, 3)}"),
                     r.some(.3, "inverse"), r.some(.2, f"repeat {r.vec(1.5, 3)}"))
    if kind == 2:
        return block("warp", f"turbulence {r.pick(r.num(0, 1), r.vec(0, 1))}", r.some(.4, f"octaves {r.whole(1, 7)}"), r.some(.3, f"omega {r.num(.2, .7)}"))
    if kind == 3:
        kind = r.pick("cylindrical", "spherical", "toroidal", "planar")
        return block("warp", kind, r.some(.4, f"orientation {r.pick('x', 'y', 'z')}") if kind != "planar" else "", r.some(.4, f"dist_exp {r.num(0, 1.5)}") if kind != "planar" else "")
    if kind == 4:
        return block("warp", "cubic")
    if kind == 5:
        return block("warp", "toroidal", f"major_radius {r.num(.3, 1.5)}")
    if kind == 6:
        return block("warp", f"planar {r.vec(-1, 1)}, {r.num(-.5, .5)}")
    return block("warp", f"spherical orientation {r.pick('x', 'y', 'z')}")
