#!/usr/bin/python3
"""How cost grows with the number of primitives: unions, copies of an object, meshes and differences of ten to a million.

usage: bench/large.py [union copies mesh difference] [--most N] [--runs 1] [--threads 1] [--csv FILE] [--whittle CMD] [--povray CMD] [--check]

Makes each scene in a temporary folder, renders it with both programs (--povray '' leaves POV-Ray out) and prints the seconds of
parsing, building (plan) and tracing, bytes a primitive above the smallest scene of its kind, and nanoseconds a pixel. `build`
is the growth of build time over the scene before, divided by that of n log n; `trace` that of the trace time, divided by
that of log n: about 1 or below where cost grows as it should. --check: exit status 1 where one is above 2 (times below
20 ms prove nothing), or a picture is not POV-Ray's.
"""
import argparse
import csv
import math
import pathlib
import re
import sys
import tempfile

from speed import HERE, POVRAY_TRACE, WHITTLE_TRACE, Failure, agreement, rendered, seconds

SIZE = (640, 480)   # fewer pixels and most of 10^5 balls are smaller than one: tiles of rays lose their coherence
NUMBERS = {"union": [10**3, 10**4, 10**5], "copies": [10**3, 10**4, 10**5], "mesh": [10**4, 10**5, 10**6], "difference": [10, 10**2, 10**3]}
WHITTLE_PARSE = re.compile(r"\bparse ([0-9.]+) s\b")
WHITTLE_PLAN = re.compile(r"\bplan ([0-9.]+) s\b")
POVRAY_PARSE = re.compile(r"Parse Time:.*?\(([0-9.]+) seconds\)")
HEAD = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.6, 1.9, -2.6> look_at <0, -0.05, 0> angle 45 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.15, 0.18, 0.22> }
"""
BOUND = 2.0      # of the growth, where it is checked
SHORT = 0.02     # seconds; less proves nothing


def union(n):
    """Balls spread evenly in a cube (a lattice of irrational steps), as large as leaves the picture much the same."""
    return HEAD + f"""union {{
  #for (I, 1, {n})
    sphere {{ <mod(I*0.8191725134, 1), mod(I*0.6710436067, 1), mod(I*0.5497004779, 1)>*2 - 1, {0.75 * n ** (-1 / 3):.6g} }}
  #end
  pigment {{ rgb <0.9, 0.7, 0.4> }}
}}
"""


def copies(n):
    """A declared object of 51 solids, shown n times in a cube."""
    return HEAD + f"""#declare Thing = difference {{
  union {{ #for (I, 0, 48) sphere {{ <sin(I), cos(I), I/24 - 1>, 0.4 }} #end }}
  box {{ -0.5, 0.5 }}
  sphere {{ z, 0.3 }}
  pigment {{ rgb <0.9, 0.6, 0.4> }}
}}
#for (I, 1, {n})
  object {{ Thing rotate 40*I*<1, 2, 3> scale {0.6 / n ** (1 / 3):.6g} translate 2*<mod(I*0.7548776662, 1), mod(I*0.5698402910, 1), mod(I*0.3247179572, 1)> - 1 }}
#end
"""


def mesh(n):
    """Hills on a square grid, about n triangles, as an exporter writes them."""
    side = round(math.sqrt(n / 2))
    points, faces = [], []
    for i in range(side + 1):
        for k in range(side + 1):
            x, z = 2 * i / side - 1, 2 * k / side - 1
            points.append(f"<{x:.6g},{0.2 * math.sin(5 * x) * math.cos(4 * z) + 0.01 * math.sin(40 * x + 3 * math.sin(30 * z)):.6g},{z:.6g}>")
    for i in range(side):
        for k in range(side):
            a = i * (side + 1) + k
            faces.append(f"<{a},{a + 1},{a + side + 1}>,<{a + 1},{a + side + 2},{a + side + 1}>")
    return HEAD + (f"mesh2 {{ vertex_vectors {{ {len(points)},\n" + ",\n".join(points) + f" }}\nface_indices {{ {2 * len(faces)},\n" +
                   ",\n".join(faces) + " }\n  pigment { rgb <0.5, 0.7, 0.4> } }\n")


def difference(n):
    """A block pitted by n - 1 balls, each an operand of its own."""
    return HEAD + f"""difference {{
  box {{ -0.9, 0.9 }}
  #for (I, 1, {n - 1})
    #local Y = 1 - 2*I/{n};
    #local P = <sqrt(1 - Y*Y)*cos(I*2.39996323), Y, sqrt(1 - Y*Y)*sin(I*2.39996323)>;
    sphere {{ 0.9*P/max(abs(P.x), abs(P.y), abs(P.z)), {0.9 / math.sqrt(n):.6g} }}
  #end
  pigment {{ rgb <0.85, 0.75, 0.5> }}
}}
"""


MAKERS = {"union": union, "copies": copies, "mesh": mesh, "difference": difference}


def measure(options, kind, n, folder):
    """One row; the least of the runs."""
    scene = pathlib.Path(folder, f"{kind}_{n}.pov")
    scene.write_text(MAKERS[kind](n))
    row = dict(kind=kind, n=n, parse=math.inf, plan=math.inf, trace=math.inf, memory=math.inf, povray_parse="", povray_trace="", povray_memory="", agree="")
    for _ in range(options.runs):
        said, memory = rendered(options.whittle, scene, SIZE, options.threads, f"{scene}.w.png")
        for name, pattern in (("parse", WHITTLE_PARSE), ("plan", WHITTLE_PLAN), ("trace", WHITTLE_TRACE)):
            row[name] = min(row[name], seconds(said, pattern))
        row["memory"] = min(row["memory"], memory)
    if options.povray:
        said, row["povray_memory"] = rendered(options.povray, scene, SIZE, options.threads, f"{scene}.p.png")
        row["povray_parse"], row["povray_trace"] = seconds(said, POVRAY_PARSE), seconds(said, POVRAY_TRACE)
        row["agree"] = round(agreement(options.whittle, f"{scene}.p.png", f"{scene}.w.png")[0], 4)
    scene.unlink()
    return row


def growth(rows, row):
    """Of build and trace over the row before, against n log n and log n; None where too short to tell."""
    before = rows[-1]
    n, m = row["n"], before["n"]

    def ratio(name, expected):
        return row[name] / max(before[name], SHORT) / expected if row[name] > SHORT else None

    return ratio("plan", n * math.log(n) / (m * math.log(m))), ratio("trace", math.log(n) / math.log(m))


def told(value, form):
    return format(value, form) if value not in ("", None) else "-".rjust(int(re.match(r"\d+", form).group()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinds", nargs="*", metavar="KIND")
    parser.add_argument("--most", type=int, default=10**6)
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--csv")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--whittle", default=str(HERE.parent / "build/release/whittle"))
    parser.add_argument("--povray", default="povray")
    options = parser.parse_args()
    for program in ("whittle", "povray"):
        if "/" in getattr(options, program):
            setattr(options, program, str(pathlib.Path(getattr(options, program)).resolve()))
    if unknown := set(options.kinds) - set(NUMBERS):
        parser.error(f"no such kind: {', '.join(sorted(unknown))}; there are {', '.join(NUMBERS)}")

    every, bad = [], 0
    print(f"{'kind':<11}{'n':>8}{'parse s':>9}{'build s':>9}{'trace s':>9}{'ns/pixel':>9}{'bytes/n':>9}{'build':>7}{'trace':>7}"
          f"{'| POV-Ray parse':>16}{'trace s':>9}{'bytes/n':>9}{'agree':>8}")
    with tempfile.TemporaryDirectory() as folder:
        for kind in options.kinds or NUMBERS:
            rows = []
            for n in NUMBERS[kind]:
                if n > options.most:
                    continue
                try:
                    row = measure(options, kind, n, folder)
                except Failure as failure:
                    print(f"{kind} {n}: {failure}", file=sys.stderr)
                    bad += 1
                    continue
                build, trace = growth(rows, row) if rows else (None, None)
                first = rows[0] if rows else row
                more = n - first["n"]
                row["bytes_each"] = (row["memory"] - first["memory"]) / more if more else ""
                row["povray_bytes_each"] = (row["povray_memory"] - first["povray_memory"]) / more if more and row["povray_memory"] else ""
                wrong = max(build or 0, trace or 0) > BOUND or (row["agree"] != "" and row["agree"] < 0.99)
                bad += wrong
                rows.append(row)
                print(f"{kind:<11}{n:>8}{row['parse']:>9.3f}{row['plan']:>9.3f}{row['trace']:>9.3f}{row['trace'] * 1e9 / (SIZE[0] * SIZE[1]):>9.0f}"
                      f"{told(row['bytes_each'], '9.0f')}{told(build, '7.2f')}{told(trace, '7.2f')}{told(row['povray_parse'], '16.3f')}"
                      f"{told(row['povray_trace'], '9.3f')}{told(row['povray_bytes_each'], '9.0f')}{told(row['agree'], '8.4f')}{'  !' if wrong else ''}", flush=True)
            every += rows
    if options.csv and every:
        with open(options.csv, "w", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=every[0].keys())
            writer.writeheader()
            writer.writerows(every)
    return 1 if options.check and bad else 0


if __name__ == "__main__":
    sys.exit(main())
