#!/usr/bin/env python3
"""Writes expressions.csv: what POV-Ray prints for each expression. Run by hand when an expression is added."""
import csv, pathlib, subprocess, sys, tempfile

FLOATS = """2-2*3+-4;8/4/2;2*-3;2--3;-2*-2;!3;!0;-!0;!!5;(1<2<3);(3>2>1);(1|1&0);(0&0|1);(1=1+1e-11);(1=1+2e-10)
(1<=1-1e-11);(1!=1+1e-11);(0?1:0?2:3);(1?2:3);1/0;-1/0;0/0;5.;.5;1e;2e+;1e3;("a"="a")+1;("abc"<"abd");("b">"a");-y.y
<1,2,3>.y;(x+2*y).y;<1,2,3>.gray;<1,2,3,4>.filter;5.0 .x;int(-2.7);int(1e10);div(7,2);div(-7,2);mod(-7,3);mod(7.5,2)
pow(2,10);pow(0,-1);sqrt(2);ln(10);log(1000);asin(2);acos(-3);atan2(1,-1);degrees(pi);radians(180);abs(1<2);floor(-1.5)
ceil(-1.5);min(3,1,2);max(3,1,2);max(4);select(-1,2,3);select(0,1,2);select(0,1,2,3);select(5,1,2,3);bitwise_and(12,10)
bitwise_or(12,10);bitwise_xor(12,10);vlength(5);vdot(x+y,<2,3,4>);asc("A");strlen("hello");strcmp("a","c");strcmp("ab","a")
val("12.5x");val("0x10");val("none");rand(seed(1));rand(seed(7));rand(seed(-5.7));defined(x);defined(image_width);true+yes+on
exp(1);sinh(1);cosh(1);tanh(1);asinh(1);acosh(2);atanh(0.5);tan(1);pi;(x=x).x;1+2*3-4/5;(1+2)*(3-4)/5;-(-(-3));+-+2;1-1-1"""
VECTORS = """x;y*2;<1,2>;<1,2,3>;<1,2,3,4>;<1,2,3,4,5>;5+<1,2>;<1,2>+5;<1,2>+<1,2,3>;<1,2,3>*<1,2>;x+t;u+v;t;2*<1,2>;<1 -2 3>
<1 2 3>;<1,2,3,>;-<1,2,3>;!<1,0,2>;vrotate(<1,2,3>,<10,20,30>);vaxis_rotate(<1,2,3>,<1,1,0>,30);vcross(x,y);vnormalize(<3,4,0>)
vrotate(5+<1,2>,0);<1,2,3>/<4,5,6>;(<1,5,3>>x);rgb 1;rgb <1,2,3>;rgbf <1,2,3,4>;rgbt <1,2,3,4>;rgbft <1,2,3,4,5>;color 0.5
color red 1 green 0.5;color rgb 0.25 filter 0.5;red 1 blue 2;color x;color <1,2,3> transmit 0.5;rgb 1*0.5;(1?x:y);3"""
STRINGS = """str(2.5,0,0);str(0.05,0,1);str(-3.7,8,2);str(-3.7,-8,2);str(1/3,0,-1);str(1e300,0,2);concat("a",str(1,0,0) "b")
chr(65);substr("abcdef",2,3);strupr("aBc");strlwr("aBc");vstr(3,7,",",0,1);vstr(2,<1,2,3>,"|",5,1)"""

PROLOGUE = "#version 3.7; global_settings{assumed_gamma 1} sphere{0,1}\n"

def observed(kind, text):
    scene = PROLOGUE
    if kind == "float":
        scene += f'#debug concat("[[",str({text},0,9),"]]\\n")\n'
    elif kind == "tuple":
        scene += f'#declare Q={text};\n#debug concat("[[",vstr(5,Q,"|",0,9),"]]\\n")\n'
    else:
        scene += f'#debug concat("[[",{text},"]]\\n")\n'
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "probe.pov")
        path.write_text(scene)
        run = subprocess.run(["povray", f"+I{path}", "-D", "-F", "+W2", "+H2", "-GR", "-GS"], cwd=folder,
                             capture_output=True, text=True)
    said = run.stdout + run.stderr
    return said.split("[[")[1].split("]]")[0].replace("\n", "") if "[[" in said else None

with open(pathlib.Path(__file__).with_name("expressions.csv"), "w", newline="") as out:
    rows = csv.writer(out, delimiter="\t", quoting=csv.QUOTE_NONE, quotechar=None, lineterminator="\n")
    rows.writerow(["kind", "expression", "observed"])
    for kind, block in (("float", FLOATS), ("tuple", VECTORS), ("string", STRINGS)):
        for text in block.replace("\n", ";").split(";"):
            value = observed(kind, text)
            if value is None:
                print("no answer for", text, file=sys.stderr)
            else:
                rows.writerow([kind, text, value])
