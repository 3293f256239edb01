"""Texts without commas that are optional: scenes of other classes, and macros that are called with names that no comma follows."""
from rng import block, lines
from scenes import (cameras, coats, copies, csg, finishes, functions, groups, hollow, language, lights, meshes, modifiers, people, pictures, places, solids, standard, textures,
                    versions)
from words import commas, common

OTHERS = (language, language, language, solids, solids, meshes, meshes, functions, functions, textures, textures, csg, coats, pictures, copies, cameras, finishes, groups, hollow,
          lights, modifiers, people, places, standard, versions)

# Kinds of values: how one is declared, and what a macro shows of its parameter.
KINDS = {
    "float": (lambda r: f"{r.num(-5, 5)};", 'concat(str({0}, 0, 3), "\\n")'),
    "vector": (lambda r: f"{r.vec(-3, 3)};", 'concat(vstr(3, {0}, ", ", 0, 3), "\\n")'),
    "color": (lambda r: f"rgbft <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, .5>;", 'concat(vstr(5, {0}, ", ", 0, 3), "\\n")'),
    "text": (lambda r: f'"t{r.whole(0, 99)}"', 'concat({0}, "\\n")'),
    "function": (lambda r: f"function (a) {{ a * {r.num(1, 3)} + {r.num(0, 2)} }}", 'concat(str({0}(1.5), 0, 3), "\\n")'),
    "spline": (lambda r: f"spline {{ linear_spline 0, {r.vec(-2, 2)}, 1, {r.vec(-2, 2)} }}", 'concat(vstr(3, {0}(.25), ", ", 0, 3), "\\n")'),
    "solid": (lambda r: f"sphere {{ {r.vec(-1, 1)}, {r.num(.2, .5)} }}", 'concat(vstr(3, max_extent({0}), ", ", 0, 3), "\\n")'),
    "list": (lambda r: f"array[3] {{ {r.num(-5, 5)}, {r.num(-5, 5)}, {r.num(-5, 5)} }}", 'concat(str({0}[1], 0, 3), "\\n")'),
    "look": (lambda r: "texture { pigment { " + r.color() + " } " + common.finish(r) + " }", ""),
    "paint": (lambda r: common.pigment(r), ""),
    "shift": (lambda r: f"transform {{ translate {r.vec(-1, 1)} }}", ""),
}
MANY = 3  # names of each kind
GOES_ON = ("float", "vector", "color", "function", "spline")  # what is named may change by the next name


def scene(r):
    if r.chance(.55):
        return commas.without(r, r.pick(*OTHERS).scene(r), r.pick(3, 8, 8, 8, 25))
    kinds = r.few(1, 3, [kind for kind in KINDS if kind != "float"]) + ["float"]
    parts = [common.HEADER, common.camera(r), common.light(r), common.background(r)]
    parts.append(f"#declare Places = seed({r.whole(1, 999)});")
    parts += [f"#declare {name} = {KINDS[kind][0](r)}" for kind in kinds for name in names_of(kind)]
    parts += [f"#declare Cells = array[3] {{ {r.num(-5, 5)}{comma(r)} {r.num(0, 5)}{comma(r)} {r.num(0, 5)} }}", functions_in_array(r, kinds),
              f"#macro Value(A, B) {r.pick('(A * 10 + B)', 'A - B', '#local L = A * 2; (L + B)', 'A', 'B')} #end",
              f"#macro Both(A, B) A{comma(r)} B #end"]
    macros = []
    for at in range(r.whole(1, 3)):
        macros.append((f"Macro{at}", parameters(r, kinds)))
        parts.append(macro(r, *macros[-1], macros[:-1]))
    for _ in range(r.whole(2, 5)):
        made = lines(*(call(r, *r.pick(*macros)) for _ in range(r.whole(1, 2))), r.some(.4, asked(r)))
        parts.append(r.pick(made, made, f"#for (I{comma(r)} 0{comma(r)} {r.whole(2, 4)})\n{made}\n#end",
                            f"#declare K = 0;\n#while (K < {r.whole(3, 5)})\n{made}\n#declare K = K + 1;\n#end"))
        if r.chance(.5):
            parts.append(state(kinds))
    return lines(*parts, state(kinds), common.thing(r))


def comma(r):
    return r.pick(",", "", "")


def names_of(kind):
    return [f"{kind.capitalize()}{at}" for at in range(MANY)]


def parameters(r, kinds):
    """Kinds of a macro's parameters: often alike, so that the next one may stand for one."""
    alike, count = r.pick(*kinds, "float"), r.whole(1, 5)
    return [alike if r.chance(.75) else r.pick(*kinds) for _ in range(count)]


def macro(r, name, kinds, others):
    named = list(zip(kinds, "ABCDE"))
    inner = r.pick(*others) if others and r.chance(.5) else None
    # What it asks for has to be there.
    inner = inner if inner and set(inner[1]) <= set(kinds) else None
    body = [show(*one) for one in named] + [changed(r, *one) for one in named if r.chance(.4)]
    if inner:
        own = {kind: [letter for k, letter in named if k == kind] for kind in kinds}
        body.append(joined(r, inner[0], [(kind, r.pick(*own[kind]), True) for kind in inner[1]]))
    return f"#macro {name}({', '.join(letter for _, letter in named)})\n" + lines(*body, *(show(*one) for one in named if r.chance(.5))) + "\n#end"


def show(kind, name):
    if kind == "look":
        return block("sphere", f"<rand(Places) * 3 - 1.5, rand(Places) * 2 - 1, 0>, .3 texture {{ {name} }}")
    if kind == "paint":
        return block("sphere", f"<rand(Places) * 3 - 1.5, rand(Places) * 2 - 1, 0>, .3 pigment {{ {name} }}")
    if kind == "shift":
        return block("sphere", f"0, .2 pigment {{ rgb x }} transform {{ {name} }}")
    return f"#debug {KINDS[kind][1].format(name)}"


def changed(r, kind, name):
    word = r.pick("#declare", "#local")
    return {"float": f"{word} {name} = {name} + {r.num(.5, 2)};", "vector": f"{word} {name} = {name} * {r.num(.5, 2)};", "color": f"{word} {name} = {name} * .75;",
            "text": f'{word} {name} = concat({name}, "{r.pick("a", "b")}")', "solid": f"{word} {name} = object {{ {name} translate {r.num(.1, .4)} }}",
            "list": f"#declare {name}[{r.whole(0, 2)}] = {r.num(-5, 5)};", "spline": f"{word} {name} = spline {{ {name} 2, {r.vec(-1, 1)} }}"}.get(kind, "")


def argument(r, kind):
    """(kind, text, whether it is a name alone)"""
    name = r.pick(*names_of(kind))
    if r.chance(.65):
        return kind, name, True
    if kind == "float":
        other = r.pick(*names_of(kind))
        return kind, r.pick(f"Cells[{r.whole(0, 2)}]", f"Cells[{r.whole(0, 2)}]", r.num(0, 9), f"({name})", f"{name} * 2", "pi", f"Value({name}{comma(r)} {other})", f"abs({name})", f"-{name}",
                            f"Cells[0 + {r.whole(0, 2)}] + 1"), False
    made = {"vector": f"{name} * 2", "color": f"rgb {r.vec(0, 1)}", "text": f'concat({name}, "+")', "function": name, "spline": name, "list": name}
    return kind, made.get(kind) or KINDS[kind][0](r).rstrip(";"), kind in ("function", "spline", "list")


def joined(r, name, arguments):
    """A call; commas stand between arguments, or not. Seldom not where another kind of name would be taken, or a sign be read as minus."""
    text = f"{name}("
    for at, (kind, made, alone) in enumerate(arguments):
        text += made
        if at + 1 == len(arguments):
            break
        next_kind, next_text, _ = arguments[at + 1]
        if kind == next_kind == "float" and r.chance(.08):
            arguments[at + 1] = ("float", f"Both({made}{comma(r)} {next_text})", False)
            text = text[:-len(made)]
            continue
        other = kind in GOES_ON and next_kind != kind
        called = next_text.startswith(("Value(", "Both("))
        element = kind in ("function", "spline") and next_text.startswith("Cells")
        bound = next_text[0] in "-(" or other or called or element
        text += ("" if r.chance(.03 if bound else .5) else ",") + " "
    return text + r.some(.1, ",") + ")"


def call(r, name, kinds):
    return joined(r, name, [argument(r, kind) for kind in kinds])


def asked(r):
    """A macro's value in an expression."""
    a, b = argument(r, "float"), argument(r, "float")
    return r.pick(f'#debug concat(str({joined(r, "Value", [a, b])}, 0, 3), "\\n")', f"#declare Sum = {joined(r, 'Value', [a, b])} + 1;\n" + '#debug concat(str(Sum, 0, 3), "\\n")')


def functions_in_array(r, kinds):
    """Elements that are functions or splines, without commas."""
    kind = next((kind for kind in kinds if kind in ("function", "spline")), None)
    if not kind:
        return ""
    elements = "".join(f"{name}{comma(r)} " for name in names_of(kind))
    return lines(f"#declare Kept = array[{MANY}] {{ {elements}}}", *(show(kind, f"Kept[{at}]") for at in range(MANY)))


def state(kinds):
    """What all names stand for."""
    return lines(*(show(kind, name) for kind in kinds for name in names_of(kind)), *(show("float", f"Cells[{at}]") for at in range(3)))
