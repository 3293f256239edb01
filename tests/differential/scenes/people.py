"""Scenes as people wrote them from 1995 to 2015: headers of several versions, old words, loops, macros, include files, layered skies, lights of all kinds."""
from rng import block, lines
from scenes import standard
from words import common

COLORS = standard.COLORS


def scene(r):
    version = r.pick("3.0", "3.1", "3.5", "3.6", "3.7", "3.7", "")
    number = float(version or 3.6)
    parts = [f"#version {version};" if version else "", f"#include \"colors.inc\"\n#include \"textures.inc\"", r.some(.5, "#include \"woods.inc\"\n#include \"stones.inc\"\n#include \"metals.inc\"") or "#include \"metals.inc\"",
             r.some(.4, '#include "glass.inc"') if number >= 3.5 else "", '#include "shapes.inc"', '#include "skies.inc"' if number >= 3.5 else "",
             settings(r, number), default(r), declared(r, number), camera(r), sky(r, number)]
    parts += [light(r) for _ in range(r.whole(1, 3))]
    parts += [ground(r)]
    parts += [r.made(lambda: thing(r, number), lambda: thing(r, number), lambda: loop(r), lambda: maker(r) if number >= 3.1 else thing(r, number), lambda: clocked(r), lambda: pile(r)) for _ in range(r.whole(2, 4))]
    return lines(*parts)


def settings(r, number):
    return r.some(.75, block("global_settings", r.pick("", "assumed_gamma 1", "assumed_gamma 1.0", "assumed_gamma 2.2", "assumed_gamma 1.8"), r.some(.25, f"ambient_light {color(r)}"),
                             r.some(.4, f"max_trace_level {r.whole(2, 10)}"), r.some(.15, f"adc_bailout {r.pick('1/255', '.05', '.1')}"), r.some(.1, f"irid_wavelength rgb {r.vec(.2, .8)}"),
                             r.some(.2, f"number_of_waves {r.whole(1, 20)}"), r.some(.2, f"noise_generator {r.whole(1, 3)}") if number >= 3.5 else "", r.some(.1, "charset ascii") if number >= 3.5 else "",
                             r.some(.1, "hf_gray_16 off"), r.some(.1, f"max_intersections {r.whole(64, 128)}") if number < 3.7 else ""))


def default(r):
    return r.some(.4, "#default { " + r.pick(f"finish {{ ambient {r.num(0, .4)} diffuse {r.num(.4, .9)} }}", f"texture {{ pigment {{ {color(r)} }} finish {{ phong {r.num(.2, .9)} }} }}",
                                             f"pigment {{ color {r.pick(*COLORS)} }}", "texture { finish { ambient .25 diffuse .7 specular .3 roughness .02 } }") + " }")


def color(r):
    a, b, c = (r.num(0, 1) for _ in range(3))
    return r.pick(f"color {r.pick(*COLORS)}", f"color {r.pick(*COLORS)}", f"color rgb <{a}, {b}, {c}>", f"colour red {a} green {b} blue {c}", f"rgb <{a},{b},{c}>", f"color {r.pick(*COLORS)}*{a}",
                  f"rgb {a}", f"color rgb ({r.pick(*COLORS)} + {r.pick(*COLORS)})/2")


def clear(r):
    return r.made(lambda: f"rgbf <{r.num(.5, 1)}, {r.num(.5, 1)}, {r.num(.5, 1)}, {r.num(.3, 1)}>", lambda: f"color {r.pick(*COLORS)} filter {r.num(.2, .9)}",
                  lambda: f"color {r.pick(*COLORS)} transmit {r.num(.2, .9)}", lambda: "Clear", lambda: f"color rgbt <{r.num(.5, 1)}, {r.num(.5, 1)}, {r.num(.5, 1)}, {r.num(.3, 1)}>")


def declared(r, number):
    """Names that scenes begin with."""
    map_ = "color_map { " + " ".join(f"[{at} {color(r)}]" for at in ("0.0", "0.35", "0.7", "1.0")) + " }"
    double = f"color_map {{ [0.0, 0.4 {one(r)} {one(r)}] [0.4, 0.8 {one(r)} {one(r)}] [0.8, 1.001 {one(r)} {one(r)}] }}"
    return lines(f"#declare Map = {map_}", f"#declare Double = {double}", f"#declare Shade = {color(r)};",
                 f"#declare Paint = texture {{ {pigment(r, False)} {finish(r, 3.5)} }}", f"#declare Bumpy = normal {{ {r.pick('bumps', 'wrinkles', 'dents', 'ripples', 'waves')} {r.num(.2, .8)} scale {r.num(.1, .5)} }}",
                 f"#declare Gloss = finish {{ ambient {r.num(0, .3)} diffuse {r.num(.4, .8)} phong {r.num(.2, 1)} phong_size {r.num(10, 90)} }}", f"#declare R1 = seed({r.whole(1, 9999)});", f"#declare Size = {r.num(.2, .5)};",
                 "" if number < 3.1 else "#macro Post(Where, High, Look) union { cylinder { 0, High*y, .12 } sphere { High*y, .2 texture { Look } } texture { Look } translate Where } #end")


def one(r):
    return f"color {r.pick(*COLORS)}" if r.chance(.6) else f"color rgb <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}>"


def camera(r):
    place = f"location {r.box((-3, 3), (.6, 3), (-7, -4))}"
    look = f"look_at <{r.num(-.4, .4)}, {r.num(-.4, .4)}, 0>"
    return r.pick(f"camera {{ {place} {look} }}", f"camera {{ {place} direction <0, 0, {r.num(1, 2)}> up <0, 1, 0> right <4/3, 0, 0> {look} }}", f"camera {{ {place} right x*image_width/image_height {look} angle {r.num(35, 65)} }}",
                  f"camera {{ perspective {place} angle {r.num(30, 60)} {look} }}", f"camera {{ orthographic {place} {look} up <0, 5, 0> right <6.667, 0, 0> }}", f"#declare Cam = camera {{ {place} {look} }} camera {{ Cam }}",
                  f"camera {{ ultra_wide_angle {place} {look} angle {r.num(80, 150)} }}", f"camera {{ {place} up y right 1.33*x direction 1.4*z sky <.1, 1, 0> {look} }}",
                  f"camera {{ fisheye {place} {look} angle {r.num(90, 160)} }}", f"camera {{ {place} right -1.33*x {look} }}")


def sky(r, number):
    def layer(clouds):
        upper = f"[0 {r.pick('rgbt 1', 'Clear', 'color rgbt <1, 1, 1, 1>')}] [{r.num(.2, .5)} rgbt <1, 1, 1, {r.num(.4, 1)}>] [1 {one(r)}]"
        return f"pigment {{ {r.pick('bozo', 'wrinkles', 'granite', 'agate')} turbulence {r.num(0, .8)} octaves {r.whole(3, 7)} color_map {{ {upper} }} scale {r.pick('<.5, .15, .5>', '.3', '<1, .2, .2>')} {r.some(.2, 'rotate 20*z')} }}" \
            if clouds else f"pigment {{ gradient y color_map {{ [0 {one(r)}] [{r.num(.2, .7)} {one(r)}] [1 {one(r)}] }} {r.some(.3, 'scale 2 translate -1')} }}"
    return r.made(lambda: f"background {{ {color(r)} }}", lambda: "", lambda: block("sky_sphere", layer(False)), lambda: block("sky_sphere", layer(False), layer(True)),
                  lambda: block("sky_sphere", layer(False), layer(True), layer(True), r.some(.3, f"rotate {r.vec(-30, 30)}")) + r.some(.5, f"\nbackground {{ {color(r)} }}"),
                  lambda: block("sphere", f"0, {r.pick('1000', '5000', '100')}", layer(False)[:-1] + f" scale {r.pick('1000', '100')} }}", f"finish {{ ambient {r.pick('1', '.8')} diffuse 0 }}", r.some(.6, "hollow"), r.some(.3, "inverse")),
                  lambda: block("plane", "y, 300", "texture { pigment { bozo turbulence .5 color_map { [0 White] [.5 SkyBlue] [1 Blue] } scale <200, 60, 200> } finish { ambient 1 diffuse 0 } }", r.some(.5, "hollow")),
                  lambda: f"sky_sphere {{ {r.pick('S_Cloud1', 'S_Cloud2', 'S_Cloud5')} }}" if number >= 3.5 else f"sky_sphere {{ pigment {{ {r.pick('Blue_Sky', 'Bright_Blue_Sky', 'Clouds', 'Blood_Sky')} }} }}",
                  lambda: f"background {{ {color(r)} }}\nfog {{ {r.pick('', 'fog_type 1')} distance {r.num(10, 80)} {color(r)} }}",
                  lambda: f"sky_sphere {{ {layer(False)} }}\nfog {{ fog_type 2 distance {r.num(5, 60)} {color(r)} fog_offset {r.num(-1, .5)} fog_alt {r.num(.2, 2)} {r.some(.3, f'turbulence {r.num(.1, .5)} turb_depth .3')} }}")


def light(r):
    place, tint = r.box((-20, 20), (8, 30), (-25, -5)), r.pick("color White", "White", "rgb 1", f"color {r.pick(*COLORS)}", "color rgb <1, .95, .8>", "color Gray70", "White*.6")
    return r.made(lambda: f"light_source {{ {place} {tint} }}", lambda: f"light_source {{ {place} {tint} }}", lambda: f"light_source {{ {place}, {tint} shadowless }}",
                  lambda: f"light_source {{ {place} {tint} spotlight radius {r.num(5, 15)} falloff {r.num(15, 30)} tightness {r.num(1, 20)} point_at <0, 0, 0> }}",
                  lambda: f"light_source {{ {place} {tint} area_light <{r.num(1, 5)}, 0, 0>, <0, 0, {r.num(1, 5)}>, {r.whole(2, 5)}, {r.whole(2, 5)} adaptive {r.whole(0, 2)} }}",
                  lambda: f"light_source {{ 0*x {tint} looks_like {{ sphere {{ 0, .25 pigment {{ Yellow }} finish {{ ambient 1 }} }} }} translate {r.box((-2, 2), (1, 2), (-2, 1))} }}",
                  lambda: f"light_source {{ {place} {tint} cylinder radius {r.num(1, 3)} falloff {r.num(3, 5)} point_at <0, 0, 0> }}", lambda: f"light_source {{ {place} {tint} parallel point_at <0, 0, 0> }}",
                  lambda: f"light_source {{ {place} {tint} fade_distance {r.num(10, 40)} fade_power {r.pick('1', '2')} }}",
                  lambda: f"light_source {{ {place} {tint} projected_through {{ box {{ <-4, 3, -4>, <4, 3.1, 4> }} }} }}" if r.chance(.4) else f"light_source {{ {place} {tint} }}")


def pigment(r, mapped=True):
    pattern = r.pick("bozo", "marble", "wood", "agate", "granite", "gradient x", "gradient y", "onion", "leopard", "spotted", "wrinkles", "radial", "crackle", "spiral1 4", "quilted", "bumps", "ripples", "waves")
    turb = r.some(.4, f"turbulence {r.pick(r.num(.1, 1), r.vec(0, 1))}") + r.some(.15, f" octaves {r.whole(1, 6)} lambda {r.num(1.5, 3)} omega {r.num(.3, .7)}")
    some_map = lambda: f"color_map {{ [0.0 {one(r)}] [{r.num(.2, .8)} {one(r)}] [1.0 {one(r)}] }}"
    return r.made(lambda: f"pigment {{ {color(r)} }}", lambda: f"pigment {{ bozo color_map {{ {r.pick('Map', 'Double')} }} scale {r.num(.2, 1)} }}" if mapped else f"pigment {{ {color(r)} {r.some(.3, 'quick_color Red')} }}", lambda: f"pigment {{ checker {one(r)} {one(r)} scale {r.num(.2, 1)} }}",
                  lambda: f"pigment {{ brick {one(r)}, {one(r)} brick_size <.5, .2, .3> mortar {r.num(.02, .08)} }}", lambda: f"pigment {{ hexagon {one(r)} {one(r)} {one(r)} scale {r.num(.2, .6)} }}",
                  lambda: f"pigment {{ {pattern} {turb} {some_map()} {r.some(.3, f'frequency {r.num(.5, 4)}')} {r.some(.2, f'phase {r.num(0, 1)}')} {r.some(.15, r.pick('sine_wave', 'triangle_wave', 'scallop_wave'))} scale {r.num(.2, 1.2)} {r.some(.3, f'rotate {r.vec(-90, 90)}')} }}",
                  lambda: f"pigment {{ {pattern} {turb} {some_map()} scale {r.num(.2, 1.2)} }}",
                  lambda: f"pigment {{ {pattern} pigment_map {{ [0.2 {color(r)}] [0.6 checker {one(r)} {one(r)} scale .2] [1.0 wood color_map {{ [0 {one(r)}] [1 {one(r)}] }} scale .2] }} scale {r.num(.4, 1.2)} }}",
                  lambda: f"pigment {{ average pigment_map {{ [1 bozo color_map {{ [0 {one(r)}] [1 {one(r)}] }} scale .3] [{r.num(.5, 2)} gradient y color_map {{ [0 {one(r)}] [1 {one(r)}] }}] }} }}")


def normal(r):
    pattern = r.pick("bumps", "dents", "ripples", "waves", "wrinkles", "granite", "agate", "marble", "quilted", "gradient x", "leopard", "onion", "crackle", "bozo", "wood", "brick", "checker", "radial", "spotted")
    size = f"{r.num(.1, 1)}"
    return r.made(lambda: f"normal {{ {pattern} {size} scale {r.num(.1, .6)} }}", lambda: f"normal {{ {pattern} {size} {r.some(.4, f'turbulence {r.num(.1, .6)}')} scale {r.num(.1, .6)} }}", lambda: "normal { Bumpy }",
                  lambda: f"normal {{ Bumpy scale {r.num(.5, 2)} }}", lambda: f"normal {{ gradient {r.pick('x', 'y')} {size} slope_map {{ [0 <0, 1>] [.5 <1, 1>] [.5 <1, -1>] [1 <0, -1>] }} scale {r.num(.2, .6)} }}",
                  lambda: f"normal {{ {pattern} {size} sine_wave frequency {r.num(1, 4)} scale .4 }}", lambda: f"normal {{ gradient y normal_map {{ [0 bumps {size} scale .2] [.5 ripples .4 scale .3] [1 granite .3] }} }}",
                  lambda: f"normal {{ average normal_map {{ [1 bumps {size} scale .2] [1 waves .5 scale .3] }} }}",
                  lambda: f"normal {{ bump_map {{ png \"picture.png\" interpolate 2 bump_size {r.num(.5, 3)} }} }}")


def finish(r, number):
    old = number < 3.5
    return r.made(lambda: f"finish {{ {r.pick('Dull', 'Shiny', 'Glossy', 'Phong_Glossy', 'Luminous', 'Phong_Dull', 'Mirror')} }}", lambda: "",
                  lambda: f"finish {{ ambient {r.num(0, .4)} diffuse {r.num(.3, .9)} phong {r.num(.2, 1)} phong_size {r.num(10, 200)} }}",
                  lambda: f"finish {{ ambient {r.num(0, .3)} specular {r.num(.2, 1)} roughness {r.pick('.01', '.05', '.001', '1/60')} {r.some(.3, 'metallic')} }}",
                  lambda: f"finish {{ ambient .1 diffuse {r.num(.1, .5)} reflection {r.num(.1, .7)} {r.some(.3, 'metallic')} brilliance {r.num(1, 6)} }}",
                  lambda: f"finish {{ ambient .1 irid {{ {r.num(.1, .5)} thickness {r.num(.1, .8)} turbulence {r.num(0, .6)} }} }}",
                  lambda: f"finish {{ Shiny ambient {r.num(0, .4)} {r.some(.4, f'reflection {r.num(.05, .3)}')} }}", lambda: f"finish {{ ambient {color(r).replace('color ', '')} diffuse .5 }}" if number >= 3.1 else "",
                  lambda: f"finish {{ reflection {{ {r.num(0, .3)}, {r.num(.3, .9)} {r.some(.4, 'falloff 2')} {r.some(.3, 'metallic')} }} }}" if not old else f"finish {{ reflection {r.num(.1, .5)} }}")


def glass(r, number):
    filter_ = f"pigment {{ {clear(r)} }}"
    return r.made(lambda: f"texture {{ {filter_} finish {{ phong .8 reflection {r.num(.05, .2)} {f'refraction 1 ior {r.num(1.1, 1.6)}' if number < 3.5 else ''} }} }}" + (f" interior {{ ior {r.num(1.1, 1.6)} }}" if number >= 3.5 else ""),
                  lambda: f"texture {{ {r.pick('Glass', 'Glass2', 'Glass3', 'Green_Glass', 'NBglass', 'NBoldglass')} }}" + (f" interior {{ ior {r.num(1.2, 1.6)} }}" if number >= 3.5 else ""),
                  lambda: f"{filter_} finish {{ specular .7 roughness .001 }} interior {{ ior {r.num(1.1, 1.6)} {r.some(.4, f'fade_distance {r.num(.5, 2)} fade_power {r.whole(1, 2)}')} {r.some(.2, f'caustics {r.num(.3, 1)}')} }}" if number >= 3.1 else f"{filter_}",
                  lambda: f"material {{ texture {{ {filter_} finish {{ phong .6 }} }} interior {{ ior {r.num(1.1, 1.6)} }} }}" if number >= 3.5 else filter_)


def look(r, number):
    name = r.made(lambda: r.pick("Jade", "Red_Marble", "White_Marble", "Blood_Marble", "Blue_Agate", "Cherry_Wood", "Pine_Wood", "Dark_Wood", "Tan_Wood", "DMFWood4", "Rosewood", "Chrome_Metal", "Brass_Metal", "Gold_Metal", "Polished_Chrome",
                                 "New_Penny", "Silver1", "Brushed_Aluminum", "Candy_Cane", "Cork", "Water", "Rust"), lambda: f"T_{r.pick('Brass', 'Chrome', 'Silver', 'Gold')}_{r.whole(1, 5)}{r.pick(*'ABCDE')}")
    return r.made(lambda: f"texture {{ {pigment(r)} {finish(r, number)} }}", lambda: f"texture {{ {pigment(r)} {normal(r)} {finish(r, number)} {r.some(.3, f'scale {r.num(.4, 1.5)}')} }}", lambda: f"{pigment(r)} {finish(r, number)}", lambda: f"{pigment(r)} {normal(r)}",
                  lambda: f"texture {{ {name} {r.some(.5, f'scale {r.num(.3, 1.5)}')} {r.some(.3, f'rotate {r.vec(-90, 90)}')} }}", lambda: f"texture {{ {name} {normal(r)} }}", lambda: f"texture {{ {name} {finish(r, number)} }}",
                  lambda: glass(r, number), lambda: glass(r, number), lambda: "texture { Paint }", lambda: f"texture {{ Paint finish {{ Gloss }} rotate {r.num(0, 90)}*y }}", lambda: f"texture {{ pigment {{ Shade }} finish {{ Gloss }} }}",
                  lambda: f"texture {{ {pigment(r)} }} texture {{ pigment {{ wood turbulence .1 color_map {{ [0 {clear(r)}] [.5 {clear(r)}] [1 Clear] }} scale .3 }} {finish(r, number)} }}",
                  lambda: f"texture {{ tiles {{ texture {{ Paint }} tile2 texture {{ {pigment(r)} }} }} scale {r.num(.2, .5)} }}", lambda: f"texture {{ checker texture {{ Paint }}, texture {{ {name} }} scale {r.num(.2, .5)} }}",
                  lambda: f"texture {{ {r.pick('bozo', 'gradient y', 'marble turbulence .4', 'leopard scale .1', 'granite')} texture_map {{ [0.3 Paint] [0.7 {name}] [0.7 {pigment(r)} {finish(r, number)}] }} scale {r.num(.4, 1.2)} }}",
                  lambda: f"texture {{ average texture_map {{ [1 Paint] [{r.num(.5, 2)} {name}] }} }}",
                  lambda: f"texture {{ material_map {{ png \"picture.png\" {r.some(.3, 'interpolate 2')} texture {{ Paint }} texture {{ {name} }} texture {{ {pigment(r)} }} }} }}")


def ground(r):
    return r.made(lambda: f"plane {{ y, -1.013 pigment {{ checker {one(r)} {one(r)} }} {r.some(.3, 'finish { reflection .2 }')} }}", lambda: f"plane {{ <0, 1, 0>, -1.017 texture {{ pigment {{ {color(r)} }} {normal(r)} }} }}",
                  lambda: f"plane {{ y, -1.013 texture {{ {pigment(r)} finish {{ ambient .2 reflection {r.num(.05, .4)} }} }} }}", lambda: f"plane {{ y, -1.013 texture {{ pigment {{ {color(r)} }} normal {{ waves {r.num(.05, .3)} frequency {r.num(1, 5)} scale 2 }} finish {{ reflection .4 }} }} }}",
                  lambda: f"box {{ <-8, -1.2, -8>, <8, -1.011, 8> texture {{ {pigment(r)} }} }}", lambda: f"height_field {{ png \"picture.png\" smooth {r.some(.3, 'water_level .2')} texture {{ {pigment(r)} }} translate <-.5, 0, -.5> scale <14, .8, 14> translate -1.8*y }}",
                  lambda: "")


def place(r):
    return lines(r.some(.5, r.pick(f"rotate <{r.num(-90, 90)}, {r.num(-90, 90)}, 0>", f"rotate {r.num(-180, 180)}*y", f"rotate <0, {r.num(-90, 90)}, {r.num(-45, 45)}>")), r.some(.25, f"scale <{r.num(.6, 1.4)}, {r.num(.6, 1.4)}, {r.num(.6, 1.4)}>"),
                 f"translate {r.box((-1.8, 1.8), (-.3, .6), (-1.5, 1.5))}")


def shape(r):
    old = r.pick("Disk_X", "Disk_Y", "Cone_Y", "Cube", "UnitBox", "Sphere", "Ellipsoid", "Cone_X", "Cylinder_Y")
    word, body = common.solid(r, .9)
    other, other_body = common.solid(r, .7)
    return r.made(lambda: (word, body), lambda: (word, body), lambda: ("object", f"{old} scale {r.num(.4, .8)}"),
                  lambda: (r.pick("difference", "intersection", "union", "merge"), lines(block(word, body), block(other, other_body, r.some(.4, pigment(r)), f"translate {r.vec(-.5, .5)}"))),
                  lambda: ("union", lines(block(word, body, pigment(r)), block(other, other_body, f"translate {r.vec(-.6, .6)}"))),
                  lambda: ("text", f"ttf \"{r.pick('timrom.ttf', 'cyrvetic.ttf', 'crystal.ttf')}\" \"{r.pick('POV', 'Ray', '1998')}\" .25, 0 translate <-.9, -.3, 0>"),
                  lambda: ("blob", f"threshold {r.num(.3, .7)} " + " ".join(f"component {r.num(.7, 1.2)} {r.num(.6, 1)} {r.vec(-.6, .6)}" for _ in range(3)) if r.chance(.3) else f"threshold {r.num(.3, .7)} " + " ".join(f"sphere {{ {r.vec(-.6, .6)}, {r.num(.6, 1)}, {r.num(.7, 1.2)} }}" for _ in range(3))),
                  lambda: ("superellipsoid", f"<{r.num(.1, 1)}, {r.num(.1, 1)}> scale {r.num(.5, .8)}"), lambda: ("lathe", f"cubic_spline 6, <0, -1>, <.2, -.8>, <.7, -.3>, <.3, .2>, <.5, .8>, <.6, 1>"),
                  lambda: ("box", "<-1, -.5, -.7>, <1, .5, .7> scale .7 bounded_by { sphere { 0, 1.2 } }"), lambda: ("sphere", "0, .8 clipped_by { plane { y, .3 } }"))


def thing(r, number):
    word, body = shape(r)
    return block(word, body, look(r, number), place(r), r.some(.05, "no_shadow"), r.some(.08, "hollow"))


def loop(r):
    """A ring or a scatter of things."""
    body = r.made(lambda: f"sphere {{ 0, Size pigment {{ rgb <rand(R1), rand(R1), rand(R1)> }} }}", lambda: f"box {{ -Size/2, Size/2 rotate <rand(R1)*360, rand(R1)*360, 0> texture {{ Paint }} }}",
                  lambda: "cylinder { 0, y*(.3 + rand(R1)), .1 pigment { color rgb <1, rand(R1), 0> } finish { Gloss } }", lambda: "cone { 0, Size, y, 0 pigment { Shade*(.4 + .6*rand(R1)) } }"
                  if r.chance(.5) else "object { Cube scale Size/2 pigment { color Shade } finish { Shiny } }")
    body = body.replace("pigment { Shade*(.4 + .6*rand(R1)) }", "pigment { rgb (.4 + .6*rand(R1)) }")
    ring = f"translate <{r.num(1, 2)}, {r.num(-.8, .4)}, 0> rotate y*Turn"
    scatter = f"translate <rand(R1)*4 - 2, rand(R1)*1.5 - .8, rand(R1)*4 - 2>"
    if r.chance(.5):
        return f"#declare Turn = 0;\n#while (Turn < 360)\n  object {{ {body} {ring} }}\n  #declare Turn = Turn + {r.pick('30', '45', '40')};\n#end"
    return f"#declare Count = 0;\n#while (Count < {r.whole(4, 12)})\n  object {{ {body} {scatter} }}\n  #declare Count = Count + 1;\n#end"


def maker(r):
    return lines(*(f"Post({r.box((-2, 2), (-1, -1), (-1, 2))}, {r.num(.4, 1.6)}, texture {{ {r.pick('Paint', 'T_Brass_3A', 'Jade', 'pigment { Shade }', 'Chrome_Metal')} }})" for _ in range(r.whole(1, 3))))


def clocked(r):
    word, body = common.solid(r, .7)
    return block(word, body, "texture { Paint }", r.pick(f"rotate 360*clock*y translate {r.vec(-1, 1)}", f"translate <sin(clock*2*pi), {r.num(0, .5)}, cos(2*pi*clock)>", "#if (clock > .2) scale 1.3 #else scale .6 #end translate .4*x",
                                                  f"translate vrotate(<{r.num(.5, 1.5)}, 0, 0>, <0, clock*360 + 30, 0>)"))


def pile(r):
    word, body = common.solid(r, .5)
    return lines(f"#declare Piece = {block(word, body, r.some(.7, pigment(r)))}", "union {", *(f"  object {{ Piece {r.some(.3, pigment(r))} {r.some(.4, f'scale {r.num(.6, 1.3)}')} {r.some(.4, f'rotate {r.vec(-90, 90)}')} translate {r.vec(-1, 1)} }}" for _ in range(r.whole(2, 4))),
                 f"  {r.some(.6, 'texture { Paint }')} {place(r)} }}")
