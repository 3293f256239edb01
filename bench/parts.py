#!/usr/bin/python3
"""Meshes of scenes/parts: written, checked again by a reader of its own, measured, and drawn beside the exact solids.

usage: parts.py [--whittle PROGRAM] [--out FOLDER] [--tolerance T] [--sheet FILE] [--before PROGRAM] [--table FILE] [NAME...]

Each scene becomes FOLDER/NAME.stl and NAME.3mf. Both are read again here, without the program's code: every edge has one
triangle on each side that runs the other way, triangles about a vertex form one ring, the volume is that of the report.
--sheet draws the exact scene beside its mesh; with --before it does nothing else, and draws another program's mesh between; --table writes the table of docs/parts.md. Exit status 1 if anything fails.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import time
import xml.etree.ElementTree as xml
import zipfile

import numpy as np

import mesh_quality

ROOT = pathlib.Path(__file__).resolve().parent.parent


def read_stl(path):
    """Vertices welded where their numbers are equal, and triangles, of a binary STL."""
    data = path.read_bytes()
    count = int.from_bytes(data[80:84], "little")
    assert len(data) == 84 + 50 * count, f"{path}: {len(data)} bytes for {count} triangles"
    records = np.frombuffer(data, dtype=np.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")]), offset=84)
    vertices, triangles = np.unique(records["v"].reshape(-1, 3), axis=0, return_inverse=True)
    return vertices.astype(float), triangles.reshape(-1, 3)


def read_3mf(path):
    """A list of (name, colour, vertices, triangles), and the unit."""
    space = {"m": "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"}
    root = xml.fromstring(zipfile.ZipFile(path).read("3D/3dmodel.model"))
    colors = {g.get("id"): [b.get("displaycolor") for b in g.findall("m:base", space)]
              for g in root.findall("m:resources/m:basematerials", space)}
    parts = []
    for item in root.findall("m:resources/m:object", space):
        v = np.array([[float(p.get(k)) for k in "xyz"] for p in item.findall("m:mesh/m:vertices/m:vertex", space)])
        t = np.array([[int(p.get(k)) for k in ("v1", "v2", "v3")]
                      for p in item.findall("m:mesh/m:triangles/m:triangle", space)])
        parts.append((item.get("name"), colors[item.get("pid")][int(item.get("pindex") or 0)], v, t))
    assert len(root.findall("m:build/m:item", space)) == len(parts)
    return parts, root.get("unit")


def faults(vertices, triangles):
    """What keeps triangles from bounding a solid, in words."""
    found = []
    if np.any(triangles[:, 0] == triangles[:, 1]) or np.any(triangles[:, 1] == triangles[:, 2]) \
            or np.any(triangles[:, 2] == triangles[:, 0]):
        found.append("a triangle names a vertex twice")
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    code = sides[:, 0].astype(np.int64) * len(vertices) + sides[:, 1]
    back = sides[:, 1].astype(np.int64) * len(vertices) + sides[:, 0]
    if len(np.unique(code)) != len(code):
        found.append("an edge runs the same way twice")
    if not np.array_equal(np.sort(code), np.sort(back)):
        found.append("an edge is open")
    # About a vertex: corners joined by common neighbours are one group; as many groups as vertices, or it is pinched.
    if not found:
        corner = np.concatenate([triangles[:, 0], triangles[:, 1], triangles[:, 2]])
        towards = np.concatenate([triangles[:, 1], triangles[:, 2], triangles[:, 0]])
        other = np.concatenate([triangles[:, 2], triangles[:, 0], triangles[:, 1]])
        order = np.lexsort((towards, corner))
        key = (corner.astype(np.int64) * len(vertices) + towards)[order]
        follow = order[np.searchsorted(key, corner.astype(np.int64) * len(vertices) + other)]
        seen = np.zeros(len(corner), bool)
        rings = 0
        for start in range(len(corner)):
            if seen[start]:
                continue
            rings += 1
            at = start
            while not seen[at]:
                seen[at] = True
                at = follow[at]
        if rings != len(np.unique(corner)):
            found.append(f"{rings - len(np.unique(corner))} vertices are pinched")
    return found


def volume(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def crossing_pairs(vertices, triangles, most=4000):
    """Triangles that cross others with which they share no vertex: each edge against each triangle, by brute force."""
    if len(triangles) > most:
        return None
    v = vertices[triangles]
    low, high = v.min(1), v.max(1)
    found = 0
    for i in range(len(triangles)):
        near = np.all(low <= high[i], 1) & np.all(high >= low[i], 1)
        near &= ~np.isin(triangles, triangles[i]).any(1)
        near[:i] = False
        for j in np.nonzero(near)[0]:
            if triangles_cross(v[i], v[j]):
                found += 1
    return found


def triangles_cross(s, t):
    """Whether an edge of one passes through the inside of the other."""
    for a, b in ((s, t), (t, s)):
        n = np.cross(b[1] - b[0], b[2] - b[0])
        d = (a - b[0]) @ n
        for k in range(3):
            p, q, dp, dq = a[k], a[(k + 1) % 3], d[k], d[(k + 1) % 3]
            if dp * dq >= 0:
                continue
            x = p + (q - p) * (dp / (dp - dq))
            sides = [np.dot(n, np.cross(b[(m + 1) % 3] - b[m], x - b[m])) for m in range(3)]
            if min(sides) > 0:
                return True
    return False


def mesh2_text(vertices, triangles, normals=None):
    """As a scene has it: y and z back in their places."""
    v = vertices[:, [0, 2, 1]]
    out = ["mesh2 { vertex_vectors { %d" % len(v)]
    out += [", <%.9g, %.9g, %.9g>" % tuple(p) for p in v]
    if normals is not None:
        out += ["} normal_vectors { %d" % len(v)]
        out += [", <%.9g, %.9g, %.9g>" % tuple(p) for p in normals[:, [0, 2, 1]]]
    out += ["} face_indices { %d" % len(triangles)]
    out += [", <%d, %d, %d>" % tuple(t) for t in triangles]
    return "\n".join(out + ["} }"])


def render_scene(whittle, scene, picture, folder):
    subprocess.run([whittle, str(scene), f"+O{picture}", "+W320", "+H240", "+A0.1", "-D", f"+L{folder}"], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)


def meshed_scene(scene, ply, folder):
    """The scene with its meshes in place of its objects; normals are those of the file."""
    text = scene.read_text()
    head = text[:text.index("#declare Paint")]
    meshed = folder / (ply.stem + "_mesh.pov")
    table, triangles = mesh_quality.read_ply(ply)
    vertices = mesh_quality.vectors(table, "xyz")
    normals = mesh_quality.vectors(table, ("nx", "ny", "nz")) if "nx" in table.dtype.names else None
    colors = mesh_quality.vectors(table, ("red", "green", "blue"))
    body = ""
    for color in np.unique(colors, axis=0):
        own = triangles[np.all(colors[triangles[:, 0]] == color, 1)]
        used, t = np.unique(own, return_inverse=True)
        body += "object { %s pigment { srgb <%g, %g, %g> } finish { ambient 0.1 diffuse 0.9 } }\n" % (
            mesh2_text(vertices[used], t.reshape(-1, 3), None if normals is None else normals[used]), *(color / 255))
    meshed.write_text(head + body)
    return meshed


def draw(whittle, scene, makers, folder, tolerance):
    """The exact scene, and the same with the meshes that each of the programs makes."""
    pictures = [folder / (scene.stem + "_exact.png")]
    render_scene(whittle, scene, pictures[0], scene.parent)
    for i, maker in enumerate(makers):
        ply = folder / f"{scene.stem}_{i}.ply"
        subprocess.run([maker, "mesh", str(scene), "-o", str(ply), f"--tolerance={tolerance}"],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=900)
        pictures.append(folder / (ply.stem + ".png"))
        render_scene(whittle, meshed_scene(scene, ply, folder), pictures[-1], scene.parent)
    return pictures


def sheet(rows, path):
    from PIL import Image, ImageDraw
    w, h, each = 320, 240, len(rows[0][1])
    columns = 4 // each
    lines = (len(rows) + columns - 1) // columns
    out = Image.new("RGB", (columns * (each * w + 16), lines * (h + 22)), "white")
    pen = ImageDraw.Draw(out)
    for i, (name, pictures) in enumerate(rows):
        x, y = (i % columns) * (each * w + 16), (i // columns) * (h + 22)
        pen.text((x + 4, y + 4), f"{name}: exact solid, " + ("and its mesh" if each == 2 else "its mesh before, and after"), fill="black")
        for k, picture in enumerate(pictures):
            out.paste(Image.open(picture).convert("RGB"), (x + k * w, y + 20))
    out.save(path, quality=88)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--whittle", default=str(ROOT / "build/release/whittle"))
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("parts"))
    parser.add_argument("--tolerance", default="0.01")
    parser.add_argument("--sheet")
    parser.add_argument("--before")
    parser.add_argument("--table", type=pathlib.Path)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    failed, rows, table = False, [], []
    for scene in sorted((ROOT / "scenes/parts").glob("*.pov")):
        if options.names and scene.stem not in options.names:
            continue
        if options.before:
            rows.append((scene.stem, draw(options.whittle, scene, (options.before, options.whittle), options.out, options.tolerance)))
            continue
        troubles, report = [], ""
        start = time.time()
        for kind in ("stl", "3mf"):
            out = options.out / f"{scene.stem}.{kind}"
            out.unlink(missing_ok=True)
            done = subprocess.run([options.whittle, "mesh", str(scene), "-o", str(out), f"--tolerance={options.tolerance}"],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=900)
            report = done.stdout
            if done.returncode != 0:
                troubles.append(f"{kind}: status {done.returncode}: {done.stderr.strip()}")
        seconds = (time.time() - start) / 2
        exact = [(float(v), float(e)) for v, e in re.findall(r"volume\s+\S+ by rays (\S+) \+- (\S+)", report)]
        off = [max(float(a), float(b)) for a, b in re.findall(r"of the mesh (\S+) .*?of the object (\S+) ", report)]
        area = sum(float(a) for a in re.findall(r"surface\s+(\S+), by rays", report))
        by_rays, error = sum(v for v, _ in exact), sum(e for _, e in exact)
        if (options.out / f"{scene.stem}.3mf").exists() and (options.out / f"{scene.stem}.stl").exists():
            v, t = read_stl(options.out / f"{scene.stem}.stl")
            troubles += [f"stl: {f}" for f in faults(v, t)]
            own = volume(v, t)
            parts, unit = read_3mf(options.out / f"{scene.stem}.3mf")
            for name, _, pv, pt in parts:
                troubles += [f"3mf: {name}: {f}" for f in faults(pv, pt)]
                pairs = crossing_pairs(pv, pt)
                if pairs:
                    troubles.append(f"3mf: {name}: {pairs} pairs of triangles cross")
            if unit != "millimeter":
                troubles.append(f"3mf: the unit is {unit}")
            for what, found in (("stl", own), ("3mf", sum(volume(pv, pt) for _, _, pv, pt in parts))):
                if abs(found - by_rays) > error + float(options.tolerance) * area:
                    troubles.append(f"{what}: volume {found:.6g}, by rays {by_rays:.6g} +- {error:.2g}")
            table.append(f"| {scene.stem} | {len(parts)} | {len(t)} | {own:.5g} | {by_rays:.5g} ± {error:.1g} | "
                         f"{100 * (own / by_rays - 1):+.3f} % | {max(off):.4f} | {seconds:.1f} | "
                         f"{'passed' if not troubles else 'FAILED'} |")
            if options.sheet:
                rows.append((scene.stem, draw(options.whittle, scene, (options.whittle,), options.out, options.tolerance)))
        print(f"{scene.stem:10} {'ok' if not troubles else 'FAILED'}  {seconds:.1f} s  off {max(off, default=0):.4g}")
        for trouble in troubles:
            print("   ", trouble)
        failed = failed or bool(troubles)
    if options.table:
        options.table.write_text("| scene | parts | triangles | volume of the mesh | by rays | apart | farthest off | "
                                 "seconds a file | checks |\n|---|---:|---:|---:|---:|---:|---:|---:|---|\n"
                                 + "\n".join(table) + "\n")
    if options.sheet:
        sheet(rows, options.sheet)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
