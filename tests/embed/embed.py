#!/usr/bin/python3
"""Pictures that carry their scene: what is taken out makes the same picture; damaged and hostile ones are refused.

usage: embed.py WHITTLE
"""
import os
import random
import struct
import subprocess
import sys
import tempfile
import zlib

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#include "inc/a.inc"
#include "../shared/b.inc"
#include "lib.inc"
camera { location <0, 1, -5> look_at 0 angle 40 + 10 * clock }
light_source { <-5, 5, -5>, 1 }
sphere { 0, R pigment { image_map { png "tex.png" } } }
plane { y, -1 pigment { checker B, L } }
"""
FORM = b"whittle scene 1\n"


def run(folder, *words):
    environment = {**os.environ, "HOME": folder}
    environment.pop("POVINI", None)
    return subprocess.run([WHITTLE, *words], cwd=folder, capture_output=True, timeout=60, env=environment)


def chunks(data):
    at = 8
    while at < len(data):
        size = struct.unpack(">I", data[at:at + 4])[0]
        yield data[at + 4:at + 8], data[at + 8:at + 8 + size]
        at += 12 + size


def png(parts):
    out = b"\x89PNG\r\n\x1a\n"
    for kind, body in parts:
        out += struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return out


def write(path, data):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode())


def read(path):
    with open(path, "rb") as file:
        return file.read()


def records(options, files):
    out = FORM
    for line in options:
        out += b"o%d\n" % len(line) + line
    for name, data in files:
        out += b"f%d %d\n" % (len(name), len(data)) + name + data
    return out


def carrying(picture, payload):
    """The picture with other records."""
    parts = [part for part in chunks(picture) if part[0] != b"whSc"]
    parts.insert(-1, (b"whSc", payload))
    return png(parts)


def below(folder):
    return sorted(os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names)


def make_scene(top):
    write(top + "/lamp/s.pov", SCENE)
    write(top + "/lamp/inc/a.inc", "#declare R = 1.2;\n")
    write(top + "/shared/b.inc", "#declare B = rgb <0.2, 0.5, Q>;\n")
    write(top + "/lib/lib.inc", "#declare L = rgb 0.9;\n")
    write(top + "/lamp/t.pov", "#version 3.7; camera { location -3*z look_at 0 } light_source { -5*z, 1 } sphere { 0, 1 pigment { rgb x } }")
    assert run(top + "/lamp", "t.pov", "+W16", "+H16", "+Otex.png").returncode == 0


def check_round(top):
    """Each kind of scene name: what is taken out makes the picture again, file for file, and what that carries is the same."""
    words = ["+W64", "+H48", "+A0.3", "Declare=Q=0.7", "+L" + top + "/lib"]
    for number, (folder, scene, more) in enumerate([
            ("lamp", "s.pov", []), ("", "lamp/s.pov", []), ("", top + "/lamp/s.pov", ["+KFI1", "+KFF3", "--frames=2"]),
            ("lamp", "s.pov", ["Clock=0.123456789", "+FE"]), ("lamp", "s.pov", ["+FN16", "--samples=4", "--seed=7"]),
            ("lamp", "s.pov", ["--views=turntable=2"]), ("lamp", "s.pov", ["--views=cameras.json"])]):
        write(f"{top}/lamp/cameras.json", '[{"name": "a", "location": [0, 1, -4], "look_at": [0, 0, 0]}]')
        out = f"{top}/out{number}"
        os.makedirs(out)
        made = run(f"{top}/{folder}", scene, *words, *more, "--embed", f"+O{out}/")
        assert made.returncode == 0, made.stderr
        picture = below(out)[0]
        assert run(f"{top}/{folder}", scene, *words, *more, f"+O{out}/plain/", "--make-folders").returncode == 0
        opened = run(top, "open", f"{out}/{picture}", "-o", f"{top}/opened{number}")
        assert opened.returncode == 0, opened.stderr
        for text in (read(f"{top}/opened{number}/{name}") for name in below(f"{top}/opened{number}")):
            assert top.encode() not in text, "a path of this machine went along"
        ini = next(name for name in below(f"{top}/opened{number}") if name.endswith(".ini"))
        again = run(os.path.dirname(f"{top}/opened{number}/{ini}"), os.path.basename(ini), f"+O{top}/again{number}/", "--make-folders")
        assert again.returncode == 0, again.stderr
        for name in below(out):
            if name.startswith("plain/"):
                continue
            data = read(f"{out}/{name}")
            assert read(f"{top}/again{number}/{name}") == data, (number, name)
            if name.endswith(".png"):
                kept = [part for part in chunks(data) if part[0] != b"whSc"]
                assert kept == list(chunks(read(f"{out}/plain/{name}"))), "pixels are others"


def check_folder(top):
    """Files that are there are not overwritten, and no link leads out."""
    picture = top + "/out0/s.png"
    opened = top + "/opened0"
    assert run(top, "open", picture, "-o", opened).returncode == 0, "the same files are no hindrance"
    write(opened + "/lamp/s.pov", "mine")
    refused = run(top, "open", picture, "-o", opened)
    assert refused.returncode == 1 and b"lamp/s.pov" in refused.stderr and read(opened + "/lamp/s.pov") == b"mine"
    assert run(top, "open", picture, "-o", opened, "--replace").returncode == 0
    assert read(opened + "/lamp/s.pov") == SCENE.encode()
    os.makedirs(top + "/trap")
    os.makedirs(top + "/outside")
    os.symlink(top + "/outside", top + "/trap/lamp")
    assert run(top, "open", picture, "-o", top + "/trap").returncode == 1
    assert run(top, "open", picture, "-o", top + "/trap", "--replace").returncode == 1
    assert below(top + "/outside") == []
    listed = run(top, "open", picture, "--list")
    assert b"lamp/s.pov" in listed.stdout and not os.path.exists(top + "/s")


def check_hostile(top):
    picture = read(top + "/out0/s.png")
    good = [(b"s.pov", b"sphere { 0, 1 }")]
    line = b'Input_File_Name="s.pov"'
    wrong = {
        "leaves": [records([line], good + [(name, b"x")]) for name in (
            b"../x", b"/etc/x", b"a/../../x", b"./x", b"a//b", b"", b"a\x00b", b"a\nb", b"a\\b", b"x" * 300, b"a/", b"..")],
        "options": [records([option], good) for option in (
            b"Output_File_Name=/tmp/x.png", b"Pre_Scene_Command=touch x", b"--allow-commands", b"--allow-write=/", b"+O/tmp/x",
            b"--samples=4 +O/tmp/x", b'Library_Path="../x"', b'Library_Path=".","/"', b"Width=3\n+Ox", b"Create_Ini=x.ini", b"All_File=x",
            b'Library_Path=".."', b'Input_File_Name="a/../../s.pov"', b"Quality=9;x=y'", b"Include_Ini=x.ini", b'Quality="9" +Ox')],
        "damaged": [FORM, b"", records([line], good)[:-3], records([line], good + good), records([], []), b"whittle scene 2\n",
                    FORM + b"f5 99999999999999999999\nab", FORM + b"x1\n", FORM + b"f1 100\nab", FORM + b"f-1 1\nab", records([line], good) + b"f", records([line], good) + b"d2\n.."],
        "bomb": [FORM + b"f1 67108864\na" + b"\0" * 67108864 + b"f1 67108864\nb" + b"\0" * 67108864],
    }
    for kind, all_of_it in wrong.items():
        for number, text in enumerate(all_of_it):
            write(top + "/wrong.png", carrying(picture, zlib.compress(text)))
            ended = run(top, "open", "wrong.png", "-o", top + "/wrong")
            assert ended.returncode == 1 and b"wrong.png: " in ended.stderr, (kind, number, ended)
            assert not os.path.exists(top + "/wrong"), (kind, number)
    assert run(top, "open", "out0/plain/s.png").returncode == 1
    assert b"--embed" in run(top, "open", "out0/plain/s.png").stderr
    for path in ("lamp/s.pov", "nothing.png", "shared"):
        assert run(top, "open", path).returncode == 1
    assert run(top, "open").returncode == 1 and run(top, "open", "a.png", "b.png").returncode == 1
    # Bits turned and ends cut off: whole or refused, never something else.
    rng = random.Random(1)
    whole = below(top + "/opened0")
    for turn in range(40):
        bad = bytearray(picture)
        if turn % 2:
            del bad[rng.randrange(len(bad)):]
        else:
            bad[rng.randrange(len(bad))] ^= 1 << rng.randrange(8)
        write(top + "/s.png", bytes(bad))
        ended = run(top, "open", "s.png", "-o", f"{top}/bad{turn}")
        assert ended.returncode in (0, 1), ended
        if ended.returncode == 0:
            assert below(f"{top}/bad{turn}") == whole
            assert all(read(f"{top}/bad{turn}/{name}") == read(f"{top}/opened0/{name}") for name in whole)


def check_refused(top):
    for words in (["+FJ"], ["--shard=1/2"], ["+FP"]):
        ended = run(top + "/lamp", "t.pov", "+W8", "+H8", "--embed", *words)
        assert ended.returncode == 1 and b"--embed" in ended.stderr, ended
    write(top + "/lamp/long.inc", b"// " + b"x" * (65 << 20) + b"\n")
    write(top + "/lamp/long.pov", '#version 3.7; #include "long.inc" sphere { 0, 1 }')
    ended = run(top + "/lamp", "long.pov", "+W8", "+H8", "--embed")
    assert ended.returncode == 1 and b"64 MB" in ended.stderr and b"long.inc" in ended.stderr, ended


WHITTLE = os.path.abspath(sys.argv[1])
with tempfile.TemporaryDirectory() as place:
    make_scene(place)
    check_round(place)
    check_folder(place)
    check_hostile(place)
    check_refused(place)
print("pictures carry their scene")
