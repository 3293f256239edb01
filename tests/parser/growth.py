#!/usr/bin/env python3
"""Whether four times as much of anything takes about four times as long to read and to plan.

usage: growth.py WHITTLE [KIND...]

Counts instructions by callgrind (Debian package valgrind), which has no noise: of a scene without the thing, with n and with 4n of it, drawn in
4 by 3 pixels. What the thing adds may grow by 5.2, which leaves room for sorting and hierarchies (n log n) and none for anything quadratic.
Exit status 77 (skipped) without valgrind.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

HEAD = "#version 3.7; global_settings { assumed_gamma 1 }\n"
MOST = 5.2


def joined(n, item):
    return "\n".join(item(i) for i in range(n))


def circle(i, n, form):
    return form.format(x=f"cos({i}*2*pi/{n})*5", y=f"sin({i}*2*pi/{n})*5")


def blob(n):
    return "blob { threshold 0.5\n" + joined(n, lambda i: f"cylinder {{ <{i},0,0>, <{i},1,0>, 0.4, 1 pigment {{ rgb <{i % 7}/7,1,0> }} }}") + "}"


def prism(n):
    return f"prism {{ linear_spline 0, 1, {n + 1}\n" + ",".join(circle(i % n, n, "<{x},{y}>") for i in range(n + 1)) + "}"


def lathe(n):
    return f"lathe {{ linear_spline {n}\n" + ",".join(f"<{1 + i % 3}, {i}>" for i in range(n)) + "}"


def sor(n):
    return f"sor {{ {n}\n" + ",".join(f"<{1 + 0.1 * (i % 3)}, {i}>" for i in range(n)) + "}"


def polygon(n):
    return f"polygon {{ {n + 1}\n" + ",".join(circle(i % n, n, "<{x},{y}>") for i in range(n + 1)) + "}"


def sphere_sweep(n):
    return f"sphere_sweep {{ linear_spline {n}\n" + ",".join(f"<{i}, {i % 2}, 0>, 0.3" for i in range(n)) + "}"


def operands(n):
    return "union {" + joined(n, lambda i: f"sphere {{ <{i},0,0>, 0.4 }}") + "}"


def cut(n):
    return "difference { box { <-1,-1,-1>, <1e6,1,1> }" + joined(n, lambda i: f"sphere {{ <{i},1,0>, 0.4 }}") + "}"


def statements(n):
    return joined(n, lambda i: f"box {{ <{i},0,0>, <{i + 0.5},1,1> pigment {{ rgb <1,{i % 9}/9,0> }} }}")


def moved(n):
    return ("#declare P = texture { pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } } }\n" +
            joined(n, lambda i: f"object {{ sphere {{ 0, 0.4 texture {{ P }} }} rotate y*{i} translate <{i},0,0> }}"))


def shared(n):
    return ("#declare P = texture { pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } } }\n" +
            joined(n, lambda i: f"union {{ sphere {{ 0, 0.4 }} sphere {{ 1, 0.4 }} texture {{ P }} translate <{i},0,0> }}"))


def copies(n):
    return ("#declare Big = union {" + joined(50, lambda i: f"sphere {{ <{i},0,0>, 0.4 }}") + "}\n" +
            joined(n, lambda i: f"#declare B{i} = object {{ Big translate y*{i} }}") + "object { B1 }")


def chain(n):
    return ("#declare A = box { 0, 1 }\n" + joined(n, lambda i: f"#declare A = difference {{ object {{ A }} sphere {{ {i / n}, 0.01 }} }}") +
            "#declare B = A; sphere { 0, 1 }")


def groups(n):
    return joined(n, lambda i: f"light_group {{ sphere {{ <{i},0,0>, 0.3 }} light_source {{ <{i},2,0>, rgb 0.1 }} }}")


def color_map(n):
    return "sphere { 0, 1 pigment { gradient x color_map {" + joined(n, lambda i: f"[{i}/{n} rgb {i % 2}]") + "} } }"


def mesh2(n):
    points = ",".join(f"<{i},{i % 2},0>" for i in range(n))
    faces = ",".join(f"<{i},{i + 1},{i + 2}>" for i in range(n - 2))
    return f"mesh2 {{ vertex_vectors {{ {n}, {points} }} face_indices {{ {n - 2}, {faces} }} }}"


def triangles(n):
    return "mesh {" + joined(n, lambda i: f"triangle {{ <{i},0,0>, <{i},1,0>, <{i},0,1> pigment {{ rgb 1 }} }}".replace("pigment { rgb 1 }", "")) + "}"


def textured_triangles(n):
    return "mesh {" + joined(n, lambda i: f"triangle {{ <{i},0,0>, <{i},1,0>, <{i},0,1> texture {{ pigment {{ rgb {i % 5}/5 }} }} }}") + "}"


def spline(n):
    return "#declare S = spline { natural_spline " + ",".join(f"{i}, <{i % 3},1,0>" for i in range(n)) + " }\n" + "sphere { S(1.5), 1 }"


def asked_spline(n):
    return (f"#declare S = spline {{ natural_spline {', '.join(f'{i}, <{i % 3},1,0>' for i in range(n))} }}\n#declare V = 0;"
            f"#for (I, 0, {n}) #declare V = V + S(I + 0.5); #end sphere {{ V, 1 }}")


def texts(n):
    return joined(n, lambda i: f'text {{ ttf "timrom.ttf", "Sign {i}", 0.1, 0 translate y*{i} }}')


def names(n):
    return joined(n, lambda i: f"#declare Name{i} = <{i},1,2>;") + f"sphere {{ Name{n - 1}, 1 }}"


def includes(n, folder):
    for i in range(n):
        (folder / f"part_{i}.inc").write_text(f"#declare Part{i} = {i};\n")
    return joined(n, lambda i: f'#include "part_{i}.inc"') + "sphere { 0, 1 }"


def lights(n):
    return "sphere { 0, 1 }" + joined(n, lambda i: f"light_source {{ <{i},5,0>, rgb 0.01 }}")


def clips(n):
    return "sphere { 0, 1 clipped_by {" + joined(n, lambda i: f"box {{ -{i + 2}, {i + 2} }}") + "} }"


def arrays(n):
    return f"#declare A = array[{n}] {{" + ",".join(str(i) for i in range(n)) + "}\n" + f"#declare B = A; #declare B[1] = A[2]; sphere {{ B[1], 1 }}"


def own_textures(n):
    return joined(n, lambda i: f"sphere {{ <{i},0,0>, 0.4 texture {{ pigment {{ bozo color_map {{ [0 rgb 0] [1 rgb {i}/{n}] }} scale {i + 1} }} "
                               f"normal {{ bumps 0.{i} }} finish {{ phong 0.{i} }} }} }}")


def layers(n):
    return "sphere { 0, 1" + joined(n, lambda i: f"texture {{ pigment {{ bozo color_map {{ [0 rgbt 1] [1 rgbt <{i}/{n},1,1,0.5>] }} scale {i + 1} }} }}") + "}"


def texture_map(n):
    return ("sphere { 0, 1 texture { gradient y texture_map {" +
            joined(n, lambda i: f"[{i}/{n} pigment {{ bozo scale {i + 1} }} finish {{ phong {i}/{n} }}]") + "} } }")


def nested_pigments(n):
    return (joined(n, lambda i: f"#declare P{i} = pigment {{ bozo pigment_map {{ [0 {f'P{i - 1}' if i else 'rgb 0'}] [1 rgb {i}/{n}] }} }}") +
            f"sphere {{ 0, 1 pigment {{ P{n - 1} }} }}")


def placed(n):
    return ("#declare U = union { sphere { 0, 0.3 pigment { bozo } } box { 0, 0.3 texture { pigment { granite } finish { phong 1 } } } }\n" +
            joined(n, lambda i: f"object {{ U rotate y*{i} translate <{i},0,0> }}"))


def placed_nests(n):
    return ("#declare P = pigment { gradient x pigment_map {" + joined(64, lambda k: f"[{k}/64 bozo scale {k + 1}]") + "} }\n" +
            joined(n, lambda i: f"sphere {{ 0, 0.4 pigment {{ P }} rotate y*{i} translate <{i},0,0> }}"))


def warps(n):
    return "sphere { 0, 1 pigment { bozo" + joined(n, lambda i: f" warp {{ repeat x*{i + 2} }} scale 1.01") + " } }"


def media(n):
    return "sphere { 0, 1 hollow pigment { rgbt 1 } interior {" + joined(n, lambda i: f"media {{ emission {i}/{n} density {{ bozo scale {i + 1} }} }}") + "} }"


def interiors(n):
    return joined(n, lambda i: f"sphere {{ <{i},0,0>, 0.4 hollow pigment {{ rgbt 1 }} interior {{ ior 1.{i} media {{ emission {i}/{n} density {{ bozo }} }} }} }}")


KINDS = {  # how many make it dear enough to be counted
    blob: 2500, prism: 1000, lathe: 400, sor: 400, polygon: 1000, sphere_sweep: 400, operands: 1000, cut: 100, statements: 500, moved: 1200,
    shared: 300, copies: 1000, chain: 1000, groups: 60, color_map: 60, mesh2: 2000, triangles: 1000, textured_triangles: 300, spline: 1000,
    asked_spline: 1000, texts: 60, names: 2000, includes: 60, lights: 60, clips: 60, arrays: 5000,
    own_textures: 300, layers: 300, texture_map: 60, nested_pigments: 300, placed: 800, placed_nests: 300, warps: 1000, media: 100, interiors: 200}


def instructions(whittle, text):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        body = text(folder) if callable(text) else text
        (folder / "growth.pov").write_text(HEAD + body + "\ncamera { location <0,0,-1e7> look_at 0 }\n")
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", whittle, "+Igrowth.pov", "+Ogrowth.png", "+W4", "+H3", "-A",
                   "-D", "+WT1", "--isa=v2", "--quiet", "+L/usr/share/povray-3.7/include"]
        run = subprocess.run(command, capture_output=True, text=True, cwd=folder)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        sys.exit(f"{' '.join(command)}\n{run.stdout[-1000:]}\n{run.stderr[-2000:]}")
    return int(found[1])


def growth(whittle, kind, base):
    def text(n):
        return (lambda folder: includes(n, folder)) if kind is includes else kind(n)

    few, many = (instructions(whittle, text(KINDS[kind] * factor)) for factor in (1, 4))
    return (many - base) / max(few - base, 1), few - base


def main():
    if shutil.which("valgrind") is None:
        print("needs valgrind")
        sys.exit(77)
    whittle, wanted = sys.argv[1], sys.argv[2:]
    kinds = [kind for kind in KINDS if not wanted or kind.__name__ in wanted]
    base = instructions(whittle, "sphere { 0, 1 }")
    bad = 0
    with ThreadPoolExecutor(2) as pool:
        for kind, (times, few) in zip(kinds, pool.map(lambda kind: growth(whittle, kind, base), kinds)):
            bad += times > MOST
            print(f"{kind.__name__:20} {KINDS[kind]:6} {few / 1e6:9.2f} million instructions, four times as many: x {times:.2f}"
                  f"{'  TOO MUCH' if times > MOST else ''}", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
