#!/usr/bin/python3
"""How good the triangles of `whittle mesh` are: a table of the ball and the bored box of bench/solids and of scenes/parts.

usage: mesh_quality.py [--whittle PROGRAM] [--out FOLDER] [--tolerance T] [--samples N] [--table FILE] [--openscad] [NAME...]

For each part, from its PLY file:
  off      farthest vertex from the surface, scene units: by formula of ball, bored box and chain, else by trace() of the scene's own object
  angle    least angle of the triangles in degrees: the least of all, and that which 99 % of them have at least
  facing   angle in degrees between a triangle and the surface above its middle: which 99 % are within, and the greatest
  normals  angle in degrees between the normal that a vertex carries and the surface's: 99 %, and the greatest ("-": the file has none)
  seconds  of processor time of the whole command
Vertices on a sharp edge have a normal for each side, and trace() meets one of the sides: their normals are not compared.
"""
import argparse
import os
import pathlib
import re
import subprocess

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
OBJECTS = {"blob": "Drop", "julia": "Fractal", "thread": "Bolt"}  # others are named as their file


def read_ply(path):
    """Numbers of the vertices by property, and triangles, of a binary PLY."""
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    kinds = {"float": "<f4", "uchar": "u1", "int": "<i4"}
    element, vertex, counts = "", [], {}
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
        elif words[0] == "property" and element == "vertex":
            vertex.append((words[2], kinds[words[1]]))
    vertices = np.frombuffer(body, np.dtype(vertex), counts["vertex"])
    faces = np.frombuffer(body, np.dtype([("n", "u1"), ("v", "<i4", 3)]), counts["face"], vertices.nbytes)
    return vertices, faces["v"].astype(int)


def vectors(table, names):
    return np.stack([table[n].astype(float) for n in names], 1)


def unit(v):
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-300)


def degrees_between(a, b):
    a, b = unit(a), unit(b)
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), np.sum(a * b, -1)))


def least_angles(v, t):
    a = [v[t[:, (k + 1) % 3]] - v[t[:, k]] for k in range(3)]
    return np.min([degrees_between(a[k], -a[k - 1]) for k in range(3)], 0)


def ball(points, *_):
    """Distance from the ball, and its normal."""
    return np.abs(np.linalg.norm(points, axis=1) - 1), unit(points)


def bored(points, towards, *_):
    """Distance from the bored box, and the normal of the nearest face that looks most as `towards`; the bore's axis is z, as files have it."""
    r = np.hypot(points[:, 0], points[:, 1])
    gaps = [np.abs(r - 0.5)] + [np.abs(s * points[:, k] - 1) for k in range(3) for s in (1, -1)]
    normals = [unit(np.stack([-points[:, 0], -points[:, 1], 0 * r], 1))]
    normals += [np.broadcast_to(s * np.eye(3)[k], points.shape) for k in range(3) for s in (1, -1)]
    gaps = np.stack(gaps)
    least = gaps.min(0)
    facing = np.where(gaps <= least + 1e-5, np.einsum("fpk,pk->fp", np.stack(normals), towards), -9)
    return least, np.stack(normals)[facing.argmax(0), np.arange(len(points))]


def chain(points, *_):
    """Distance from the nearest of five rings, and its normal."""
    gaps, normals = [], []
    for i in range(-2, 3):
        p = points - (1.1 * i, 0, 0)
        axis, other = (2, 1) if i % 2 == 0 else (1, 2)
        r = np.hypot(p[:, 0], p[:, other])
        ring = np.zeros_like(p)
        ring[:, 0], ring[:, other] = 0.8 * p[:, 0] / r, 0.8 * p[:, other] / r
        gaps.append(np.abs(np.linalg.norm(p - ring, axis=1) - 0.22))
        normals.append(unit(p - ring))
    gaps = np.stack(gaps)
    return gaps.min(0), np.stack(normals)[gaps.argmin(0), np.arange(len(points))]


def traced(whittle, scene, folder, points, towards, reach, thin=False):
    """The same of the scene's object by its own trace(): met from `reach` outside, along the normal; NaN where nothing is met. `thin`: of what is met along
    it and against it, begun farther and nearer, the nearest, as a line that begins beyond a wall or a gap, which letters have, meets another face first."""
    starts = [s * k * reach for k in (1, 0.1, 0.01) for s in (1, -1)] if thin else [reach]
    name = OBJECTS.get(scene.stem, scene.stem.capitalize())
    rows = np.concatenate([points, towards], 1)[:, [0, 2, 1, 3, 5, 4]]
    (folder / "asked.txt").write_text(",\n".join(", ".join(f"{x:.12g}" for x in r) for r in rows) + "\n")
    (folder / "ask.pov").write_text(
        f'#include "{scene}"\n#fopen In "{folder}/asked.txt" read\n#fopen Out "{folder}/answers.txt" write\n'
        f"#declare Reach = array[{len(starts)}] {{ {', '.join(map(str, starts))} }}\n"
        f"#while (defined(In)) #read (In, A, B, C, D, E, F)\n"
        f"#declare P = <A, B, C>; #declare Along = <D, E, F>; #declare Best = <9e9, 9e9, 9e9>; #declare Normal = <0, 0, 0>;\n"
        f"#for (K, 0, {len(starts) - 1})\n#declare N = <0, 0, 0>;\n"
        f"#declare Q = trace({name}, P + Reach[K] * Along, (Reach[K] > 0 ? -1 : 1) * Along, N);\n"
        f"#if (vlength(N) > 0 & vlength(Q - P) < vlength(Best - P)) #declare Best = Q; #declare Normal = N; #end\n#end\n"
        f'#write (Out, vstr(3, Best, " ", 0, 12), " ", vstr(3, Normal, " ", 0, 12), "\\n")\n#end\n#fclose Out\n')
    subprocess.run([whittle, str(folder / "ask.pov"), "+W4", "+H3", "-D", f"+O{folder}/ask.png", f"+L{scene.parent}"], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)
    answers = np.loadtxt(folder / "answers.txt")[:, [0, 2, 1, 3, 5, 4]]
    gap = np.linalg.norm(answers[:, :3] - points, axis=1)
    gap[gap > 20 * reach] = np.nan
    # trace() tells raw normals, and those of some solids look inward.
    normals = answers[:, 3:]
    return gap, np.where(np.sum(normals * towards, 1, keepdims=True) < 0, -normals, normals)


def exact_of(whittle, scene, folder, tolerance):
    """A function that tells distances and normals, and whether it may be asked for all."""
    if scene.stem in ("ball", "bored", "chain"):
        return {"ball": ball, "bored": bored, "chain": chain}[scene.stem], True
    return (lambda p, n, thin=False: traced(whittle, scene, folder, p, n, 2 * float(tolerance), thin)), False


def judged(vertices, triangles, exact, all_of_them, samples, normals=None):
    """Columns of the table: off, angle, facing, normals; and how far middles of triangles are off at most."""
    faces = np.cross(vertices[triangles[:, 1]] - vertices[triangles[:, 0]], vertices[triangles[:, 2]] - vertices[triangles[:, 0]])
    angles = least_angles(vertices, triangles)
    random = np.random.default_rng(1)
    most = max(len(triangles), len(vertices)) if all_of_them else samples
    some_faces, some_vertices = random.permutation(len(triangles))[:most], random.permutation(len(vertices))[:most]
    middles = vertices[triangles[some_faces]].mean(1)
    sunk, above = exact(middles, unit(faces[some_faces]), True)
    facing = degrees_between(faces[some_faces], above)
    facing = facing[np.linalg.norm(above, axis=1) > 0.5]
    # A vertex is looked at along the mean of its triangles.
    mean = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(mean, triangles[:, k], unit(faces))
    gap, at_vertex = exact(vertices[some_vertices], unit(mean[some_vertices]))
    told = "-"
    if normals is not None:
        # One place, one vertex: what has a twin lies on a sharp edge.
        _, index, count = np.unique(vertices, axis=0, return_inverse=True, return_counts=True)
        alone = (count[index.reshape(-1)][some_vertices] == 1) & (np.linalg.norm(at_vertex, axis=1) > 0.5)
        bent = degrees_between(normals[some_vertices][alone], at_vertex[alone])
        told = f"{np.percentile(bent, 99):.2f}, {bent.max():.1f}" if len(bent) else "-"
    return (f"{np.nanmax(gap):.1e} ({np.nanpercentile(gap, 99):.1e})", f"{angles.min():.2f}, {np.percentile(angles, 1):.1f}",
            f"{np.percentile(facing, 99):.1f}, {facing.max():.1f}", told, np.nanmax(sunk))


def timed(command, limit=900):
    """What a command says, and the seconds of processor time that it took."""
    before = os.times()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=limit)
    after = os.times()
    return done, after.children_user + after.children_system - before.children_user - before.children_system


def quality(whittle, scene, folder, tolerance, samples):
    path = folder / f"{scene.stem}.ply"
    path.unlink(missing_ok=True)
    done, seconds = timed([whittle, "mesh", str(scene), "-o", str(path), f"--tolerance={tolerance}"])
    if not path.exists():
        return f"| {scene.stem} | - | | | | | | {seconds:.1f} | FAILED: {done.stderr.strip()} |"
    table, triangles = read_ply(path)
    apart = [max(float(a), float(b)) for a, b in re.findall(r"of the mesh (\S+) .*?of the object (\S+) ", done.stdout)]
    normals = vectors(table, ("nx", "ny", "nz")) if "nx" in table.dtype.names else None
    off, angle, facing, told, _ = judged(vectors(table, "xyz"), triangles, *exact_of(whittle, scene, folder, tolerance), samples, normals)
    return (f"| {scene.stem} | {len(triangles)} | {off} | {max(apart):.4f} | {angle} | {facing} | {told} | {seconds:.1f} | "
            f"{'passed' if done.returncode == 0 else 'FAILED'} |")


def openscad_quality(whittle, scad, folder, tolerance, samples):
    """The same of what OpenSCAD makes of the part's description for it; apart: middles of triangles alone."""
    path = folder / f"{scad.stem}_openscad.stl"
    _, seconds = timed(["openscad", "-o", str(path), f"-Dtolerance={tolerance}", str(scad)])
    corners = np.array(re.findall(r"vertex (\S+) (\S+) (\S+)", path.read_text()), float)
    vertices, triangles = np.unique(corners, axis=0, return_inverse=True)
    scene = next(p for p in (ROOT / f"bench/solids/{scad.stem}.pov", ROOT / f"scenes/parts/{scad.stem}.pov") if p.exists())
    off, angle, facing, told, sunk = judged(vertices, triangles.reshape(-1, 3), *exact_of(whittle, scene, folder, tolerance), samples)
    return f"| {scad.stem}, OpenSCAD | {len(triangles.reshape(-1, 3))} | {off} | {sunk:.4f} | {angle} | {facing} | {told} | {seconds:.1f} | |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--whittle", default=str(ROOT / "build/release/whittle"))
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("meshes"))
    parser.add_argument("--tolerance", default="0.01")
    parser.add_argument("--samples", type=int, default=4000)
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--openscad", action="store_true", help="rows of OpenSCAD's too, of the parts that bench/solids describes for it")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    folder = options.out.resolve()
    lines = ["| part | triangles | vertices off: most (99 %) | mesh and part apart | least angle, 99 % have | "
             "facing: 99 % within, most | normals: 99 %, most | seconds | checks |", "|---|---:|---:|---:|---:|---:|---:|---:|---|"]
    for scene in sorted((ROOT / "bench/solids").glob("*.pov")) + sorted((ROOT / "scenes/parts").glob("*.pov")):
        if options.names and scene.stem not in options.names:
            continue
        lines.append(quality(options.whittle, scene, folder, options.tolerance, options.samples))
        print(lines[-1], flush=True)
        scad = ROOT / f"bench/solids/{scene.stem}.scad"
        if options.openscad and scad.exists():
            lines.append(openscad_quality(options.whittle, scad, folder, options.tolerance, options.samples))
            print(lines[-1], flush=True)
    if options.table:
        options.table.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
