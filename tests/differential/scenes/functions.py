"""Functions of every make (formulas, patterns, pigments, splines, transformations, functions of functions) wherever scenes take one."""
from rng import block, lines
from words import common
from words.patterns import NOISE, modifiers, pattern


class Made:
    """What has been declared: names that are called with a place, with a pigment's colour, and with one number."""

    def __init__(self):
        self.places, self.colors, self.numbers, self.turns = [], [], [], []


def scene(r):
    made = Made()
    parts = [common.HEADER, '#include "functions.inc"' if r.chance(.5) else NOISE, common.camera(r), common.light(r), common.background(r)]
    parts += [r.made(lambda: formula_of(r, made), lambda: formula_of(r, made), lambda: pattern_of(r, made), lambda: pigment_of(r, made), lambda: spline_of(r, made),
                     lambda: transform_of(r, made), lambda: nested_of(r, made)) for _ in range(r.whole(2, 5))]
    parts += [prints(r, made) for _ in range(r.whole(1, 3))]
    parts.append(block("plane", "y, -1.013", "pigment { " + colored(r, made) + " }"))
    parts += [use(r, made) for _ in range(r.whole(1, 2))]
    return lines(*parts)


def name_of(made, listed):
    name = f"F{sum(len(names) for names in (made.places, made.colors, made.numbers, made.turns))}"
    listed.append(name)
    return name


def formula_of(r, made):
    text = value(r, made, 3)
    parameters = "" if r.chance(.6) else "(x, y, z)"
    return f"#declare {name_of(made, made.places)} = function{parameters} {{ {text} }}"


def pattern_of(r, made):
    return f"#declare {name_of(made, made.places)} = " + block("function", block("pattern", pattern_word(r), modifiers(r)))


def pattern_word(r):
    """A pattern that a function can have."""
    word = pattern(r)
    return "onion" if word.startswith(("aoi", "slope", "tiling")) else word.replace("exterior 7", "exterior 5").replace("exterior 8", "exterior 6")


def pigment_of(r, made):
    return f"#declare {name_of(made, made.colors)} = " + block("function", block("pigment", r.pick('bozo', 'granite', 'wood', 'agate', 'gradient y', 'leopard', 'crackle'),
                                                                                     r.some(.7, f"color_map {{ [0 rgbft {colour(r)}] [{r.num(.3, .7)} rgbf {colour(r)}] [1 rgb {r.vec(0, 1)}] }}"), modifiers(r)))


def colour(r):
    return f"<{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, .6)}, {r.num(0, .4)}>"


def spline_of(r, made):
    kind = r.pick("linear_spline", "quadratic_spline", "cubic_spline", "natural_spline")
    points = ", ".join(f"{-1 + .6 * i + r.real(0, .4):.3f}, {r.vec(-1, 1)}" for i in range(r.whole(3, 6)))
    return f"#declare {name_of(made, made.numbers)} = function {{ spline {{ {kind} {points} }} }}"


def transform_of(r, made):
    return f"#declare {name_of(made, made.turns)} = function {{ transform {{ {common.place(r)} }} }}"


def nested_of(r, made):
    inner = value(r, made, 2)
    name = name_of(made, made.places)
    return f"#declare {name}_in = function(a, b) {{ {r.pick('a*sin(b)', 'a*a - b', 'max(a, b)', 'select(a, b, a + b)', 'sqrt(a*a + b*b)', 'mod(abs(a), abs(b) + 1)')} }}\n" \
           f"#declare {name} = function {{ {name}_in({place(r)}, {inner}) }}"


def place(r):
    return r.made(lambda: r.pick("x", "y", "z"), lambda: f"{r.pick('x', 'y', 'z')}*{r.num(-3, 3)}", lambda: f"({r.pick('x', 'y', 'z')} {r.pick('+', '-', '*')} {r.pick('x', 'y', 'z')})",
                  lambda: f"({r.pick('x', 'y', 'z')} + {r.num(-1, 1)})")


def value(r, made, depth=2):
    """A number that depends on x, y and z."""
    if depth == 0:
        return r.made(lambda: place(r), lambda: place(r), lambda: r.num(-2, 2))
    v = lambda: value(r, made, depth - 1)
    p = lambda: place(r)
    options = [lambda: f"({v()} {r.pick('+', '-', '*')} {v()})"] * 3 + [
        lambda: r.pick("sin({})", "cos({})", "abs({})", "exp(-abs({}))", "sqrt(abs({}))", "tanh({})", "atan({})", "floor({})", "ceil({})", "int({})", "ln(abs({}) + .5)", "-{}", "asin(cos({}))").format(v()),
        lambda: r.pick("min({}, {})", "max({}, {})", "atan2({}, abs({}) + 1)", "pow(abs({}), abs({}) + .5)", "mod({}, abs({}) + .3)", "({} > {})", "({} <= {})", "({} & {})").format(v(), v()),
        lambda: f"select({v()}, {v()}, {v()}" + (f", {v()})" if r.chance(.5) else ")"),
        lambda: r.pick("sum(i, 1, {}, i*{})", "prod(i, 1, {}, .5*i + {})").format(r.whole(1, 3), p()),
        lambda: f"f_noise3d({p()}, {p()}, {p()})",
        lambda: f"({v()}/(abs({v()}) + .4))", lambda: f"pow({p()}, {r.whole(1, 3)})"]
    if made.places:
        options += [lambda: f"{r.pick(*made.places)}({p()}, {p()}, {p()})"] * 3
    if made.colors:
        options += [lambda: f"{r.pick(*made.colors)}({p()}, {p()}, {p()}).{r.pick('red', 'green', 'blue', 'gray', 'filter', 'transmit', 'x', 'y')}"] * 2
    if made.numbers:
        options += [lambda: f"{r.pick(*made.numbers)}({p()}).{r.pick('x', 'y', 'z', 'u', 'v')}"]
    if made.turns:
        options += [lambda: f"{r.pick(*made.turns)}({p()}, {p()}, {p()}).{r.pick('x', 'y', 'z')}"]
    return r.made(*options)


def prints(r, made):
    at = lambda: ", ".join(r.num(-3, 3) for _ in range(3))
    options = [lambda: r.num(-1, 1)]
    if made.places:
        options += [lambda: f"{r.pick(*made.places)}({at()})"] * 3
    if made.colors:
        options += [lambda: f"{r.pick(*made.colors)}({at()}).{r.pick('red', 'gray', 'filter', 'transmit')}"]
        return f'#debug concat(vstr(3, {r.pick(*made.colors)}({at()}), " ", 0, 5), "\\n")' if r.chance(.4) else f'#debug concat(str({r.made(*options)}, 0, 5), "\\n")'
    if made.turns and r.chance(.5):
        return f'#debug concat(vstr(3, {r.pick(*made.turns)}({at()}), " ", 0, 5), "\\n")'
    if made.numbers and r.chance(.5):
        return f'#debug concat(vstr(3, {r.pick(*made.numbers)}({r.num(-1, 2)}), " ", 0, 5), "\\n")'
    return f'#debug concat(str({r.made(*options)}, 0, 5), "\\n")'


def colored(r, made):
    maps = f"color_map {{ [0 {r.color()}] [{r.num(.3, .7)} {r.color()}] [1 {r.color()}] }}"
    return lines(f"function {{ {value(r, made, 2)} }}", r.pick("", maps, maps, f"pigment_map {{ [0 {r.color()}] [1 checker scale .2] }}"), r.some(.6, modifiers(r)))


def use(r, made):
    look = lambda: lines("pigment { " + (colored(r, made) if r.chance(.5) else r.color()) + " }", r.some(.4, f"normal {{ function {{ {value(r, made, 2)} }} {r.num(.2, 1)} {r.some(.4, 'scale .4')} }}"), common.finish(r))

    def isosurface():
        base = r.pick("x*x + y*y + z*z - .6", "max(abs(x), max(abs(y), abs(z))) - .7", "sqrt(x*x + z*z) - .5", "y - .2")
        return block("isosurface", f"function {{ {base} + {r.num(.05, .25)}*sin({value(r, made, 2)}) }}", r.pick("contained_by { box { -1, 1 } }", "contained_by { sphere { 0, 1.2 } }"),
                     f"max_gradient {r.pick('6', '12', '25')} accuracy .001", r.some(.3, "open"), r.some(.3, "all_intersections"), look(), common.place(r))

    def field():
        return block("height_field", f"function {r.whole(8, 30)}, {r.whole(8, 30)} {{ .5 + .5*sin({value(r, made, 2)}) }}", r.some(.5, "smooth"), "translate -.5 scale <2, .8, 2>", look(), common.place(r))

    def solid():
        word, body = common.solid(r)
        return block(word, body, look(), common.place(r))

    def density():
        return block("sphere", "0, 1", "pigment { rgbt 1 } hollow", block("interior", block("media", f"emission {r.num(.3, 1.5)} method 3 intervals 1 samples {r.whole(4, 8)}",
                     block("density", f"function {{ abs(sin({value(r, made, 2)})) }}", r.some(.6, f"color_map {{ [0 rgb 0] [1 {r.color()}] }}")))), common.place(r))

    return r.made(isosurface, isosurface, field, solid, solid, density)
