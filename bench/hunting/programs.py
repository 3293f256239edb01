"""Scenes whose time goes into reading: loops, macros, arrays, strings, functions, splines, and trace() and inside() of objects."""
from rng import lines
from words import common
from words.expressions import Names, condition, number, text, vector

from hunting.sizes import drawn, loop


def named(r):
    """(Names that expressions may use, the text that declares them)."""
    names = Names()
    names.floats, names.vectors = ["I", "F"], ["V"]
    return names, f"#declare F = {r.num(-2, 2)}; #declare V = {r.vec(-1, 1)};"


def sums(r):
    names, declared = named(r)
    body = lines(*(f"#declare T{at} = {number(r, names, r.whole(2, 4))};" for at in range(r.whole(1, 4))), f"#declare V = vnormalize({vector(r, names, 2)} + <.1, .2, 9>);")
    return lines(declared, loop(r.amount(300, 40000), body))


def choices(r):
    names, declared = named(r)
    return lines(declared, loop(r.amount(300, 30000), f"#if {condition(r, names)} #declare F = {number(r, names, 2)}; #elseif {condition(r, names)} #declare F = 1; #else #switch (mod(I, 5)) #case (1) #declare F = 2; #break #range (2, 3) #declare F = I/1e6; #break #else #declare F = 0; #end #end"))


def recursions(r):
    deep = r.whole(8, 15)
    names, _ = named(r)
    names.floats, names.vectors = ["A", "Level"], ["B"]
    return lines(f"#macro Grow(A, B, Level) #if (Level > 0) #local C = {number(r, names, 2)}; Grow(C/2, B*.7 + y*.1, Level - 1) Grow(A*.5, B*.6 - x*.1, Level - 1) {r.some(.4, '#else sphere { B, .02 pigment { rgb 1 } }')} #end #end", f"Grow(1, <1, 1, 1>, {deep})")


def tables(r):
    n = r.amount(10, 200)
    names, declared = named(r)
    return lines(declared, f"#declare Table = array[{n}][{n}];", f"#for (J, 0, {n - 1}) #for (I, 0, {n - 1}) #declare Table[J][I] = {number(r, names, 2)}; #end #end",
                 f"#declare Total = 0; #for (J, 1, {n - 2}) #for (I, 1, {n - 2}) #declare Total = Total + abs(Table[J][I])*.001 + sin(Table[J-1][I+1]) - Table[J+1][I-1]*.01; #end #end")


def words(r):
    names, _ = named(r)
    names.strings = ["W"]
    return lines('#declare W = ""; #declare F = 1; #declare V = x;', loop(r.amount(200, 6000), f"#declare W = concat({text(r, names, 2)}, chr(65 + mod(I, 26))); #if (strlen(W) > 400) #declare W = substr(W, 5, 20); #end #declare K = asc(W) + strlen(strupr(W));"))


def asked(r):
    """An object that is asked while the scene is read, by trace(), inside() or its extents."""
    word, body = common.solid(r, 1)
    count = r.amount(2, 800)
    solid = r.pick(f"{word} {{ {body} }}", f"union {{ {loop(count, f'{word} {{ {body} scale .1 translate <{drawn(-1, 1)}, {drawn(-1, 1)}, {drawn(-1, 1)}> }}', 'K')} }}",
                   f"difference {{ box {{ -1, 1 }} {loop(count, f'{word} {{ {body} scale .1 translate <{drawn(-1, 1)}, {drawn(-1, 1)}, {drawn(-1, 1)}> }}', 'K')} }}", "height_field { function 60, 60 { pattern { bozo scale .2 } } translate -.5 scale 2 }",
                   "isosurface { function { x*x + y*y + z*z - .6 + .1*sin(9*x) } contained_by { box { -1, 1 } } max_gradient 4 }", "blob { threshold .5 sphere { 0, 1, 1 } sphere { .5*x, 1, 1 } }")
    use = r.pick("#declare N = <0, 0, 0>; #declare P = trace(Asked, 3*vnormalize(R), -R + .3*<rand(S), rand(S), rand(S)>, N); #if (vlength(N) > 0) sphere { P, .02 pigment { rgb 1 } } #end",
                 "#if (inside(Asked, R)) sphere { R, .02 pigment { rgb 1 } } #end", "#declare Q = (max_extent(Asked) - min_extent(Asked))*R;")
    return lines(f"#declare Asked = {solid}", loop(r.amount(200, 20000), f"#declare R = <{drawn(-1, 1)}, {drawn(-1, 1)}, {drawn(-1, 1)}>; {use}"))


def sampled(r):
    """Functions, pigments and splines that are evaluated while the scene is read."""
    function = r.pick("function { pigment { granite turbulence .3 color_map { [0 rgb 0] [1 rgb <1, .5, .2>] } } }", "function { pattern { crackle turbulence .2 } }", "function { sin(x*9)*cos(y*7) + pow(abs(z), 1.7) }",
                      "function { f_noise3d(x*3, y*3, z*3)*.5 + select(x, y, z)*.1 }")
    call = r.pick("F0(A, B, C).x", "F0(A, B, C).gray") if "pigment" in function else "F0(A, B, C)"
    spline = "#declare Way = spline { natural_spline " + ", ".join(f"{at}, {r.vec(-1, 1)}" for at in range(r.amount(4, 200))) + " }"
    return lines("#declare f_noise3d = function { internal(76) }", f"#declare F0 = {function}", spline,
                 loop(r.amount(300, 20000), f"#declare A = rand(S); #declare B = rand(S); #declare C = A*B; #declare H = {call}; #declare Q = Way(A*4) + vrotate(x, <H, A, B>)*vturbulence(2, .5, 4, <A, B, C>);"))


PROGRAMS = {made.__name__: made for made in (sums, choices, recursions, tables, words, asked, sampled)}
