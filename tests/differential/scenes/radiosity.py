"""Light that surfaces hand on to each other, with all its settings; what POV-Ray makes of it is never twice the same."""
from rng import block, lines
from words import common


def scene(r):
    version = r.pick("3.7", "3.7", "3.7", "3.6")
    parts = [f"#version {version};", block("global_settings", "assumed_gamma 1", settings(r)),
             r.some(.2, f"#default {{ radiosity {{ importance {r.num(.2, 1)} }} }}"),
             f"#default {{ finish {{ ambient {r.pick('0', '.1')} diffuse {r.num(.4, .9)} }} }}", common.camera(r)]
    parts += [r.pick(common.background(r), sky(r))]
    parts += [common.floor(r, r.some(.3, finish(r)))]
    if r.chance(.6):
        parts += [common.light(r)]
    if r.chance(.6):
        parts += [panel(r)]
    if r.chance(.3):
        parts += [f"box {{ <-3, -1, 2>, <3, 2, 2.2> {common.pigment(r)} }}"]
    parts += [thing(r) for _ in range(r.whole(2, 4))]
    return lines(*parts)


def settings(r):
    return block("radiosity", r.some(.6, f"count {r.whole(20, 90)}"), r.some(.5, f"error_bound {r.num(.4, 2)}"),
                 r.some(.5, f"recursion_limit {r.whole(1, 3)}"), r.some(.4, f"nearest_count {r.whole(1, 10)}"),
                 r.some(.4, f"pretrace_end {r.num(.02, .06)}"), r.some(.2, f"low_error_factor {r.num(.4, .9)}"),
                 r.some(.2, f"gray_threshold {r.num(0, 1)}"), r.some(.2, f"brightness {r.num(.6, 1.6)}"),
                 r.some(.2, f"max_sample {r.num(.5, 3)}"), r.some(.2, f"minimum_reuse {r.num(.01, .05)}"),
                 r.some(.2, f"adc_bailout {r.num(.002, .05)}"), r.some(.2, f"normal {r.pick('on', 'off')}"),
                 r.some(.2, f"always_sample {r.pick('on', 'off')}"))


def sky(r):
    return (f"sky_sphere {{ pigment {{ gradient y color_map {{ [0 {r.color(.3, .8)}] [1 {r.color(.2, .9)}] }} }} }}")


def panel(r):
    """Something that glows."""
    where = r.box((-2.5, 2.5), (1, 2.5), (-1, 2))
    return (f"box {{ <-.7, -.05, -.5>, <.7, .05, .5> rotate {r.vec(-60, 60)} translate {where} pigment {{ {r.color(.5, 1)} }} "
            f"finish {{ emission {r.num(.5, 2)} diffuse 0 }} {r.some(.15, 'no_radiosity')} }}")


def finish(r):
    return block("finish", r.some(.3, f"diffuse {r.num(.3, 1)}"), r.some(.2, f"reflection {r.num(.05, .5)}"),
                 r.some(.2, f"specular {r.num(.1, .6)}"), r.some(.15, f"emission {r.num(0, .3)}"))


def thing(r):
    word, body = common.solid(r, .9)
    return block(word, body, common.pigment(r), r.some(.4, finish(r)), r.some(.2, f"radiosity {{ importance {r.num(.2, 1)} }}"),
                 r.some(.1, "no_radiosity"), common.place(r))
