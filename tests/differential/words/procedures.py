"""Pieces of programs: files written and read, texts built in loops, macros that call themselves, vectors of any size."""
from rng import lines
from words.expressions import number, text, vector

ONE = '"one item "'
NEWLINE = '"\\n"'


def file(r, names, name):
    """What is written is read again, to the end."""
    path = f'"language_{r.whole(0, 999999)}.txt"'
    written = [r.made(lambda: number(r, names, 1), lambda: vector(r, names, 1), lambda: '"\\"word\\""') for _ in range(r.whole(1, 3))]
    return lines(f"#fopen {name} {path} write", f"#write ({name}, " + ', ", ", '.join(written) + f", {NEWLINE})", f"#fclose {name}",
                 f"#fopen {name} {path} read", f"#while (defined({name}))", f"  #read ({name}, {name}_item)",
                 f"  #ifdef ({name}_item) #debug {r.pick(NEWLINE, ONE)} #end", "#end")


def strings(r, names, name):
    """A text that grows in a loop, taken apart again."""
    grown = f"#declare {name} = concat({name}, {text(r, names, 1)}, chr({r.whole(65, 80)} + I))"
    return lines(f"#declare {name} = {text(r, names, 1)}", f"#for (I, 1, {r.whole(1, 4)})", "  " + grown, "#end",
                 f'#debug concat(str(strlen({name}), 0, 0), " ", {r.pick("strupr", "strlwr")}({name}), {NEWLINE})',
                 f'#for (I, 1, min(strlen({name}), 6)) #debug concat(str(asc(substr({name}, I, 1)), 0, 0), " ") #end #debug {NEWLINE}',
                 f"#debug concat(str(strcmp({name}, {text(r, names, 1)}), 0, 0), {NEWLINE})")


def recursion(r, name):
    """A macro that calls itself, and one that makes a text of an array."""
    between, none = r.pick('"-"', '" "', '"::"'), '""'
    return lines(f"#macro {name}(K)", f"  #if (K > 0) (K {r.pick('+', '*', '-')} {name}(K - 1)) #else {r.whole(1, 3)} #end", "#end",
                 f"#debug concat(str({name}({r.whole(0, 6)}), 0, 3), {NEWLINE})",
                 f"#macro {name}_text(A, K)", f"  #local R = {none};", f"  #for (I, 0, K) #local R = concat(R, str(A[I], 0, 2), {between}); #end", "  R", "#end",
                 f"#declare {name}_list = array[3] {{ {r.num(-9, 9)}, {r.num(-9, 9)}, {r.num(-9, 9)} }}",
                 f"#debug concat({name}_text({name}_list, {r.whole(0, 2)}), {NEWLINE})")


def vectors(r, names, name):
    """Vectors of two, three and four components, and arrays of them."""
    count = r.whole(2, 4)
    parts = lambda: "<" + ", ".join(number(r, names, 1) for _ in range(count)) + ">"
    return lines(f"#declare {name} = {parts()};", f"#declare {name}_b = {parts()} {r.pick('+', '-', '*')} {name};",
                 f"#declare {name}_c = array[2] {{ {name}, {name}_b }}",
                 f'#debug concat(vstr({count}, {name}_b, ", ", 0, 4), " ", vstr({count}, {name}_c[{r.whole(0, 1)}], ", ", 0, 4), {NEWLINE})',
                 f"#debug concat(str({name}_b.{r.pick('x', 'y', 'u', 'v')}, 0, 4), {NEWLINE})")
