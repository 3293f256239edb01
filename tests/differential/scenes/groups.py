"""Light groups, also in one another and with the scene's lights, rainbows, and what both do with glass, mirrors and fog."""
from rng import block, lines
from scenes import lights
from words import common


def scene(r):
    parts = [common.HEADER, common.camera(r), common.background(r), common.floor(r, r.some(.4, common.finish(r)))]
    parts += [lights.light(r) for _ in range(r.whole(0, 2))]
    parts += [common.thing(r, .7) for _ in range(r.whole(0, 2))]
    if r.chance(.3):
        parts += [declared(r)]
    parts += [group(r, 0) for _ in range(r.whole(0, 3))]
    if r.chance(.5):
        parts += [rainbow(r) for _ in range(r.whole(1, 2))]
    if r.chance(.2):
        parts += [lights.fog(r)]
    if r.chance(.15):
        parts += [lights.sky(r)]
    return lines(*parts)


def group(r, depth):
    body = [lights.light(r) for _ in range(r.whole(0, 2))]
    body += [member(r, depth) for _ in range(r.whole(1, 3))]
    return block("light_group", *r.shuffled(body), r.some(.4, f"global_lights {r.pick('on', 'off', '')}"),
                 r.some(.3, r.pick(f"translate {r.vec(-.5, .5)}", f"rotate y*{r.num(-90, 90)}", f"scale {r.num(.7, 1.2)}")))


def member(r, depth):
    if depth < 2 and r.chance(.15):
        return group(r, depth + 1)
    if r.chance(.2):
        return block(r.pick("union", "union", "merge", "difference", "intersection"), *(piece(r) for _ in range(r.whole(2, 3))),
                     lights.light(r) if r.chance(.1) else "", common.pigment(r), common.finish(r))
    if r.chance(.25):
        return glass(r)
    return common.thing(r, .8)


def piece(r):
    word, body = common.solid(r, .8)
    return block(word, body, r.some(.3, common.pigment(r)), common.place(r, .6))


def glass(r):
    word, body = common.solid(r, .8)
    return block(word, body, lights.see_through(r), common.finish(r), common.place(r),
                 block("interior", f"ior {r.num(1, 1.6)}", r.some(.4, f"fade_distance {r.num(.3, 2)} fade_power {r.pick('1', '2', '1000')} fade_color {r.color()}"),
                       r.some(.2, f"caustics {r.num(.3, 1)}")))


def declared(r):
    """A group that is declared and placed; without groups in it, whose objects POV-Ray lights otherwise in a copy (12.10)."""
    return lines(f"#declare Lit = {group(r, 2)}", *(f"object {{ Lit translate {r.vec(-1, 1)} }}" for _ in range(r.whole(1, 2))))


def rainbow(r):
    low = r.real(0, .5)
    colors = " ".join(f"[{place:g} rgbt <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(.3, 1)}>]"
                      for place in (0, low, r.real(low, 1), 1))
    arc = r.real(60, 360)
    return block("rainbow", f"direction {r.vec(-1, 1)}", f"angle {r.num(10, 60)}", f"width {r.num(2, 25)}", f"distance {r.num(2, 1000)}",
                 f"color_map {{ {colors} }}", r.some(.5, f"arc_angle {arc:g} falloff_angle {r.num(10, arc)}"),
                 r.some(.4, f"up {r.vec(-1, 1)}"))
