#!/usr/bin/python3
"""Every texture, pigment, normal, finish, material, interior and sky_sphere of the standard include files on a test
object, drawn by POV-Ray and by Whittle, compared tile by tile.

usage: contact_sheet.py WHITTLE [--every N] [--sheet PICTURE] [--work DIR] [--povray CMD] [--include DIR] [--only NAME...]

The names are read from the include files of the installed POV-Ray; nothing of them is kept. A tile matches when 99 % of
its pixels are within 3/255 in every channel. Where a finish has crand, whose grain POV-Ray draws from a stream that depends
on the order of pixels, 99 % within 16/255 and means within 1/255 are asked for.
--every takes each Nth name alone. --sheet writes a picture of all tiles (needs Pillow): the left half of each by POV-Ray,
the right half by Whittle.
Exit status: 0 all match, 1 some do not, 77 there is no POV-Ray of the right version or no include files.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

VERSION = "3.7.0.10"
TILE, COLUMNS, ROWS = 64, 6, 5
KINDS = ("texture", "pigment", "normal", "finish", "material", "interior", "sky_sphere")
WITHIN, SHARE = 3, 0.99
GRAIN_WITHIN, GRAIN_MEAN = 16, 1.0

HEAD = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#include "colors.inc"
#include "%s"
"""
SCENE = """camera { orthographic location <0, 0, -20> direction z right %g*x up %g*y }
light_source { <-300, 500, -700> rgb 1 }
background { rgb <0.3, 0.35, 0.4> }
plane { -z, -1.2 pigment { checker rgb 0.9, rgb <0.3, 0.35, 0.5> scale 0.6 } finish { ambient 0.3 diffuse 0.6 } }
"""
SKY = """camera { location 0 direction z right x up y look_at <0, 0.7, 1> }
sky_sphere { %s }
"""
WRITTEN = {
    "texture": "texture { %s }", "pigment": "pigment { %s }", "material": "material { %s }",
    "normal": "pigment { rgb 1 } normal { %s }", "finish": "pigment { rgb <0.8, 0.5, 0.3> } finish { %s }",
    "interior": "pigment { rgbf <0.95, 0.9, 1, 0.9> } finish { specular 0.5 } interior { %s }",
}


def declared(folder):
    """(file, name, kind, grainy) of all declarations of the kinds above, by file, in the order written."""
    found, words_of = [], {}
    for path in sorted(folder.glob("*.inc")):
        # Comments and strings in one go: a line of "//****" begins no block.
        text = re.sub(r'//[^\n]*|/\*.*?\*/|"[^"\n]*"', " ", path.read_text(errors="replace"), flags=re.S)
        text = re.sub(r"#\s*macro\b.*?#\s*end\b", " ", text, flags=re.S)
        kinds = {}
        for match in re.finditer(r"#\s*declare\s+(\w+)\s*=([^#]*(?:#\s*(?:if|else|end)[^#]*)*)", text):
            body = re.sub(r"^\s*#\s*if\s*\([^)]*\)", "", match[2])
            first = re.match(r"\s*(\w+)", body)
            if first is None:
                continue
            kind = kinds.get(first[1], first[1])
            if kind not in KINDS:
                continue
            kinds[match[1]] = kind
            words_of[match[1]] = set(re.findall(r"\w+", match[2]))
        found += [(path.name, name, kind) for name, kind in kinds.items()]
    grainy = {"crand"}
    while more := {name for name, words in words_of.items() if words & grainy} - grainy:
        grainy |= more
    return [(*entry, entry[1] in grainy) for entry in found]


def pictures(names):
    """Groups of names that share a picture: one include file, at most COLUMNS x ROWS of them; a sky alone."""
    groups = []
    for entry in names:
        sky = entry[2] == "sky_sphere"
        last = groups[-1] if groups else None
        if last is None or sky or last[0][2] == "sky_sphere" or last[0][0] != entry[0] or len(last) == COLUMNS * ROWS:
            groups.append([])
        groups[-1].append(entry)
    return groups


def scene_of(group):
    """Text and size of the picture of a group."""
    file, name, kind, _ = group[0]
    if kind == "sky_sphere":
        return HEAD % file + SKY % name, TILE, TILE
    columns = min(COLUMNS, len(group))
    rows = (len(group) + columns - 1) // columns
    text = HEAD % file + SCENE % (2.2 * columns, 2.2 * rows)
    for i, (_, name, kind, _) in enumerate(group):
        x, y = 2.2 * (i % columns - (columns - 1) / 2), 2.2 * ((rows - 1) / 2 - i // columns)
        text += "sphere { 0, 1 %s rotate <-10, 15, 0> translate <%g, %g, 0> }\n" % (WRITTEN[kind] % name, x, y)
    return text, TILE * columns, TILE * rows


def read_ppm(path):
    """Width, height and bytes of a P6 picture."""
    data = path.read_bytes()
    fields = re.match(rb"P6\s+(?:#[^\n]*\n)*(\d+)\s+(\d+)\s+255\s", data)
    return int(fields[1]), int(fields[2]), data[fields.end():]


def draw(command, folder, number, tag, width, height):
    """One picture as a PPM; None and the last words of the program if it fails."""
    out = folder / f"{number:03}.{tag}.ppm"
    done = subprocess.run([*command, f"+I{number:03}.pov", f"+O{out}", f"+W{width}", f"+H{height}", "-A", "-D", "-P", "+WT1", "+FP"],
                          cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode != 0 or not out.exists():
        return None, " ".join(done.stdout.split())[-300:]
    return read_ppm(out), ""


def tile_of(picture, index, columns):
    """Rows of bytes of one tile."""
    width, _, data = picture
    left, top = TILE * (index % columns), TILE * (index // columns)
    return [data[3 * ((top + y) * width + left):3 * ((top + y) * width + left + TILE)] for y in range(TILE)]


def agreement(a, b, grainy):
    """Share of the pixels of two tiles that are near enough in every channel; 0 if the means of grainy ones differ."""
    within, good, sums = (GRAIN_WITHIN if grainy else WITHIN), 0, [0, 0, 0]
    for p, q in zip(a, b):
        for i in range(0, len(p), 3):
            differences = [p[i + c] - q[i + c] for c in range(3)]
            good += max(map(abs, differences)) <= within
            sums = [s + d for s, d in zip(sums, differences)]
    if grainy and max(map(abs, sums)) > GRAIN_MEAN * TILE * TILE:
        return 0.0
    return good / (TILE * TILE)


def compare_group(job):
    """Tiles of one group: (entry, agreement or None, POV-Ray's tile, Whittle's tile, what went wrong)."""
    number, group, folder, povray, whittle = job
    text, width, height = scene_of(group)
    (folder / f"{number:03}.pov").write_text(text)
    reference, trouble = draw(povray, folder, number, "povray", width, height)
    if reference is None:
        return [(entry, None, None, None, "POV-Ray: " + trouble) for entry in group]
    ours, trouble = draw(whittle, folder, number, "whittle", width, height)
    if ours is None:
        return [(entry, None, None, None, "Whittle: " + trouble) for entry in group]
    columns = width // TILE
    tiles = [(tile_of(reference, i, columns), tile_of(ours, i, columns)) for i in range(len(group))]
    return [(entry, agreement(a, b, entry[3]), a, b, "") for entry, (a, b) in zip(group, tiles)]


def write_sheet(path, results):
    """A row of tiles per 16 names, a line with the file's name above its first."""
    from PIL import Image, ImageDraw
    across, gap = 16, 2
    rows = []
    for result in results:
        file = result[0][0]
        if not rows or rows[-1][0] != file or len(rows[-1][1]) == across:
            rows.append((file, []))
        rows[-1][1].append(result)
    heads = [i == 0 or rows[i - 1][0] != row[0] for i, row in enumerate(rows)]
    sheet = Image.new("RGB", (across * (TILE + gap), sum(TILE + gap + (14 if head else 0) for head in heads)), (24, 24, 24))
    pen = ImageDraw.Draw(sheet)
    y = 0
    for (file, entries), head in zip(rows, heads):
        if head:
            pen.text((2, y + 1), file, fill=(230, 230, 230))
            y += 14
        for i, (_, _, a, b, _) in enumerate(entries):
            if a is None:
                continue
            half = 3 * (TILE // 2)
            data = b"".join(p[:half] + q[half:] for p, q in zip(a, b))
            sheet.paste(Image.frombytes("RGB", (TILE, TILE), data), (i * (TILE + gap), y))
        y += TILE + gap
    sheet.save(path, quality=78)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("whittle")
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--include", type=pathlib.Path, default=pathlib.Path("/usr/share/povray-3.7/include"))
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--sheet", type=pathlib.Path)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    try:
        told = subprocess.run([options.povray, "--version"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
    except OSError:
        told = ""
    names = declared(options.include)
    if VERSION not in told or not names:
        print(f"skipped: this needs POV-Ray {VERSION} and its include files")
        return 77
    names = [entry for i, entry in enumerate(names) if i % options.every == 0 and (not options.only or entry[1] in options.only)]
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.work or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        whittle = [str(pathlib.Path(options.whittle).resolve())]
        jobs = [(i, group, folder.resolve(), [options.povray], whittle) for i, group in enumerate(pictures(names))]
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            results = [result for group in pool.map(compare_group, jobs) for result in group]
    bad = 0
    for (file, name, kind, _), share, _, _, trouble in results:
        if share is not None and share >= SHARE:
            continue
        bad += 1
        told = trouble if share is None else f"{100 * share:.2f} %"
        print(f"{file}: {kind} {name}: {told}")
    print(f"{len(results) - bad} of {len(results)} tiles match")
    if options.sheet:
        write_sheet(options.sheet, results)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
