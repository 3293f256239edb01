"""Programs with what POV-Ray 3.8 added to the language, among those that there were: dictionaries, arrays that grow or mix types or have
gaps, tuples, optional parameters, scopes by name."""
from rng import lines
from scenes import language
from words.expressions import Names, number, text, vector
from words.patterns import NOISE

HEADER = "#version 3.8;\nglobal_settings { assumed_gamma 1 }"


def scene(r):
    names = Names()
    out = [r.pick(HEADER, HEADER, HEADER.replace("3.8", "3.7")), NOISE]
    for step in range(r.whole(6, 12)):
        out.append(language.statement(r, names, step, 2) if r.chance(.4) else new(r, names, f"W{step}"))
    out.append('#debug "end\\n"')
    return lines(*out, language.STAGE)


def shown(*parts):
    return f'#debug concat({", ".join(parts)}, "\\n")'


def figure(value, digits=4):
    return f"str({value}, 0, {digits})"


def new(r, names, name):
    return r.pick(dictionary, mixed, growing, gaps, tuples, unpacked, optional, scopes, scopes_by_text, words, nested, handed_over)(r, names, name)


def dictionary(r, names, name):
    members = r.few(2, 4, [f".A: {number(r, names, 1)}", f'["B"]: {text(r, names, 1)}', f".C: {vector(r, names, 1)}", f".D: {number(r, names, 1)}"])
    made = f"#declare {name} = dictionary {{ {', '.join(members)} }}"
    first = members[0].strip('[".')[0]
    checks = [f'#ifdef ({name}.{key}) #debug "{key} " #else #debug "no {key} " #end' for key in "ABCDE"]
    after = r.pick(f"#declare {name}.E = {number(r, names, 1)};", f'#declare {name}["E"] = {number(r, names, 1)};', f"#undef {name}.{first}",
                   f"#declare {name}.D = {text(r, names, 1)}", "")
    return lines(made, *checks, '#debug "\\n"', after, *checks, '#debug "\\n"',
                 f"#ifdef ({name}.A)", shown(figure(f"{name}.A"), figure(f'{name}[concat("", "A")]')), "#end", f"#ifdef ({name}.B)", shown(f"{name}.B"), "#end",
                 f"#ifdef ({name}.C)", shown(f'vstr(3, {name}.C, ",", 0, 3)', figure(f"{name}.C.y")), "#end")


def mixed(r, names, name):
    kinds = r.shuffled(["n", "t", "v", "n", "t"])[:r.whole(2, 5)]
    values = [{"n": number, "t": text, "v": vector}[kind](r, names, 1) for kind in kinds]
    made = f"#declare {name} = array mixed {r.some(.5, f'[{len(kinds)}] ')}{{ {', '.join(values)} }}"
    show = [shown({"n": figure(f"{name}[{i}]"), "t": f"{name}[{i}]", "v": f'vstr(3, {name}[{i}], ",", 0, 3)'}[kind]) for i, kind in enumerate(kinds)]
    texts = [i for i, kind in enumerate(kinds) if kind == "t"]
    numbers = [i for i, kind in enumerate(kinds) if kind == "n"]
    more = [f'#debug {name}[{i}] #debug "\\n"' for i in texts[:1]] + [shown(figure(f"{name}[{i - 1}+1]*2 + 1")) for i in numbers[:1]]
    return lines(made, *show, *more, r.some(.3, f"#declare {name}[0] = {text(r, names, 1)} {shown(name + '[0]')}"))


def growing(r, names, name):
    start = r.whole(0, 3)
    made = f"#declare {name} = array" + (f" {{ {', '.join(number(r, names, 1) for _ in range(start))} }}" if start else ";")
    at, grown = start, []
    for _ in range(r.whole(1, 4)):
        at += r.whole(0, 2)
        grown.append(f"#declare {name}[{at}] = {number(r, names, 1)};")
        at += 1
    return lines(made, *grown, shown(figure(f"dimension_size({name}, 1)", 0), figure(f"{name}[{at - 1}]")),
                 f'#for (I, 0, dimension_size({name}, 1) - 1) #ifdef ({name}[I]) #debug concat(str({name}[I], 0, 3), " ") #else #debug "- " #end #end #debug "\\n"')


def gaps(r, names, name):
    parts = [r.some(.6, number(r, names, 1)) for _ in range(r.whole(2, 5))]
    parts[0] = parts[0] or number(r, names, 1)
    parts[-1] = parts[-1] or number(r, names, 1)
    return lines(f"#declare {name} = array[{len(parts)}] optional {{ {', '.join(parts)} }}",
                 f'#for (I, 0, {len(parts) - 1}) #ifdef ({name}[I]) #debug concat(str({name}[I], 0, 3), " ") #else #debug "- " #end #end #debug "\\n"')


def tuples(r, names, name):
    a, b = number(r, names, 1), text(r, names, 1)
    return lines(f"{r.pick('#declare', '#local')} ({name}_a, {name}_b) = ({a}, {b});", shown(figure(name + "_a"), name + "_b"),
                 f"#declare {name}_c = {number(r, names, 1)};", f"#declare ({name}_a, {name}_c) = ({name}_c, {name}_a)" + r.pick(";", ""),
                 shown(figure(name + "_a"), '" "', figure(name + "_c")),
                 r.some(.4, f"#declare (optional {name}_a, {name}_d) = (, {number(r, names, 1)}); {shown(figure(name + '_a'), figure(name + '_d'))}"))


def unpacked(r, names, name):
    values = ", ".join(number(r, names, 1) for _ in range(3))
    made = r.pick(f"array[3] {{ {values} }}", f"array {{ {values} }}")
    return lines(f"#declare {{ {name}_a, {r.pick(f'{name}_b', '')}, {name}_c }} = {made};", shown(figure(name + "_a"), figure(name + "_c")),
                 f'#ifdef ({name}_b) #debug "b\\n" #end')


def optional(r, names, name):
    body = f'#ifdef (local.Q) {shown(figure("P + Q"))} #else {shown(figure("P"), chr(34) + " alone" + chr(34))} #end'
    calls = [f"{name}({number(r, names, 1)}, {r.pick(number(r, names, 1), '', 'Never_declared')})" for _ in range(r.whole(1, 3))]
    through = lines(f"#macro {name}_t(P, optional Q) {name}(P, Q) #end", f"{name}_t(1, {r.pick('2', '')})") if r.chance(.4) else ""
    return lines(r.some(.3, "#declare Q = 77;"), f"#macro {name}(P, optional Q) {body} #end", *calls, through, "#ifdef (Q) #undef Q #end")


def scopes(r, names, name):
    return lines(f"#declare {name} = {number(r, names, 1)};", f"#macro {name}_m()",
                 f"  #ifdef (local.{name}) #debug \"l\" #else #debug \"-\" #end", f"  #local {name} = {number(r, names, 1)};",
                 "  " + shown(figure(name), figure(f"local.{name}"), figure(f"global.{name}")),
                 "  " + r.pick(f"#declare global.{name} = {number(r, names, 1)};", f"#declare local.{name} = 3;", ""),
                 "#end", f"{name}_m()", shown(figure(name)))


def scopes_by_text(r, names, name):
    return lines(f'#declare global["{name}"] = {number(r, names, 1)};', shown(figure(name), figure(f'global[concat("{name[0]}", "{name[1:]}")]')),
                 f'#declare {name}_s = {text(r, names, 1)}', shown(f"global.{name}_s"), f"#debug global.{name}_s #debug \"\\n\"",
                 f'#ifdef (local["{name}_q"]) #debug "y\\n" #else #debug "n\\n" #end')


def words(r, names, name):
    return lines(shown(figure("tau", 6), figure("version", 2)), f"#declare {name} = function(A) {{ A*tau }}", shown(figure(f"{name}({number(r, Names(), 1)})")),
                 f"#declare {name}_c = rgb {r.vec(0, 1)};", shown(figure(f"{name}_c.grey"), figure(f"{name}_c.gray")),
                 "#declare Before = version;", f"#version {r.pick('3.5', '3.7', '3.8')};", shown(figure("version", 2)), "#version Before;")


def nested(r, names, name):
    return lines(f"#declare {name} = dictionary {{ .In: dictionary {{ .X: {number(r, names, 1)} }}, .L: array[2] {{ {number(r, names, 1)}, {number(r, names, 1)} }},"
                 f" .M: array mixed {{ {text(r, names, 1)}, {number(r, names, 1)} }} }}",
                 shown(figure(f"{name}.In.X"), '" "', figure(f"{name}.L[{r.whole(0, 1)}]"), f"{name}.M[0]"),
                 f"#declare {name}.In.X = {name}.In.X + 1;", f"#declare {name}.L[0] = {number(r, names, 1)};", f"#declare {name}_b = {name};",
                 f"#declare {name}_b.In.X = 5;", shown(figure(f"{name}.In.X"), '" "', figure(f"{name}_b.In.X"), '" "', figure(f"{name}.L[0]")))


def handed_over(r, names, name):
    return lines(f"#macro {name}_m(D, V) #declare D.A = {number(r, names, 1)}; #declare V = V + 1; #end", f"#declare {name} = dictionary {{ .A: 1, .B: {number(r, names, 1)} }}",
                 f"{name}_m({name}, {name}.B)", shown(figure(f"{name}.A"), '" "', figure(f"{name}.B")))
