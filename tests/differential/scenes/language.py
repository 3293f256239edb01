"""Programs in the scene language that print what they find: declarations, loops, macros, arrays, strings, functions, splines."""
from rng import lines
from words.common import HEADER
from words.expressions import Names, condition, number, text, vector
from words.patterns import NOISE
from words.procedures import file, recursion, strings, vectors

STAGE = """camera { location -5*z look_at 0 }
light_source { -9*z, 1 }
sphere { 0, 1 pigment { rgb 1 } }"""


def scene(r):
    names = Names()
    out = [HEADER, NOISE]
    for step in range(r.whole(5, 12)):
        out.append(statement(r, names, step, 2))
    out.append('#debug "end\\n"')  # POV-Ray does not write a line that is not ended
    return lines(*out, STAGE)


def show(r, names):
    return r.made(lambda: f'#debug concat(str({number(r, names)}, 0, {r.whole(2, 7)}), "\\n")',
                  lambda: f'#debug concat(vstr(3, {vector(r, names)}, ", ", 0, {r.whole(2, 6)}), "\\n")',
                  lambda: f'#debug concat({text(r, names)}, "|\\n")',
                  lambda: f'#if {condition(r, names)} #debug "yes\\n" #else #debug "no\\n" #end')


def statement(r, names, step, depth):
    """One statement; what it declares is known to all later ones of the same program."""
    kind = r.whole(0, 21)
    if kind < 3:
        return declare(r, names, step)
    if kind < 7 or depth == 0:
        return show(r, names)
    inner = lambda: lines(*(show(r, names) if r.chance(.6) else nested(r, names, step, depth) for _ in range(r.whole(1, 2))))
    name = f"N{step}_{depth}"
    if kind == 7:
        body = lines(f"#for ({name}, {r.whole(-2, 3)}, {r.whole(2, 5)}" + r.some(.5, f", {r.pick('1', '2', '.5', '.7')}") + ")",
                     inner_with(r, names, name, inner), r.some(.2, f"#if ({name} > {r.whole(1, 4)}) #break #end"), "#end")
        return body
    if kind == 8:
        return lines(f"#declare {name} = {r.whole(0, 3)};", f"#while ({name} < {r.whole(3, 6)})", inner_with(r, names, name, inner),
                     f"#declare {name} = {name} + {r.pick('1', '.8', '2')};", "#end")
    if kind == 9:
        return lines(f"#if {condition(r, names)}", inner(), r.some(.5, f"#elseif {condition(r, names)}\n" + inner()), r.some(.6, "#else\n" + inner()), "#end")
    if kind == 10:
        return lines(f"#switch (int({number(r, names, 1)}))", f"#case ({r.whole(-3, 3)})", inner(), r.some(.7, "#break"), f"#range ({r.whole(-5, 0)}, {r.whole(1, 6)})", inner(),
                     r.some(.8, "#break"), r.some(.7, "#else\n" + inner()), "#end")
    if kind == 11:
        return macro(r, names, name)
    if kind == 12:
        return array(r, names, name)
    if kind == 13 and depth == 2:  # a function may be declared once
        return function(r, names, name)
    if kind == 14:
        return spline(r, name)
    if kind == 15:
        return lines(f"#declare {name} = seed({r.whole(0, 99999)});", *(f'#debug concat(str(rand({name}), 0, 8), "\\n")' for _ in range(r.whole(1, 4))))
    if kind == 16:
        return objects(r, name)
    if kind == 18 and depth == 2:
        return file(r, names, name)
    if kind == 19:
        return strings(r, names, name)
    if kind == 20 and depth == 2:
        return recursion(r, name)
    if kind == 21:
        return vectors(r, names, name)
    return lines(f"#ifdef ({name}) #debug \"there\\n\" #else #declare {name} = {number(r, names)}; #end", f"#ifndef ({name}) #debug \"not there\\n\" #end",
                 f'#debug concat(str({name}, 0, 5), "\\n")', f"#undef {name}", f"#debug concat(str(defined({name}), 0, 0), \"\\n\")")


def nested(r, names, step, depth):
    """A statement inside of another: what it declares is forgotten, for it may not be executed."""
    kept = [list(group) for group in vars(names).values()]
    made = statement(r, names, f"{step}{r.whole(100, 999)}", depth - 1)
    for group, was in zip(vars(names).values(), kept):
        group[:] = was
    return made


def inner_with(r, names, name, inner):
    names.floats.append(name)
    made = inner()
    names.floats.remove(name)
    return made


def declare(r, names, step):
    kind, word, name = r.whole(0, 5), r.pick("#declare", "#local"), f"V{step}"
    if kind < 2:
        made, group = f"{number(r, names)};", names.floats
    elif kind == 2:
        made, group = f"{vector(r, names)};", names.vectors
    elif kind == 3:
        made, group = text(r, names), names.strings
    elif kind == 4:
        made, group = r.pick(f"rgb {r.vec(0, 1)};", f"rgbf <{r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}, {r.num(0, 1)}>;", f"color red {r.num(0, 1)} blue {r.num(0, 1)};",
                             f"rgbft <{r.num(0, 1)}, .5, {r.num(0, 1)}, .25, {r.num(0, 1)}>;", f"rgb {r.vec(0, 1)} * {r.num(0, 2)};"), names.colors
    else:
        if not names.floats:
            return show(r, names)
        again = r.pick(*names.floats)
        return "" if again.startswith("N") else f"#declare {again} = {again} {r.pick('+', '*', '-')} {number(r, names, 1)};"
    made = f"{word} {name} = {made}"
    group.append(name)
    return made


def macro(r, names, name):
    """A macro with parameters that prints, changes one of them, or gives a value."""
    parameters = [f"P{i}" for i in range(r.whole(0, 3))]
    names.floats += parameters
    body = lines(*(show(r, names) for _ in range(r.whole(1, 2))))
    local = f"#local L = {number(r, names, 1)};"
    value = number(r, names, 2)
    for parameter in parameters:
        names.floats.remove(parameter)
    arguments = ", ".join(number(r, names, 2) for _ in parameters)
    gives = r.chance(.5)
    changed = r.some(.4, f"#declare {parameters[0]} = {parameters[0]} + 1;") if parameters and not gives else ""
    head = lines(f"#macro {name}({', '.join(parameters)})", local, body if not gives else "", changed, f"({value} + L)" if gives else "", "#end")
    if gives:
        return lines(head, f'#debug concat(str({name}({arguments}), 0, 5), "\\n")')
    if changed:
        others = ", ".join([f"{name}_a"] + [number(r, names, 1) for _ in parameters[1:]])
        return lines(head, f"#declare {name}_a = {number(r, names, 1)};", f"{name}({others})", f'#debug concat(str({name}_a, 0, 5), "\\n")')
    return lines(head, f"{name}({arguments})", r.some(.3, f"{name}({arguments})"))


def array(r, names, name):
    size = r.whole(1, 5)
    if r.chance(.3):
        columns = r.whole(1, 3)
        rows = ", ".join("{" + ", ".join(number(r, names, 1) for _ in range(columns)) + "}" for _ in range(size))
        return lines(f"#declare {name} = array[{size}][{columns}] {{ {rows} }}",
                     f'#debug concat(str(dimensions({name}), 0, 0), " ", str(dimension_size({name}, 2), 0, 0), " ", str({name}[{r.whole(0, size - 1)}][{r.whole(0, columns - 1)}], 0, 5), "\\n")')
    made = f"#declare {name} = array[{size}]" + " {" + ", ".join(number(r, names, 2) for _ in range(size)) + "}"
    names.arrays.append((name, size))
    return lines(made, r.some(.4, f"#declare {name}[{r.whole(0, size - 1)}] = {number(r, names, 1)};"),
                 f'#for (I, 0, dimension_size({name}, 1) - 1) #debug concat(str({name}[I], 0, 4), " ") #end #debug "\\n"')


def function(r, names, name):
    count = r.whole(1, 3)
    known = Names()
    parameters = [f"{letter}" for letter in "xyz"[:count]] if r.chance(.4) else [f"A{i}" for i in range(count)]
    inner = formula(r, parameters, 3)
    head = "" if parameters[0] == "x" and count == 3 and r.chance(.5) else f"({', '.join(parameters)})"
    names.functions.append((name, count))
    return lines(f"#declare {name} = function{head} {{ {inner} }}",
                 f'#debug concat(str({name}({", ".join(number(r, known, 1) for _ in range(count))}), 0, 6), "\\n")')


def formula(r, parameters, depth):
    """What may stand in a function: floats alone."""
    if depth == 0:
        return r.pick(*parameters, r.num(-3, 3))
    f = lambda: formula(r, parameters, depth - 1)
    return r.made(lambda: f"({f()} {r.pick('+', '-', '*')} {f()})", lambda: f"({f()} / (abs({f()}) + 1))",
                  lambda: f"{r.pick('sin', 'cos', 'abs', 'floor', 'ceil', 'atan', 'tanh', 'int')}({f()})", lambda: f"sqrt(abs({f()}))",
                  lambda: f"{r.pick('min', 'max')}({f()}, {f()})", lambda: f"select({f()}, {f()}, {r.num(-2, 2)})",
                  lambda: f"select({f()}, {f()}, {r.num(-2, 2)}, {r.num(-2, 2)})", lambda: f"pow(abs({f()}) + .1, sin({f()}))",
                  lambda: f"mod({f()}, abs({f()}) + 1)", lambda: f"({f()} {r.pick('<', '>', '<=', ' >=')} {f()})", lambda: f"(-({f()}))",
                  lambda: f"f_noise3d({f()}, {f()}, {r.num(-2, 2)})", lambda: f"sum(I{depth}, 1, {r.whole(2, 4)}, I{depth} * {f()})",
                  lambda: f"prod(I{depth}, 1, {r.whole(2, 3)}, I{depth} + {f()} * .1)", lambda: f"atan2({f()}, abs({f()}) + 7)")


def spline(r, name):
    times, at = [], r.real(-1, 0)
    for _ in range(r.whole(4, 6)):
        times.append(at)
        at = round(at + r.real(.2, 1), 3)
    vectors = r.chance(.6)
    points = ", ".join(f"{t:g}, {r.vec(-3, 3) if vectors else r.num(-3, 3)}" for t in times)
    shown = [f'#debug concat(vstr(3, {name}({r.num(-1.5, 4)}), ", ", 0, 5), "\\n")' if vectors else f'#debug concat(str({name}({r.num(-1.5, 4)}).x, 0, 5), "\\n")' for _ in range(3)]
    return lines(f"#declare {name} = spline {{ {r.pick('linear_spline', 'quadratic_spline', 'cubic_spline', 'natural_spline', '')} {points} }}", *shown)


def objects(r, name):
    """What the language asks of a solid."""
    solid = r.pick(f"sphere {{ {r.vec(-1, 1)}, {r.num(.5, 2)} }}", f"box {{ {r.vec(-2, -.5)}, {r.vec(.5, 2)} }}", f"cylinder {{ {r.vec(-2, -1)}, {r.vec(1, 2)}, {r.num(.4, 1)} }}",
                   f"torus {{ {r.num(1, 2)}, {r.num(.2, .8)} rotate {r.vec(-90, 90)} }}", f"difference {{ box {{ -1, 1 }} sphere {{ {r.vec(-1, 1)}, {r.num(.5, 1)} }} rotate {r.vec(-90, 90)} }}",
                   f"union {{ sphere {{ x, {r.num(.5, 1)} }} cone {{ -y, {r.num(.5, 1)}, y, {r.num(0, .4)} }} translate {r.vec(-1, 1)} }}")
    return lines(f"#declare {name} = {solid}", f"#declare {name}_n = <0, 0, 0>;", f"#declare {name}_p = trace({name}, {r.vec(-4, -3)}, {r.vec(.6, 1.4)}, {name}_n);",
                 f'#debug concat(vstr(3, {name}_p, ", ", 0, 4), " ", vstr(3, {name}_n, ", ", 0, 4), "\\n")', f'#debug concat(str(inside({name}, {r.vec(-1.5, 1.5)}), 0, 0), "\\n")',
                 f'#debug concat(vstr(3, min_extent({name}), ", ", 0, 4), " ", vstr(3, max_extent({name}), ", ", 0, 4), "\\n")')
