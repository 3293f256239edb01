#!/usr/bin/python3
"""GLB files of `whittle mesh`, read again by forty lines of struct and json: numbers where glTF 2.0 wants them, names, colours, normals.

usage: glb.py WHITTLE
"""
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#declare Ball = sphere { <1, 2, 3>, 1 pigment { rgb <1, 0.25, 0> } }
#declare Bricks = box { <-3, 0, 0>, <-1, 1, 1> pigment { gradient x color_map { [0 rgb 0] [1 rgb <0, 0, 1>] } scale 4 translate -4 * x } }
object { Ball }
object { Bricks }
"""
FORMATS = {5121: "B", 5125: "I", 5126: "f"}
PARTS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}


def read_glb(data):
    """The JSON, and a function that reads an accessor."""
    magic, version, size = struct.unpack_from("<4sII", data)
    assert (magic, version, size) == (b"glTF", 2, len(data)), (magic, version, size, len(data))
    chunks, at = {}, 12
    while at < size:
        length, kind = struct.unpack_from("<I4s", data, at)
        assert length % 4 == 0, f"a chunk of {length} bytes"
        chunks[kind] = data[at + 8:at + 8 + length]
        at += 8 + length
    assert at == size and list(chunks) == [b"JSON", b"BIN\0"], chunks.keys()
    told = json.loads(chunks[b"JSON"])
    assert told["asset"]["version"] == "2.0"
    assert 0 <= len(chunks[b"BIN\0"]) - told["buffers"][0]["byteLength"] < 4

    def read(index):
        accessor = told["accessors"][index]
        view = told["bufferViews"][accessor["bufferView"]]
        each, form = PARTS[accessor["type"]], FORMATS[accessor["componentType"]]
        assert view["byteOffset"] % 4 == 0
        numbers = struct.unpack_from(f"<{each * accessor['count']}{form}", chunks[b"BIN\0"], view["byteOffset"])
        assert struct.calcsize(f"<{len(numbers)}{form}") == view["byteLength"]
        rows = [numbers[i:i + each] for i in range(0, len(numbers), each)]
        if "min" in accessor:
            assert [min(c) for c in zip(*rows)] == list(map(lambda x: struct.unpack("f", struct.pack("f", x))[0], accessor["min"]))
            assert [max(c) for c in zip(*rows)] == list(map(lambda x: struct.unpack("f", struct.pack("f", x))[0], accessor["max"]))
        return rows if each > 1 else list(numbers)

    return told, read


def check_closed(places, indices, name):
    """Vertices in one place are one; each edge runs once there and once back. The volume, positive outward."""
    number = {}
    welded = [number.setdefault(p, len(number)) for p in places]
    sides, volume = set(), 0.0
    for i in range(0, len(indices), 3):
        t = [welded[k] for k in indices[i:i + 3]]
        a, b, c = (places[k] for k in indices[i:i + 3])
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        for k in range(3):
            side = (t[k], t[(k + 1) % 3])
            assert side not in sides, f"{name}: an edge runs the same way twice"
            sides.add(side)
    assert all((b, a) in sides for a, b in sides), f"{name}: an edge is open"
    return volume


def main():
    whittle = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        scene, out = pathlib.Path(folder) / "two.pov", pathlib.Path(folder) / "two.glb"
        scene.write_text(SCENE)
        done = subprocess.run([whittle, "mesh", str(scene), "-o", str(out)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        assert done.returncode == 0, done.stdout
        first = out.read_bytes()
        subprocess.run([whittle, "mesh", str(scene), "-o", str(out), "+WT1"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        assert first == out.read_bytes(), "other bytes on one thread"
    told, read = read_glb(first)
    root = told["nodes"][told["scenes"][told["scene"]]["nodes"][0]]
    assert root["scale"] == [0.001] * 3
    nodes = {told["nodes"][i]["name"]: told["meshes"][told["nodes"][i]["mesh"]]["primitives"][0] for i in root["children"]}
    assert list(nodes) == ["Ball", "Bricks"], nodes.keys()
    for name, volume in (("Ball", 4 / 3 * math.pi), ("Bricks", 2.0)):
        places, normals = read(nodes[name]["attributes"]["POSITION"]), read(nodes[name]["attributes"]["NORMAL"])
        indices = read(nodes[name]["indices"])
        assert max(indices) + 1 == len(places) == len(normals)
        found = check_closed(places, indices, name)
        assert abs(found / volume - 1) < 0.02, (name, found)
        assert all(abs(math.hypot(*n) - 1) < 1e-5 for n in normals)
        if name == "Ball":  # z is turned
            for p, n in zip(places, normals):
                d = (p[0] - 1, p[1] - 2, p[2] + 3)
                assert abs(math.hypot(*d) - 1) < 1e-6 and math.dist(d, n) < 1e-5, (p, n)
            color = told["materials"][nodes[name]["material"]]["pbrMetallicRoughness"]["baseColorFactor"]
            assert all(abs(a - b) < 1e-3 for a, b in zip(color, (1, 0.25, 0, 1))), color
        else:  # faces of a box have normals of their own; the colour goes with x
            flat = sum(max(map(abs, n)) > 0.99999 for n in normals)
            assert flat >= 0.99 * len(normals), (flat, len(normals))
            for p, c in zip(places, read(nodes[name]["attributes"]["COLOR_0"])):
                assert max(abs(c[0]), abs(c[1]), abs(c[2] - (p[0] + 4) / 4)) < 1e-4, (p, c)
    print("passed")


if __name__ == "__main__":
    main()
