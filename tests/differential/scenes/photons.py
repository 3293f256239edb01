"""Photons: lights and targets of all kinds, their flags, settings, mirrors, glass and haze. One light and one target as a rule."""
from rng import block, lines
from words import common


def scene(r):
    alone = r.chance(.75)  # of several pairs POV-Ray's radius depends on the last digit of every photon
    area = alone and r.chance(.15)
    settings = block("global_settings", "assumed_gamma 1", f"max_trace_level {r.whole(5, 9)}", photon_settings(r))
    parts = ["#version 3.7;", settings, f"camera {{ location <{r.num(-1, 1)}, {r.num(3, 5)}, {r.num(-6, -4)}> look_at <0, .5, 0> angle {r.num(38, 55)} }}",
             f"plane {{ y, 0 pigment {{ {r.pick(f'rgb {r.num(.5, 1)}', 'checker rgb 0.9, rgb 0.6')} }} finish {{ ambient 0.05 diffuse {r.num(.4, .9)} {r.some(.3, 'phong .5')} {r.some(.2, 'brilliance 2')} }} }}"]
    parts += [light(r, area)]
    if not alone:
        parts += [light(r, False)]
    parts += [target(r)]
    if not alone and r.chance(.5):
        parts += [target(r)]
    if r.chance(.5):
        parts += [bystander(r)]
    return lines(*parts)


def photon_settings(r):
    items = [f"spacing {r.num(.05, .12)}" if r.chance(.8) else f"count {r.whole(600, 3000)}"]
    if r.chance(.3):
        items.append(f"gather {r.whole(5, 30)}, {r.whole(40, 120)}")
    if r.chance(.3):
        items.append(f"radius {r.num(.1, .6)}" + r.some(.4, f", {r.num(.5, 2)}"))
    if r.chance(.2):
        items.append(f"jitter {r.pick('0', '.2', '1')}")
    if r.chance(.2):
        items.append(f"autostop {r.pick('0', '.3', '1')}")
    if r.chance(.2):
        items.append(f"expand_thresholds {r.num(0, 1)}, {r.whole(0, 60)}")
    if r.chance(.2):
        items.append(f"max_trace_level {r.whole(3, 8)}")
    if r.chance(.15):
        items.append(f"adc_bailout {r.num(.001, .1)}")
    return block("photons", *items)


def flags(r, of_target):
    way = r.pick("refraction on", "refraction on", "refraction on reflection on", "reflection on", "reflection on refraction off")
    return block("photons", r.some(of_target, f"target {r.pick('', '', '1.3', '.8')}"), way, r.some(.7, "collect off"))


def light(r, area):
    body = [r.box((-5, 5), (5, 9), (-3, 4)), r.color(.6, 1.2)]
    kind = r.pick("", "", "", "parallel point_at 0", f"spotlight point_at <0, .7, 0> radius {r.num(5, 15)} falloff {r.num(16, 30)}")
    if area:
        kind = f"area_light x*{r.num(.2, 1)}, z*{r.num(.2, 1)}, {r.whole(2, 3)}, {r.whole(1, 3)}"
    own = r.pick("", "refraction on", "reflection on", "refraction on reflection on") + r.some(area, " area_light")
    fade = r.some(.2, f"fade_distance {r.num(4, 12)} fade_power {r.pick('1', '2')}")
    return f"light_source {{ {body[0]}, {body[1]} {kind} {fade} photons {{ {own} }} }}"


def matter(r):
    glass = r.chance(.75)
    if not glass:
        return (f"pigment {{ {r.color(.3, 1)} }} finish {{ ambient 0.05 diffuse .3 reflection {{ {r.num(.3, .9)} {r.some(.4, 'metallic')} }} }}")
    clear = r.pick("rgbt 1", f"rgbf <{r.num(.5, 1)}, {r.num(.5, 1)}, {r.num(.5, 1)}, {r.num(.7, 1)}>", f"rgbft <.9, .8, 1, {r.num(0, .5)}, {r.num(.3, .5)}>")
    mirror = r.pick("", "", f"reflection {r.num(.05, .4)}", "reflection { 0.05, 1 fresnel } conserve_energy")
    inner = " ".join([f"ior {r.num(1.1, 1.8)}", r.some(.2, "fade_distance 1 fade_power 1 fade_color <.8, .5, .3>"), r.some(.15, "dispersion 1.05 dispersion_samples 3")])
    return f"pigment {{ {clear} }} finish {{ ambient 0 diffuse {r.pick('0', '.1')} {mirror} }} interior {{ {inner} }}"


def target(r):
    place = f"translate <{r.num(-1, 1)}, {r.num(1.1, 1.8)}, {r.num(-.8, .8)}>"
    turn = r.some(.5, f"rotate {r.vec(-40, 40)}")
    shape = r.pick("sphere { 0, 1", "sphere { 0, 1", "box { -.7, .7", "torus { .7, .3", "cylinder { -.6*y, .6*y, .8",
                   "difference { sphere { 0, 1 } sphere { .5*y, .8 }", "intersection { sphere { -.6*y, 1 } sphere { .6*y, 1 }",
                   "merge { sphere { -.3*x, .7 } sphere { .3*x, .7 }", "union { sphere { -.8*x, .5 } sphere { .8*x, .5 }")
    return f"{shape} {matter(r)} {turn} {place} {flags(r, True)} }}"


def bystander(r):
    where = r.box((-2, 2), (.3, 3), (-1.5, 1.5))
    return (f"sphere {{ {where}, {r.num(.2, .5)} {matter(r)} "
            + r.pick("", "photons { pass_through }", "photons { refraction on }", "photons { collect off }") + " }")
