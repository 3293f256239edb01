"""What is around the things: lights, air, cameras, and settings such as photons and radiosity.

A maker returns a dictionary: `settings` go into global_settings, `camera` takes the place of the plain one, `light` that of the plain light,
`text` is added, `target` goes into each thing, `options` to the command line.
"""
from rng import block, lines
from scenes import cameras, groups, lights, media, photons, radiosity
from words import common, patterns

from hunting.sizes import drawn, loop


def many_lights(r):
    kind = r.pick("", "", "spotlight radius 10 falloff 25 point_at 0", "cylinder radius 2 falloff 4 point_at 0", "fade_distance 3 fade_power 2", "shadowless", "parallel point_at 0")
    count = r.amount(5, 200)
    return dict(light=loop(count, f"light_source {{ <{drawn(-8, 8)}, {drawn(3, 9)}, {drawn(-9, 2)}>, rgb <rand(S), rand(S), rand(S)>*2/{count} {kind} }}"))


def area_lights(r):
    n, m = r.amount(4, 24), r.amount(4, 24)
    size = r.size(.3, 6)
    more = " ".join([r.some(.5, f"adaptive {r.whole(0, 3)}"), r.some(.5, "jitter"), r.some(.3, "circular"), r.some(.3, "orient") if n > 1 else "", r.some(.25, "area_illumination on")])
    return dict(light=lines(*(f"light_source {{ {r.box((-6, 6), (4, 8), (-7, -1))}, rgb {r.num(.4, 1)} area_light x*{size}, z*{size}, {n}, {m} {more} {r.some(.2, 'spotlight radius 15 falloff 40 point_at 0')} }}" for _ in range(r.whole(1, 2)))))


def all_lights(r):
    return dict(light=lines(*(lights.light(r) for _ in range(r.amount(2, 16)))))


def light_groups(r):
    return dict(light=common.light(r), text=lines(*(groups.group(r, 0) for _ in range(r.amount(2, 30)))))


def tinted_shade(r):
    """Shadows through things that let light pass."""
    word, body = common.solid(r, 1)
    count = r.amount(3, 100)
    pane = f"{word} {{ {body} scale {drawn(.2, .8)} translate <{drawn(-5, 5)}, {drawn(2.2, 3.5)}, {drawn(-5, 2)}> {r.pick(lights.see_through(r), 'pigment { bozo color_map { [0 rgbt 1] [1 rgbf <1, .5, .2, .7>] } scale .2 }')} {r.some(.4, 'interior { ior 1.4 caustics .6 }')} }}"
    return dict(light=lines(*(common.light(r) for _ in range(r.amount(1, 6)))), text=loop(count, pane))


def haze(r):
    """Media everywhere, seen by spots and lamps."""
    body = block("media", media.scattering(r, .15), r.some(.3, f"absorption {r.num(0, .05)}"), r.pick(media.sampling(r), f"method 3 samples {r.amount(4, 60)} intervals 1", f"method 1 intervals {r.amount(2, 20)} samples 1, {r.whole(1, 4)}"), r.some(.5, media.density(r)))
    return dict(light=lines(*(media.lamp(r) for _ in range(r.amount(1, 6)))), text=body + "\nsphere { 0, 40 pigment { rgb .4 } hollow }")


def smoke(r):
    return dict(text=lines(*(media.holder(r) for _ in range(r.amount(1, 12)))))


def dense_smoke(r):
    """A container whose media is asked at many places for a deep density."""
    body = block("media", r.pick(f"emission {r.num(.3, 1.5)}", media.scattering(r, 1)), r.pick(f"method 3 samples {r.amount(10, 150)} intervals {r.whole(1, 3)}", f"method 2 samples {r.amount(2, 30)} intervals {r.amount(1, 10)}", f"method 1 intervals {r.amount(3, 30)} samples 1, 3"),
                 *(media.density(r) for _ in range(r.whole(1, 3))), r.some(.5, f"density {{ bozo {patterns.turbulence(r)} scale {r.num(.1, .6)} color_map {{ [.4 rgb 0] [.8 rgb 1] }} }}"))
    return dict(text=f"{r.pick('sphere { 0, 1.4', 'box { -1.2, 1.2', 'cylinder { -y, y, 1.2', 'torus { 1, .5')} hollow pigment {{ rgbt 1 }} interior {{ {body} }} }}")


def fogs(r):
    return dict(text=lines(*(lights.fog(r) for _ in range(r.amount(1, 12)))))


def skies(r):
    layers = [block("pigment", r.pick("bozo", "wrinkles", "granite", "agate", "gradient y", "leopard"), patterns.turbulence(r), f"color_map {{ [0 rgbt 1] [.4 rgbt <1, 1, 1, {r.num(.3, 1)}>] [1 {r.color()}] }} scale <{r.num(.1, .6)}, .2, {r.num(.1, .6)}>")
              for _ in range(r.amount(1, 20))]
    return dict(text=block("sky_sphere", *layers) + "\n" + r.some(.3, lines(*(groups.rainbow(r) for _ in range(r.whole(1, 4))))))


def any_camera(r):
    return dict(camera=cameras.camera(r))


def blur(r):
    return dict(camera=f"camera {{ location <{r.num(-2, 2)}, 1.5, -5> look_at 0 angle 45 aperture {r.num(.05, .6)} focal_point {r.vec(-.5, .5)} blur_samples {r.amount(4, 80)} confidence {r.num(.8, .99)} variance {r.pick('0', '1/128', '1/1000')} }}")


def bent_camera(r):
    return dict(camera=f"camera {{ location <0, 1.5, -5> look_at 0 angle 45 normal {{ {patterns.pattern(r)} {r.num(.05, .5)} {patterns.modifiers(r)} }} }}".replace("normal { slope", "normal { bumps 1 //"))


def mirrors(r):
    """A room of mirrors."""
    return dict(settings=f"max_trace_level {r.amount(5, 30)}", text=f"box {{ <-4, -1.01, -7>, <4, 4, 4> pigment {{ {r.color()} }} finish {{ diffuse .3 reflection {r.num(.4, .95)} {r.some(.3, 'metallic')} }} {r.some(.3, 'normal { bumps .1 scale .3 }')} }}", light="light_source { <1, 3, -3>, rgb 1 }")


def caustics(r):
    settings = block("photons", f"spacing {r.size(.005, .08)}", r.some(.3, f"gather {r.whole(10, 40)}, {r.whole(50, 200)}"), r.some(.3, "media 50"), r.some(.3, f"jitter {r.num(0, 1)}"))
    return dict(settings=settings + f"\nmax_trace_level {r.whole(5, 12)}", light=lines(*(photons.light(r, r.chance(.15)) for _ in range(r.whole(1, 3)))), text=photons.target(r), target=r.some(.6, photons.flags(r, True)))


def bounces(r):
    return dict(settings=radiosity.settings(r), text=lines("#default { finish { ambient 0 diffuse .7 } }", r.some(.5, "box { <-4, -1.1, -7>, <4, 3, 4> pigment { rgb .8 } hollow }"), r.some(.5, radiosity.panel(r))))


def smooth(r):
    return dict(options=f"+A{r.pick('0.3', '0.1', '0.03')} +AM{r.whole(1, 2)} +R{r.whole(2, 4)}")


def deep(r):
    return dict(settings=f"max_trace_level {r.amount(8, 60)} adc_bailout {r.pick('0', '1/255', '.001')}")


AROUND = {made.__name__: made for made in (many_lights, area_lights, all_lights, light_groups, tinted_shade, haze, smoke, dense_smoke, fogs, skies, any_camera, blur, bent_camera, mirrors, caustics, bounces, smooth, deep)}
