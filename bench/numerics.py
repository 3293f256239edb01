#!/usr/bin/python3
"""The laboratory of numbers as a report: error against run time of every solid, beside POV-Ray's trace().

usage: bench/numerics.py [--rays 20000] [--povray-rays 400] [--out build/numerics] [--lab build/release/numerics_lab] [--povray povray]

Runs numerics_lab over all sweeps, asks the real POV-Ray the same rays where it is installed (--povray '' leaves it out), and
writes numerics.csv, povray.csv, a plot (SVG) for each sweep and index.html with tables and plots.
"""
import argparse
import csv
import html
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
COLORS = ["#1b6ca8", "#c0392b", "#2e8b57", "#8e44ad", "#d68910", "#16a085", "#7f5539", "#e05a9b", "#34495e", "#6c9a00", "#b03060", "#0097a7",
          "#5d4037", "#9e9d24", "#512da8"]


def ask_povray(povray, asked, rays):
    """Missed, false and worst relative error of trace() against the oracle's first hits; None if it refuses the object."""
    lines = asked.read_text().splitlines()
    sdl, questions = lines[0], [list(map(float, line.split(","))) for line in lines[1:rays + 1]]
    text = '#version 3.7; global_settings { assumed_gamma 1 }\n#fopen F "answers.txt" write\n#declare N = <0,0,0>;\n#declare S = ' + sdl + "\n"
    for q in questions:
        o, d = q[0:3], q[3:6]
        text += "#declare H = trace(S, <%.17g,%.17g,%.17g>, <%.17g,%.17g,%.17g>, N);\n" % (*o, *d)
        # vlength() of the difference would round again: the component along the ray is enough.
        text += '#write(F, concat(str((vlength(N) > 0), 0, 0), ",", vstr(3, H, ",", 0, 15), "\\n"))\n'
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "ask.pov").write_text(text)
        subprocess.run([povray, "+Iask.pov", "-D", "-F", "+W1", "+H1"], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, check=False)
        written = pathlib.Path(folder, "answers.txt")
        answers = written.read_text().splitlines() if written.exists() else []
    if len(answers) != len(questions):
        return None
    missed = wrong = 0
    worst = 0.0
    for q, answer in zip(questions, answers):
        o, d, hit, clear, t = q[0:3], q[3:6], q[6] > 0, q[7] > 0, q[8]
        got = list(map(float, answer.split(",")))
        if not clear:
            continue
        if hit != (got[0] > 0):
            missed += hit
            wrong += not hit
        elif hit:
            # Errors of the point as told, 15 digits: of the parameter along the ray.
            along = sum((p - a) * c for p, a, c in zip(got[1:4], o, d)) / sum(c * c for c in d)
            worst = max(worst, abs(along - t))
    return missed, wrong, worst


def reach(row):
    """The larger of distance and size, as numerics_lab takes it."""
    value = float(row["value"])
    return {"scale": 6 * value, "distance": 6 * value}.get(row["sweep"], 6.0)


def plot(path, title, rows, povray):
    """Worst error over the swept value, log-log, a line a solid; POV-Ray's dashed."""
    width, height, left, bottom = 760, 380, 60, 40
    solids = sorted({r["solid"] for r in rows}, key=[r["solid"] for r in rows].index)
    xs = sorted({math.log10(float(r["value"])) for r in rows})
    low, high = -17.0, 1.0
    span = (xs[-1] - xs[0]) or 1.0

    def place(value, error):
        x = left + (math.log10(value) - xs[0]) / span * (width - left - 170)
        y = (height - bottom) - (max(low, min(high, math.log10(max(error, 1e-17)))) - low) / (high - low) * (height - bottom - 30)
        return f"{x:.1f},{y:.1f}"

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="11">',
           f'<rect width="{width}" height="{height}" fill="white"/><text x="{left}" y="18" font-size="13">{html.escape(title)}</text>']
    for power in range(-16, 2, 2):
        y = place(10 ** xs[0], 10.0 ** power).split(",")[1]
        out.append(f'<line x1="{left}" x2="{width - 170}" y1="{y}" y2="{y}" stroke="#ddd"/><text x="8" y="{y}" dy="4">1e{power}</text>')
    for x in xs:
        at = place(10 ** x, 1e-17).split(",")[0]
        out.append(f'<text x="{at}" y="{height - 18}" text-anchor="middle">1e{x:.0f}</text>')
    for i, solid in enumerate(solids):
        color = COLORS[i % len(COLORS)]
        own = [r for r in rows if r["solid"] == solid]
        points = " ".join(place(float(r["value"]), float(r["worst"])) for r in own)
        out.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="1.8"/>')
        theirs = [(float(r["value"]), povray[(r["sweep"], r["solid"], r["value"])]) for r in own if povray.get((r["sweep"], r["solid"], r["value"]))]
        if theirs:
            points = " ".join(place(v, e[2] / reach({"sweep": own[0]["sweep"], "value": v})) for v, e in theirs)
            out.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-dasharray="4 3"/>')
        y = 40 + 16 * i
        out.append(f'<rect x="{width - 155}" y="{y - 8}" width="10" height="10" fill="{color}"/><text x="{width - 140}" y="{y + 1}">{solid}</text>')
    out.append(f'<text x="{width - 155}" y="{height - 18}">dashed: POV-Ray</text></svg>')
    path.write_text("\n".join(out))


def page(path, sweeps, rows, povray, command):
    columns = ["value", "solid", "hits", "missed", "false", "worst", "median", "grazing", "ns", "spawn", "acne_per_million", "lost_per_million", "disagree"]
    out = ["<!doctype html><meta charset='utf-8'><title>Numbers</title><style>body{font:14px sans-serif;max-width:60em;margin:2em auto}",
           "td,th{padding:1px 7px;text-align:right;border-bottom:1px solid #ddd}td.bad{background:#fbd5d5}</style><h1>Error against run time</h1>",
           f"<p>{html.escape(command)}. Errors are relative to the larger of distance and size of the object; red rows miss their bar.</p>"]
    for name in sweeps:
        out.append(f"<h2>{name}</h2><img src='{name}.svg'><table><tr>" + "".join(f"<th>{c}</th>" for c in columns) +
                   "<th>POV-Ray missed</th><th>false</th><th>worst</th></tr>")
        for r in rows:
            if r["sweep"] != name:
                continue
            bad = " class='bad'" if r["passes"] == "0" else ""
            theirs = povray.get((name, r["solid"], r["value"]))
            told = [str(theirs[0]), str(theirs[1]), f"{theirs[2] / reach(r):.1e}"] if theirs else ["", "", ""]
            out.append("<tr>" + "".join(f"<td{bad}>{r[c]}</td>" for c in columns) + "".join(f"<td>{t}</td>" for t in told) + "</tr>")
        out.append("</table>")
    path.write_text("\n".join(out))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rays", type=int, default=20000)
    parser.add_argument("--povray-rays", type=int, default=400)
    parser.add_argument("--out", type=pathlib.Path, default=HERE.parent / "build/numerics")
    parser.add_argument("--lab", default=str(HERE.parent / "build/release/numerics_lab"))
    parser.add_argument("--povray", default="povray")
    args = parser.parse_args()
    asked = args.out / "rays"
    asked.mkdir(parents=True, exist_ok=True)
    table = args.out / "numerics.csv"
    command = [args.lab, "--rays", str(args.rays), "--csv", str(table), "--asked", str(asked)]
    if subprocess.run(command, check=False).returncode != 0:
        sys.exit("numerics_lab failed")
    rows = list(csv.DictReader(table.open()))
    povray = {}
    if args.povray and shutil.which(args.povray):
        with (args.out / "povray.csv").open("w") as told:
            told.write("sweep,value,solid,rays,missed,false,worst\n")
            for r in rows:
                told_rays = asked / f"{r['sweep']}_{r['solid']}_{r['value']}.csv"
                if not told_rays.exists():  # a form that is not compared
                    continue
                answer = ask_povray(args.povray, told_rays, args.povray_rays)
                povray[(r["sweep"], r["solid"], r["value"])] = answer
                if answer:
                    told.write(f"{r['sweep']},{r['value']},{r['solid']},{args.povray_rays},{answer[0]},{answer[1]},{answer[2] / reach(r):.3g}\n")
    sweeps = sorted({r["sweep"] for r in rows}, key=[r["sweep"] for r in rows].index)
    for name in sweeps:
        plot(args.out / f"{name}.svg", f"worst error over {name}", [r for r in rows if r["sweep"] == name], povray)
    page(args.out / "index.html", sweeps, rows, povray, f"{args.rays} rays a row")
    print(f"report: {args.out / 'index.html'}; {sum(r['passes'] == '0' for r in rows)} of {len(rows)} rows miss their bar")


if __name__ == "__main__":
    main()
