"""What scenes take from the standard include files: their textures, materials, skies, shapes, transformations, functions."""
from rng import block, lines
from words import common

LETTERS = "ABCDE"
SKY_TEXTURES = ("Jade", "Red_Marble", "White_Marble", "Blood_Marble", "Blue_Agate", "Sapphire_Agate", "Brown_Agate", "Pink_Granite",
                "PinkAlabaster", "Cherry_Wood", "Pine_Wood", "Dark_Wood", "Tan_Wood", "White_Wood", "Tom_Wood", "DMFWood1", "DMFWood2",
                "DMFWood4", "DMFWood6", "DMFLightOak", "DMFDarkOak", "EMBWood1", "Yellow_Pine", "Rosewood", "Sandalwood",
                "Chrome_Texture", "Brass_Texture", "Gold_Texture", "Bronze_Texture", "Copper_Texture", "Silver_Texture",
                "Chrome_Metal", "Brass_Metal", "Polished_Chrome", "Polished_Brass", "New_Brass", "Spun_Brass", "Brushed_Aluminum",
                "Silver1", "Silver2", "Silver3", "Brass_Valley", "Rust", "Rusty_Iron", "Soft_Silver", "New_Penny", "Tinny_Brass",
                "Gold_Nugget", "Aluminum", "Bright_Bronze", "Candy_Cane", "Peel", "Y_Gradient", "X_Gradient", "Cork", "Lightning1", "Lightning2")
MATERIALS = ("M_Glass", "M_Glass2", "M_Glass3", "M_Green_Glass", "M_NB_Glass", "M_NB_Old_Glass", "M_NB_Winebottle_Glass",
             "M_NB_Beerbottle_Glass", "M_Ruby_Glass", "M_Dark_Green_Glass", "M_Yellow_Glass", "M_Orange_Glass", "M_Vicks_Bottle_Glass", "M_Water")
GLASS_COLORS = ("Old", "Winebottle", "Beerbottle", "Ruby", "Green", "Dark_Green", "Yellow", "Orange", "Vicksbottle", "Clear", "General", "Bluish")
INTERIORS = ("I_Glass1", "I_Glass2", "I_Glass3", "I_Glass4", "I_Glass_Fade_Sqr1", "I_Glass_Fade_Exp1", "I_Glass_Fade_Exp2",
             "I_Glass_Fade_Exp3", "I_Glass_Caustics1", "I_Glass_Caustics2", "I_Glass_Dispersion1")
SKIES = ("S_Cloud1", "S_Cloud2", "S_Cloud3", "S_Cloud4", "S_Cloud5")
FINISHES = ("Dull", "Shiny", "Phong_Dull", "Phong_Shiny", "Glossy", "Phong_Glossy", "Luminous", "Mirror")
PIGMENTS = ("Blue_Sky", "Bright_Blue_Sky", "Blue_Sky2", "Blue_Sky3", "Blood_Sky", "Apocalypse", "Clouds", "FBM_Clouds",
            "P_Cloud1", "P_Cloud2", "P_Cloud3", "P_Cloud4")
COLORS = ("Red", "Green", "Yellow", "White", "Gray50", "Aquamarine", "Coral", "DarkOrchid", "Firebrick", "Gold", "Khaki", "Navy", "Plum",
          "SkyBlue", "SteelBlue", "Wheat", "SummerSky", "Feldspar", "Quartz", "NeonPink", "SpicyPink", "Flesh", "HuntersGreen", "Light_Purple")
OLD_SOLIDS = ("Tetrahedron", "Octahedron", "Dodecahedron", "Icosahedron", "Hexagon", "Rhomboid", "Pyramid", "Pyramid2", "HalfCone_Y")
# Functions that end within a few units, with room for their parameters.
FUNCTIONS = ("f_torus(x, y, z, .7, .3)", "f_rounded_box(x, y, z, .2, .8, .6, .7)", "f_superellipsoid(x, y, z, .5, .4)",
             "f_ellipsoid(x, y, z, 1.2, 1.6, 1.1) - 1", "f_sphere(x, y, z, .9)", "f_heart(x, y, z, -.5)", "f_cushion(x, y, z, .2)",
             "f_devils_curve(x, y, z, 1)", "f_glob(x, y, z, .5)", "f_helix1(x, y, z, 2, 8, .15, .6, 1, .4, 0)",
             "f_helix2(x, y, z, 0, 7, .2, .5, 1, .5, 20)", "f_mitre(x, y, z, 1)", "f_pillow(x, y, z, .4)", "f_piriform(x, y, z, .6)",
             "f_quantum(x, y, z, 0) - .1", "f_steiners_roman(x, y, z, .6)", "f_torus2(x, y, z, 1, .6, .3)", "f_torus_gumdrop(x, y, z, .5)",
             "f_spikes_2d(x, y, z, .4, 5, 5, 2)", "f_hetero_mf(x, .3, z, .8, 2, 4, 1.2, .4, 1) - 1.2 + y", "f_ridged_mf(x, .3, z, .8, 2, 4, 1, 2, 1) - 1 + y",
             "f_sphere(x, y, z, .8) - .3*f_noise3d(4*x, 4*y, 4*z)", "f_sphere(x, y, z, .8) + .2*f_granite(x, y, z)",
             "f_polytubes(x, y, z, .2, 5, .8, .1, .3, 1)", "f_mesh1(x, y, z, .4, .4, 1, .06, 1)", "f_comma(x, y, z, .7)")
# Numbers of stones and granites without crand, which is random in POV-Ray.
STONES = (1, 2, 3, 4, 5, 7, 9, 10, *range(23, 37), 44)
GRANITES = ("T_Grnt{}", (*range(19), 23, 24, 25, 27, 29)), ("T_Grnt{}a", (*range(19), 22, 23, 24))
PATTERNS = ("f_agate(x, y, z)", "f_boxed(x, y, z)", "f_bozo(x, y, z)", "f_bumps(x, y, z)", "f_crackle(3*x, 3*y, 3*z)", "f_cylindrical(x, y, z)",
            "f_dents(4*x, 4*y, 4*z)", "f_granite(x, y, z)", "f_leopard(9*x, 9*y, 9*z)", "f_marble(x, y, z)", "f_onion(3*x, 3*y, 3*z)",
            "f_radial(x, y, z)", "f_ripples(3*x, 3*y, 3*z)", "f_spherical(x, y, z)", "f_spiral1(x, y, z)",
            "f_waves(3*x, 3*y, 3*z)", "f_wood(2*x, 2*y, 2*z)", "f_wrinkles(3*x, 3*y, 3*z)", "f_scallop_wave(x + y, .5, 2)", "f_sine_wave(x + y, .5, 2)",
            "f_snoise3d(4*x, 4*y, 4*z)", "f_ph(x, y, z)", "f_th(x, y, z)", "f_r(x, y, z)")


def scene(r):
    settings = "global_settings { assumed_gamma 1 }" if r.chance(.7) else r.some(.5, "global_settings { assumed_gamma 2.2 }")
    parts = [r.pick("#version 3.7;", "#version 3.7;", "#version 3.6;"), *includes(), settings, common.camera(r), common.light(r),
             r.some(.3, common.light(r)), sky(r), floor(r)]
    parts += [thing(r) for _ in range(r.whole(2, 4))]
    return lines(*parts)


def includes():
    names = ("colors textures metals golds stones woods glass skies finish shapes shapes2 transforms functions math rand consts stars strings")
    return [f'#include "{name}.inc"' for name in names.split()]


def sky(r):
    return r.made(lambda: f"sky_sphere {{ {r.pick(*SKIES)} }}", lambda: f"background {{ {r.pick(*COLORS)} }}",
                  lambda: f"sky_sphere {{ pigment {{ {r.pick(*PIGMENTS)} scale {r.num(.3, 1)} }} }}", lambda: common.background(r),
                  lambda: f"sphere {{ 0, 500 texture {{ Starfield{r.whole(1, 6)} scale {r.num(50, 200)} }} hollow }}")


def floor(r):
    return block("plane", "y, -1", look(r) if r.chance(.4) else f"pigment {{ checker {r.pick(*COLORS)}, {r.pick(*COLORS)} }} finish {{ {r.pick(*FINISHES)} }}")


def texture_name(r):
    return r.made(lambda: r.pick(*SKY_TEXTURES), lambda: f"T_{r.pick('Brass', 'Copper', 'Chrome', 'Silver', 'Gold')}_{r.whole(1, 5)}{r.pick(*LETTERS)}",
                  lambda: granite(r), lambda: granite(r), lambda: f"T_Stone{r.pick(*STONES)}",
                  lambda: f"T_Wood{r.whole(1, 35)}", lambda: f"T_Stone{r.pick(*STONES)}", lambda: f"T_Crack{r.whole(1, 4)}")


def granite(r):
    name, numbers = r.pick(*GRANITES)
    return name.format(r.pick(*numbers))


def move(r):
    return lines(r.some(.6, f"scale {r.pick(r.num(.2, 1.5), r.vec(.3, 1.5))}"), r.some(.4, f"rotate {r.vec(-180, 180)}"),
                 r.some(.2, f"translate {r.vec(-2, 2)}"))


def look(r):
    """A texture or a material of the include files, moved and changed as scenes do it."""
    return r.made(lambda: block("texture", texture_name(r), move(r)), lambda: block("texture", texture_name(r), move(r)),
                  lambda: block("texture", texture_name(r), move(r), r.some(.5, f"finish {{ {r.pick(*FINISHES)} }}")),
                  lambda: block("texture", f"pigment {{ {r.pick(*COLORS)} }}", f"finish {{ {r.pick(*FINISHES)} {r.some(.3, f'ambient {r.num(0, .3)}')} }}"),
                  lambda: block("material", r.pick(*MATERIALS), move(r)), lambda: glass(r), lambda: layers(r), lambda: pattern(r))


def glass(r):
    return lines(f"texture {{ pigment {{ Col_Glass_{r.pick(*GLASS_COLORS)} }} finish {{ F_Glass{r.whole(5, 10)} }} }}", f"interior {{ {r.pick(*INTERIORS)} }}")


def layers(r):
    clear = f"P_WoodGrain{r.whole(1, 19)}B"
    return lines(f"texture {{ pigment {{ P_WoodGrain{r.whole(1, 19)}A {move(r)} }} }}", f"texture {{ pigment {{ {clear} {move(r)} }} }}")


def pattern(r):
    entries = " ".join(f"[{at} {r.pick(*COLORS)}]" for at in (0, .3, .6, 1))
    return block("pigment", f"function {{ {r.pick(*PATTERNS)} }}", f"color_map {{ {entries} }}", move(r))


def thing(r):
    shape = r.made(lambda: made_shape(r), lambda: made_shape(r), lambda: plain_shape(r), lambda: surface(r), lambda: letters(r), lambda: old_shape(r))
    return block("object", shape, look(r), place(r))


def made_shape(r):
    """A macro of shapes.inc."""
    merge = r.pick("yes", "no")
    a, b, e = r.vec(-.8, -.4), r.vec(.4, .8), r.num(.05, .15)
    radius = r.num(.2, .4)
    return r.pick(f"Round_Box({a}, {b}, {e}, {merge})", f"Wire_Box({a}, {b}, {e}, {merge})", f"Round_Cylinder({a}, {b}, {radius}, {e}, {merge})",
                  f"Round_Cone({a}, {r.num(.4, .6)}, {b}, {radius}, {e}, {merge})", f"Round_Cone2({a}, {r.num(.4, .5)}, {b}, {radius}, {merge})",
                  f"Round_Cone3({a}, {r.num(.4, .5)}, {b}, {radius}, {merge})", f"Connect_Spheres({a}, {r.num(.4, .5)}, {b}, {radius})",
                  f"Supercone({a}, {radius}, {r.num(.3, .6)}, {b}, {r.num(.2, .5)}, {e})", f"Spheroid({r.vec(-.2, .2)}, {r.vec(.4, 1)})",
                  f"Supertorus({r.num(.6, .8)}, {r.num(.15, .3)}, {r.num(.3, 1)}, {r.num(.3, 1)}, .001, 1.5)",
                  f"object {{ Wedge({r.num(20, 160)}) scale .9 clipped_by {{ sphere {{ 0, 1 }} }} }}",
                  f"union {{ Quad({a}, <{r.num(-.8, -.3)}, .7, 0>, {b}, <.8, {r.num(-.8, -.3)}, 0>) }}")


def plain_shape(r):
    word, body = common.solid(r, .9)
    return block(word, body)


def old_shape(r):
    return f"object {{ {r.pick(*OLD_SOLIDS)} scale {r.num(.4, .8)} }}"


def surface(r):
    return block("isosurface", f"function {{ {r.pick(*FUNCTIONS)} }}", f"contained_by {{ {r.pick('box { -1.3, 1.3 }', 'sphere { 0, 1.4 }')} }}",
                 "max_gradient 12 accuracy .0005", r.some(.3, "all_intersections"), r.some(.2, "open"))


def letters(r):
    font, word = r.pick("timrom.ttf", "cyrvetic.ttf", "crystal.ttf"), r.pick("Qu8", "aGe", "Box", "&%")
    return r.pick(f'text {{ ttf "{font}" "{word}" {r.num(.2, .5)}, 0 translate <-.7, -.3, 0> }}',
                  f'object {{ Bevelled_Text("{font}", "{word}", {r.whole(2, 6)}, {r.num(25, 50)}, .03, .4, 0, {r.pick("yes", "no")}) translate <-.7, -.3, 0> }}',
                  f'object {{ Circle_Text("{font}", "{word * 2}", .4, {r.num(0, .1)}, .2, .8, {r.pick("no", "yes")}, {r.pick("Align_Left", "Align_Right", "Align_Center")}, {r.num(0, 270)}) }}',
                  f'object {{ text {{ ttf "{font}" "{word}" .3, 0 }} translate -Text_Width("{font}", "{word}", 1, 0)/2*x }}')


def place(r):
    turn = r.pick("", "", f"transform {{ Axis_Rotate_Trans({r.vec(.1, 1)}, {r.num(-180, 180)}) }}", f"transform {{ Shear_Trans(<1, {r.num(-.3, .3)}, 0>, y, <0, {r.num(-.3, .3)}, 1>) }}",
                  f"transform {{ Axial_Scale_Trans({r.vec(.1, 1)}, {r.num(.5, 1.5)}) }}", f"transform {{ Reorient_Trans(y, {r.vec(.1, 1)}) }}",
                  f"transform {{ Point_At_Trans({r.vec(.1, 1)}) }}", f"transform {{ Rotate_Around_Trans({r.vec(-90, 90)}, {r.vec(-.2, .2)}) }}",
                  f"rotate {r.vec(-180, 180)}")
    return lines(turn, f"translate {r.box((-1.6, 1.6), (-.4, .7), (-1.6, 1.6))}")
