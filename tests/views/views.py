#!/usr/bin/python3
"""Many views of one scene: each has the bytes of a scene with that camera in its text.

usage: views.py WHITTLE
"""
import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib

# Fog, glass that a camera may stand in, photons, radiosity, media: what may depend on where the camera stands.
SCENES = {
    "plain": """#version 3.7; global_settings { assumed_gamma 1 } CAMERA light_source { <-5, 8, -6>, 1 }
        sphere { <0, 0.5, 0>, 1 pigment { granite } finish { reflection 0.3 } } plane { y, -1 pigment { checker rgb 0.2, rgb 0.9 } }
        fog { distance 30 color rgb 0.7 }""",
    "glass": """#version 3.7; global_settings { assumed_gamma 1 } CAMERA light_source { <-5, 8, -6>, 1 }
        sphere { 0, 7 pigment { rgbt 0.9 } interior { ior 1.2 fade_distance 5 fade_power 1 } }
        sphere { <0, 0, 0>, 1 pigment { rgb <1, 0.5, 0.2> } } plane { y, -1 pigment { checker rgb 0.2, rgb 0.9 } }""",
    "light": """#version 3.7; global_settings { assumed_gamma 1 radiosity { pretrace_start 0.1 pretrace_end 0.05 count 20 }
        photons { count 2000 } } CAMERA light_source { <-5, 8, -6>, 1 photons { refraction on } }
        sphere { <0, 1, 0>, 1 pigment { rgbt 0.9 } interior { ior 1.5 } photons { target refraction on } }
        plane { y, -1 pigment { rgb 0.8 } } box { <2, -1, 0>, <3, 2, 1> pigment { rgb <0.9, 0.2, 0.1> } }""",
    "newer": """#version 3.8; global_settings { assumed_gamma 1 } CAMERA light_source { <-5, 8, -6>, 1 }
        sphere { <0, 0.5, 0>, 1 pigment { granite } } plane { y, -1 pigment { checker rgb 0.2, rgb 0.9 } }""",
}
CAMERA = "camera { location <0, 2, -6> look_at <0, 0.5, 0> angle 40 right x*4/3 }"
SIZE = ["+W32", "+H24"]
FILE = [
    {"name": "left", "location": [-3, 2, -5], "look_at": [0, 0.5, 0], "angle": 40},
    {"location": [0, 1, -6], "look_at": [0, 0, 0], "sky": [0.1, 1, 0], "right": [-1.2, 0, 0], "up": [0, 0.9, 0]},
    {"type": "orthographic", "location": [0, 5, -6], "look_at": [0, 0, 0], "angle": 30},
    {"name": "turned", "matrix": [[1, 0, 0, 0.5], [0, 1, 0, 1], [0, 0, -1, -5], [0, 0, 0, 1]], "angle": 50},
    {"name": "lens", "location": [0, 1, -5], "look_at": [0, 0, 0], "aperture": 0.4, "blur_samples": 7, "focal_point": [0, 0, 0]},
]
# The same by hand: what a view leaves out has POV-Ray's usual value, but for square pixels.
BY_HAND = [
    "camera { location <-3, 2, -5> right x*32/24 look_at <0, 0.5, 0> angle 40 }",
    "camera { location <0, 1, -6> sky <0.1, 1, 0> right <-1.2, 0, 0> up <0, 0.9, 0> look_at 0 }",
    "camera { orthographic location <0, 5, -6> right x*32/24 angle 30 look_at 0 }",
    "camera { location <0.5, 1, -5> direction z right x*32/24 up y angle 50 }",
    "camera { location <0, 1, -5> right x*32/24 look_at 0 aperture 0.4 blur_samples 7 focal_point 0 }",
]


def run(folder, *words, status=0):
    environment = {**os.environ, "HOME": folder}
    environment.pop("POVINI", None)
    ended = subprocess.run([WHITTLE, *words], cwd=folder, capture_output=True, timeout=60, env=environment)
    assert ended.returncode == status, (words, ended)
    return ended


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def rows(path):
    """Width, height and rows of bytes of a PNG of 8 bits."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", body[:10])
            assert (bits, color) == (8, 2)
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    raw, out, above = zlib.decompress(packed), [], bytearray(3 * width)
    for y in range(height):
        kind, line = raw[y * (3 * width + 1)], bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
        for i in range(3 * width):
            a, b, c = (line[i - 3] if i >= 3 else 0), above[i], (above[i - 3] if i >= 3 else 0)
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[i] = (line[i] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        out.append(bytes(line))
        above = line
    return width, height, out


def tile(sheet, column, row, width, height):
    return [line[3 * width * column:3 * width * (column + 1)] for line in sheet[2][height * row:height * (row + 1)]]


def cameras_of(folder, views, *words):
    """The statements that the program says it used."""
    text = run(folder, "s.pov", *SIZE, *words, f"--views={views}", "--dump=views").stdout.decode()
    return re.findall(r"^camera \{.*?^\}", text, re.M | re.S)


def check_file(folder, scene, words):
    """Pictures of a file of cameras against scenes with the camera in their text, by hand and as the program tells it."""
    write(folder + "/s.pov", scene.replace("CAMERA", CAMERA))
    write(folder + "/cameras.json", json.dumps({"views": FILE}))
    run(folder, "s.pov", *SIZE, *words, "--views=cameras.json")
    told = cameras_of(folder, "cameras.json", *words)
    for number, (view, by_hand) in enumerate(zip(FILE, BY_HAND), 1):
        picture = rows(f"{folder}/s.{view.get('name', f'{number:02}')}.png")
        for camera in (by_hand, told[number - 1]):
            write(folder + "/alone.pov", scene.replace("CAMERA", camera))
            run(folder, "alone.pov", *SIZE, *words)
            assert rows(folder + "/alone.png") == picture, (number, camera)


def check_words(folder, scene, words):
    write(folder + "/s.pov", scene.replace("CAMERA", CAMERA))
    run(folder, "s.pov", *SIZE, *words)
    alone = rows(folder + "/s.png")
    run(folder, "s.pov", *SIZE, *words, "--views=quilt=3x2,cone=30")
    sheet = rows(folder + "/s_qs3x2a1.33333.png")
    assert sheet[:2] == (96, 48)
    quilt = cameras_of(folder, "quilt=3x2,cone=30", *words)
    run(folder, "s.pov", *SIZE, *words, "--views=stereo", "+Ostereo.png")
    pair = rows(folder + "/stereo.png")
    eyes = cameras_of(folder, "stereo", *words)
    run(folder, "s.pov", *SIZE, *words, "--views=turntable=3")
    assert rows(folder + "/s.01.png") == alone
    turns = cameras_of(folder, "turntable=3", *words)
    places = [(camera, tile(sheet, i % 3, 1 - i // 3, 32, 24)) for i, camera in enumerate(quilt)]
    places += [(camera, tile(pair, i, 0, 32, 24)) for i, camera in enumerate(eyes)]
    places += [(camera, rows(f"{folder}/s.{i:02}.png")[2]) for i, camera in enumerate(turns, 1)]
    for camera, pixels in places:
        write(folder + "/alone.pov", scene.replace("CAMERA", camera))
        run(folder, "alone.pov", *SIZE, *words)
        assert rows(folder + "/alone.png")[2] == pixels, camera


def check_geometry(folder):
    """Where the eyes of a quilt and of a turntable stand, and that the frame in the distance stays."""
    write(folder + "/s.pov", SCENES["plain"].replace("CAMERA", "camera { location <0, 0, -5> direction z right x*4/3 up y }"))

    def vector(camera, name):
        return [float(x) for x in re.search(rf"{name} <([^>]*)>", camera).group(1).split(",")]
    quilt = cameras_of(folder, "quilt=5x1,cone=90,distance=5")
    assert [round(vector(c, "location")[0], 9) for c in quilt] == [-5, -2.5, 0, 2.5, 5]
    for camera in quilt:  # the point in the distance is in the middle of each
        place, ahead = vector(camera, "location"), vector(camera, "direction")
        assert all(abs(place[i] + 5 * ahead[i]) < 1e-12 for i in range(3)), camera
    turns = cameras_of(folder, "turntable=4,distance=5")
    for i, camera in enumerate(turns):  # as rotate y*90 turns
        place = vector(camera, "location")
        assert math.dist(place, [(0, 0, -5), (-5, 0, 0), (0, 0, 5), (5, 0, 0)][i]) < 1e-12, camera


def check_together(folder):
    """With +C, animation, layers, a sheet of a file, standard output, --embed's fingerprint, shutter."""
    write(folder + "/s.pov", SCENES["plain"].replace("CAMERA", CAMERA))
    write(folder + "/sheet.json", json.dumps({"views": FILE[:3], "sheet": [2, 2]}))
    run(folder, "s.pov", *SIZE, "--views=sheet.json", "+Osheet.png")
    sheet = rows(folder + "/sheet.png")
    run(folder, "s.pov", *SIZE, "--views=cameras.json")
    for number, name in enumerate(("left", "02", "03")):
        assert tile(sheet, number % 2, number // 2, 32, 24) == rows(f"{folder}/s.{name}.png")[2]
    assert tile(sheet, 1, 1, 32, 24) == [bytes(96)] * 24
    again = run(folder, "s.pov", *SIZE, "--views=cameras.json", "+C", "--json=-")
    assert [frame.get("skipped") for frame in json.loads(again.stdout)["frames"]][1:] == [True] * 5, again.stdout
    os.remove(folder + "/s.left.png")
    again = run(folder, "s.pov", *SIZE, "--views=cameras.json", "+C")
    assert os.path.exists(folder + "/s.left.png")
    write(folder + "/other.json", json.dumps([FILE[0] | {"angle": 41}]))
    note = run(folder, "s.pov", *SIZE, "--views=other.json", "+C")
    assert b"rendered anew" in note.stderr
    run(folder, "s.pov", *SIZE, "--views=turntable=2", "+KFI1", "+KFF2", "+Of.png")
    assert all(os.path.exists(f"{folder}/f{frame}.0{view}.png") for frame in (1, 2) for view in (1, 2))
    run(folder, "s.pov", *SIZE, "--views=turntable=2", "--aov=depth", "+Ol.png")
    assert all(os.path.exists(f"{folder}/l.0{view}.layers.exr") for view in (1, 2))
    made = run(folder, "s.pov", *SIZE, "--views=quilt=2x1", "+O-").stdout
    assert made.startswith(b"\x89PNG")
    journal = json.loads(run(folder, "s.pov", *SIZE, "--views=turntable=2", "--json=-").stdout)
    assert [view["picture"] for view in journal["frames"][0]["views"]] == ["s.01.png", "s.02.png"]
    assert len({view["fingerprint"] for view in journal["frames"][0]["views"]}) == 2


def check_refused(folder):
    write(folder + "/s.pov", SCENES["plain"].replace("CAMERA", CAMERA))
    for words in (["--shard=1/2"], ["--prepare"], ["--preview=p"], ["Radiosity_To_File=on"], ["+O-"], ["--aov=depth", "--views=stereo"]):
        ended = run(folder, "s.pov", *SIZE, "--views=turntable=2", *words, status=1)
        assert b"--views" in ended.stderr or b"sheet of views" in ended.stderr, ended
    for wrong in ("quilt=8", "quilt=0x6", "quilt=8x6x2", "quilt=1x1", "stereo=3", "turntable=0", "turntable=x", "quilt=2x2,cone=0", "stereo,cone=3",
                  "turntable=3,distance=-1", "nothing.json"):
        assert run(folder, "s.pov", *SIZE, f"--views={wrong}", status=1).stderr, wrong
    for text, part in (("{", b"wrong.json:1:2"), ("[]", b"1 to"), ("{}", b"views"), ('[{"locatoin": [0, 0, 0]}]', b"location"), ("[3]", b"view 1"),
                       ('[{"location": [0, 0]}]', b"three numbers"), ('[{"name": "../x"}]', b"name"), ('[{"name": "a"}, {"name": "a"}]', b"view 2"),
                       ('[{"matrix": [1]}]', b"matrix"), ('[{"angle": 200}]', b"180"), ('[{"type": "mesh"}]', b"type"), ("[" * 40, b"wrong.json"),
                       ('{"views": [{}, {}], "sheet": [1, 1]}', b"sheet"), ('[{"location": [0, 0, 0], "look_at": [0, 0, 0]}]', b"same point")):
        write(folder + "/wrong.json", text)
        ended = run(folder, "s.pov", *SIZE, "--views=wrong.json", status=1)
        assert part in ended.stderr, (text, ended)
    for camera in ("camera { location -5*z look_at 0 normal { bumps 0.1 } }", "camera { spherical location -5*z look_at 0 }"):
        write(folder + "/s.pov", SCENES["plain"].replace("CAMERA", camera))
        assert b"--views" in run(folder, "s.pov", *SIZE, "--views=stereo", status=1).stderr, camera
    write(folder + "/s.pov", SCENES["plain"].replace("CAMERA", CAMERA))
    assert b"--views" in run(folder, "s.pov", "--dump=views", status=1).stderr


WHITTLE = os.path.abspath(sys.argv[1])
with tempfile.TemporaryDirectory() as place:
    for name, text in SCENES.items():
        check_file(place, text, [])
        check_words(place, text, [])
    check_file(place, SCENES["plain"], ["+A0.1"])
    check_words(place, SCENES["plain"], ["--samples=2"])
    check_words(place, SCENES["glass"], ["--integrator=path", "--samples=2"])
    check_geometry(place)
    check_together(place)
    check_refused(place)
print("each view has the bytes of its camera alone")
