"""Random expressions of the scene language: floats, vectors, strings, conditions. All are finite wherever they are asked."""


class Names:
    """What has been declared so far, by type."""

    def __init__(self):
        self.floats, self.vectors, self.strings, self.colors, self.arrays, self.functions = [], [], [], [], [], []


def number(r, names, depth=3):
    """A float. At depth 0 an operand, which may be a name."""
    if depth <= 0 or r.chance(.2):
        return operand(r, names)
    n = lambda: number(r, names, depth - 1)
    v = lambda: vector(r, names, depth - 1)
    t = lambda: text(r, names, depth - 2)
    return r.made(
        *[lambda: f"({n()} {r.pick('+', '-', '*')} {n()})"] * 5,
        lambda: f"({n()} / (abs({n()}) + {r.num(.5, 2)}))",
        lambda: f"{r.pick('abs', 'sin', 'cos', 'atan', 'floor', 'ceil', 'int', 'degrees', 'radians', 'tanh', 'asinh')}({n()})",
        lambda: r.pick("sqrt(abs({}))", "ln(abs({}) + 1)", "log(abs({}) + 1)", "exp(-abs({}))", "acos(sin({}))", "asin(cos({}))", "sinh(sin({}))",
                       "cosh(sin({}))", "acosh(1 + abs({}))", "atanh(sin({}) * .9)", "tan(sin({}))").format(n()),
        lambda: f"{r.pick('min', 'max')}({n()}, {n()}" + (f", {n()})" if r.chance(.3) else ")"),
        lambda: r.pick("atan2({}, abs({}) + .1)", "mod({}, abs({}) + 1)", "div({}, abs({}) + 1)", "pow(abs({}) + .1, sin({}))").format(n(), n()),
        lambda: f"({condition(r, names, depth - 1)} ? {n()} : {n()})",
        lambda: f"select({n()}, {n()}, {n()}" + (f", {n()})" if r.chance(.5) else ")"),
        lambda: r.made(lambda: f"vdot({v()}, {v()})", lambda: f"vlength({v()})", lambda: f"({v()}).{r.pick('x', 'y', 'z')}"),
        lambda: r.made(lambda: f"strlen({t()})", lambda: f"strcmp({t()}, {t()})", lambda: f"asc({word(r, True)})",
                       lambda: f"val(str({n()}, 0, {r.whole(0, 4)}))"),
        lambda: f"{r.pick('bitwise_and', 'bitwise_or', 'bitwise_xor')}({r.whole(0, 255)}, int(abs({n()})) + 0)",
        lambda: call(r, names, depth),
        lambda: f"-{n()}", lambda: f"!{n()}")


def operand(r, names):
    options = [lambda: r.num(-5, 5), lambda: str(r.whole(-9, 20)), lambda: "pi", lambda: r.pick("on", "off", "true", "no")]
    if names.floats:
        options += [lambda: r.pick(*names.floats)] * 4
    if names.vectors:
        options += [lambda: f"{r.pick(*names.vectors)}.{r.pick('x', 'y', 'z')}"]
    if names.colors:
        options += [lambda: f"{r.pick(*names.colors)}.{r.pick('red', 'green', 'blue', 'gray', 'filter', 'transmit')}"]
    if names.arrays:
        options += [lambda: "{0[0]}[{1}]".format(*(lambda a: (a, r.whole(0, a[1] - 1)))(r.pick(*names.arrays)))] * 2
    return r.made(*options)


def call(r, names, depth):
    """A call of a declared function, a number where there is none."""
    if not names.functions:
        return r.num(-2, 2)
    name, count = r.pick(*names.functions)
    return f"{name}({', '.join(number(r, names, depth - 1) for _ in range(count))})"


def vector(r, names, depth=2):
    if depth <= 0 or r.chance(.3):
        n = lambda: number(r, names, depth - 1)
        return r.made(lambda: r.vec(-4, 4), lambda: r.pick("x", "y", "z"), lambda: f"<{n()}, {n()}, {n()}>", *[lambda name=name: name for name in names.vectors])
    v = lambda: vector(r, names, depth - 1)
    return r.made(lambda: f"({v()} {r.pick('+', '-', '*')} {v()})", lambda: f"({v()} * {number(r, names, depth - 1)})", lambda: f"vcross({v()}, {v()})",
                  lambda: f"vnormalize({v()} + <.1, .2, 20>)", lambda: f"vrotate({v()}, {v()})",
                  lambda: f"vaxis_rotate({v()}, {v()} + <.1, .2, 20>, {r.num(-180, 180)})",
                  lambda: f"vturbulence({r.num(1.5, 3)}, {r.num(.2, .8)}, {r.whole(1, 6)}, {v()})",
                  lambda: f"({v()} / <{r.num(1, 3)}, {r.num(-3, -1)}, {r.num(1, 3)}>)", lambda: f"-{v()}")


def condition(r, names, depth=2):
    n = lambda: number(r, names, depth - 1)
    compare = lambda: f"({n()} {r.pick('<', '>', '<=', ' >=', '=', '!=')} {n()})"
    if depth <= 0:
        return compare()
    return r.made(compare, compare, compare, lambda: f"({condition(r, names, depth - 1)} {r.pick('&', '|')} {condition(r, names, depth - 1)})",
                  lambda: f"({text(r, names, 0)} {r.pick('=', '!=', '<', '>')} {text(r, names, 0)})")


WORDS = ("glass", "Mirror", "a", "zebra", "Blue sky", "42", "x=1", "tab\\there", "quote\\\"d", "")


def word(r, filled=False):
    return f'"{r.pick(*WORDS[:-1 if filled else None])}"'


def text(r, names, depth=2):
    if depth <= 0 or r.chance(.3):
        return r.made(lambda: word(r), lambda: word(r), *[lambda name=name: name for name in names.strings])
    t = lambda: text(r, names, depth - 1)
    return r.made(lambda: f"concat({t()}, {t()}" + (f", {t()})" if r.chance(.4) else ")"), lambda: f"strupr({t()})", lambda: f"strlwr({t()})",
                  lambda: f"str({number(r, names, depth - 1)}, {r.whole(-8, 12)}, {r.whole(-1, 7)})",
                  lambda: f"vstr(3, {vector(r, names, depth - 1)}, {word(r)}, {r.whole(-6, 8)}, {r.whole(0, 6)})",
                  lambda: f"chr({r.whole(33, 126)})", lambda: f"substr({word(r, True)}, 1, 1)")
