#!/usr/bin/python3
"""Files that the scenes of bench/parse read: meshes as text, a million numbers, files that include files.

usage: bench/parse_inputs.py FOLDER [SCENE...]: writes what the scenes named (all, if none is) read into the folder.
"""
import math
import pathlib
import sys

DEEP = 12  # files that include one another
NUMBERS = 1_000_000


def height(x, z):
    return 0.1 * math.sin(9 * x) * math.cos(7 * z) + 0.03 * math.sin(31 * x + 17 * z)


def normal(x, z):
    step = 1e-4
    slope = ((height(x + step, z) - height(x - step, z)) / (2 * step), (height(x, z + step) - height(x, z - step)) / (2 * step))
    length = math.sqrt(1 + slope[0] ** 2 + slope[1] ** 2)
    return -slope[0] / length, 1 / length, -slope[1] / length


def vector(*numbers):
    return "<" + ",".join(f"{n:.6f}" for n in numbers) + ">"


def mesh2_text(folder, side=500):
    places = [(i / (side - 1), j / (side - 1)) for j in range(side) for i in range(side)]
    faces = []
    for j in range(side - 1):
        for i in range(side - 1):
            at = j * side + i
            faces += [f"<{at},{at + 1},{at + side}>", f"<{at + 1},{at + side + 1},{at + side}>"]
    with open(folder / "mesh2_text.inc", "w") as out:
        out.write("#declare Land = mesh2 {\n")
        for name, lines in (("vertex_vectors", [vector(x, height(x, z), z) for x, z in places]),
                            ("normal_vectors", [vector(*normal(x, z)) for x, z in places]), ("face_indices", faces)):
            out.write(f"  {name} {{\n    {len(lines)},\n    " + ",\n    ".join(lines) + "\n  }\n")
        out.write("}\n")


def mesh_text(folder, side=250):
    def corner(i, j):
        x, z = i / (side - 1), j / (side - 1)
        return vector(x, height(x, z), z), vector(*normal(x, z))

    with open(folder / "mesh_text.inc", "w") as out:
        out.write("#declare Land = mesh {\n")
        for j in range(side - 1):
            for i in range(side - 1):
                a, b, c, d = corner(i, j), corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1)
                out.write(f"  triangle {{ {a[0]}, {b[0]}, {c[0]} }}\n")
                out.write(f"  smooth_triangle {{ {b[0]}, {b[1]}, {d[0]}, {d[1]}, {c[0]}, {c[1]} }}\n")
        out.write("}\n")


def read_numbers(folder):
    with open(folder / "numbers.dat", "w") as out:
        for i in range(0, NUMBERS, 4):
            out.write(f"{i}, {math.sin(i):.6f}, {-i / 7:.4f}, {math.cos(i):.3e},\n")


def includes(folder):
    for level in range(1, DEEP + 1):
        deeper = f'#include "deep_{level + 1}.inc"\n' if level < DEEP else ""
        (folder / f"deep_{level}.inc").write_text(
            f"// Level {level}.\n#local Here{level} = {level};\n{deeper}#declare Total = Total + Here{level};\n")


MAKERS = {"mesh2_text": mesh2_text, "mesh_text": mesh_text, "read_numbers": read_numbers, "includes": includes}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    for name in sys.argv[2:] or MAKERS:
        MAKERS[name](folder)


if __name__ == "__main__":
    main()
