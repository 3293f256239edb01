#!/usr/bin/python3
"""A still in parts: joined, they have the bytes of one run; what is missing or of another picture is told.

usage: parts.py WHITTLE [NAME...]

NAMEs are those of CASES, with what a part depends on, and of FAULTS; without any all are tried. The exit status is 1 where one fails.
"""
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from place import HEAD, PLAIN, SIZE, Place, Trouble, says, tell

GLASS = "photons { target refraction on reflection on } pigment { rgbt 0.9 } interior { ior 1.4 } hollow"
AREA = HEAD % ("", "", "area_light x, y, 4, 4 jitter adaptive 1", "", "")
BLUR = HEAD % ("", "aperture 0.4 focal_point 0 blur_samples 12 variance 1/64", "", "", "")
RADIOSITY = HEAD % ("radiosity { pretrace_start 0.08 pretrace_end 0.02 count 20 recursion_limit 2 }", "", "", "", "")
PHOTONS = HEAD % ("photons { count 3000 media 10 }", "", "", GLASS,
                  "media { scattering { 1, 0.02 extinction 0.5 } samples 5 }")
MEDIA = HEAD % ("", "", "", "hollow pigment { rgbt 1 } interior { media { emission 0.6 absorption 0.2 density { bozo scale 0.3 } } }", "")

# Of each: scene, number of parts, options, and the picture's ending.
CASES = {
    "plain": (PLAIN, 7, [], ".png"),
    "more_parts_than_blocks": (PLAIN, 101, ["+BS16"], ".png"),
    "antialiasing_1": (AREA, 5, ["+A0.1", "+AM1"], ".png"),
    "antialiasing_2": (AREA, 3, ["+A0.05", "+AM2", "+R3"], ".png"),
    "focal_blur": (BLUR, 5, ["+A0.3"], ".png"),
    "radiosity": (RADIOSITY, 3, ["+A0.3"], ".png"),
    "photons": (PHOTONS, 3, [], ".png"),
    "media": (MEDIA, 5, ["+A0.3"], ".png"),
    "samples": (BLUR, 5, ["--samples=9"], ".png"),
    "seed": (AREA, 3, ["--samples=4", "--seed=11"], ".png"),
    "error": (AREA, 3, ["--error=4"], ".png"),
    "percent": (AREA, 3, ["--samples=3%"], ".png"),
    "paths": (AREA, 3, ["--integrator=path", "--samples=3"], ".png"),
    "denoise": (AREA, 3, ["--integrator=path", "--samples=3", "--denoise"], ".png"),
    "layers": (PLAIN, 5, ["+A0.3", "--aov=depth,normal,albedo,object,uv"], ".png"),
    "window": (PLAIN, 5, ["+SC11", "+EC70", "+SR0.2", "+ER0.9"], ".png"),
    "dithering": (AREA, 3, ["Dither=on", "Dither_Method=FS"], ".png"),
    "bits": (PLAIN, 3, ["+FN16", "+UA"], ".png"),
    "bmp": (AREA, 3, ["+FB", "Dither=on"], ".bmp"),
    "exr": (PLAIN, 3, ["+FE", "+UA"], ".exr"),
    "jpeg": (PLAIN, 3, ["+FJ"], ".jpg"),
    "strips": (PLAIN, 3, ["--memory=0.02", "+BS4"], ".png"),
    "clock": (PLAIN.replace("sphere { 0", "sphere { clock*x"), 3, ["+K0.5"], ".png"),
}
def joined_as_one_run(place, number, options, ending):
    place.render(*options)
    parts = place.parts(number, *options)
    tell(len(parts) == number, f"{len(parts)} parts in place of {number}")
    place.call("join", "--check", *parts)
    place.call("join", "joined" + ending, *reversed(parts))
    for end in (ending, ".layers.exr"):
        if (place.folder / ("s" + end)).exists():
            tell(place.bytes("s" + end) == place.bytes("joined" + end), f"the bytes of joined{end} are others")
    left = [p.name for p in place.folder.iterdir() if ".part" in p.name or p.name.endswith("-state")]
    tell(not left, f"left behind: {left}")


def prepared(place):
    """What --prepare leaves is as good as what each part finds; what is of another picture or damaged is not used."""
    for scene in (RADIOSITY, PHOTONS, PLAIN):
        place.write(scene)
        place.render("+A0.3")
        says(place.render("--prepare", "+A0.3"), "prepared: s.whittle-prepared")
        for path in place.folder.glob("*-part"):
            path.unlink()
        says(place.render("--shard=1/3", "+A0.2"), "s.whittle-prepared is of another picture or damaged")
        parts = place.parts(3, "+A0.3")
        place.call("join", "out.png", *parts)
        tell(place.bytes("out.png") == place.bytes("s.png"), "other bytes")
        found = place.bytes("s.whittle-prepared")
        (place.folder / "s.png").unlink()
        says(place.render("--prepare", "+C", "+A0.3"), "s.whittle-prepared exists and continue was asked for")
        tell("skipped" not in place.render("--prepare", "+C", "+A0.25"), "what is of other options is left")
        for wrong in (found[:-1], found[:20], b"", found[:50] + bytes([found[50] ^ 1]) + found[51:]):
            (place.folder / "s.whittle-prepared").write_bytes(wrong)
            part = place.bytes(parts[0])
            says(place.render("--shard=1/3", "+A0.3"), "s.whittle-prepared is of another picture or damaged")
            tell(place.bytes(parts[0]) == part, "the part is another")


def killed(place):
    """A part whose task was killed goes on from its state."""
    place.write(AREA.replace("4, 4 jitter", "17, 17 jitter"))
    place.render("+W200", "+H152")
    words = [place.program, "s.pov", *SIZE, "+W200", "+H152", "--shard=1/2", "--quiet"]
    for _ in range(20):
        task = subprocess.Popen([*words, "--state-after=0"], cwd=place.folder)
        state = place.folder / "s.1-of-2.whittle-state"
        while task.poll() is None and not (state.exists() and state.stat().st_size > 20000):
            time.sleep(0.001)
        task.kill()
        task.wait()
        if state.exists():
            break
        (place.folder / "s.1-of-2.whittle-part").unlink()
    tell(state.exists(), "no task was killed in time")
    says(place.render("+W200", "+H152", "--shard=1/2", "+C"), "blocks taken from s.1-of-2.whittle-state")
    tell(not state.exists(), "the state is left")
    tell(not list(place.folder.glob("*.part")), "the task that was killed has left a file")
    place.call("join", "out.png", *place.parts(2, "+C", "+W200", "+H152"))
    tell(place.bytes("out.png") == place.bytes("s.png"), "other bytes")


def missing(place):
    parts = place.parts(5)
    (place.folder / parts[1]).unlink()
    parts.remove(parts[1])
    says(place.call("join", "--check", *parts, status=75), "part 2 of 5 is missing")
    says(place.call("join", "out.png", *parts, status=75), "part 2 of 5 is missing")
    tell(not (place.folder / "out.png").exists(), "a picture is there")
    place.render("--shard=2/5", "+C")
    says(place.render("--shard=3/5", "+C"), "skipped")
    place.render()
    place.call("join", "out.png", *place.parts(5, "+C"))
    tell(place.bytes("out.png") == place.bytes("s.png"), "other bytes")
    says(place.call("join", "out.png", "none.whittle-part", status=75), "none.whittle-part")


def truncated(place):
    parts = place.parts(3)
    whole = place.bytes(parts[1])
    for cut in (len(whole) - 1, len(whole) // 2, 40, 0):
        (place.folder / parts[1]).write_bytes(whole[:cut])
        says(place.call("join", "out.png", *parts, status=75), f"{parts[1]}: it is cut short")
    flipped = bytearray(whole)
    flipped[len(whole) // 2] ^= 1
    (place.folder / parts[1]).write_bytes(flipped)
    says(place.call("join", "--check", *parts, status=75), f"{parts[1]}: it is cut short")
    tell("skipped" not in place.render("--shard=2/3", "+C"), "a damaged part is left as it is")
    tell(place.bytes(parts[1]) == whole, "the part is another")
    place.call("join", "out.png", *parts)


def other_picture(place):
    """A scene that was edited in between, and a part of another version: its fingerprint is another."""
    parts = place.parts(3)
    place.write(PLAIN + "// edited\n")
    says(place.render("--shard=2/3", "+C"), "is of an older scene")
    says(place.call("join", "out.png", *parts, status=1), f"{parts[1]}: it is of another scene")
    for i in (1, 3):
        says(place.render(f"--shard={i}/3", "+C"), "is of an older scene")
    place.render()
    place.call("join", "out.png", *parts)
    tell(place.bytes("out.png") == place.bytes("s.png"), "other bytes")
    (place.folder / "text.whittle-part").write_text("a text of some length\n" * 20)
    says(place.call("join", "out.png", *parts, "text.whittle-part", status=1), "it is no part of a picture")
    place.call("join", "out.jpg", *parts, status=1)


def sizes(place):
    """Parts of two sizes are of two pictures."""
    parts = place.parts(3)
    place.render("--shard=2/3", "+W60", "+H44")
    says(place.call("join", "out.png", *parts, status=1), f"{parts[1]}: it is of another scene")
    tell(not (place.folder / "out.png").exists(), "a picture of two sizes")


def absent_include(place):
    """A node that lacks an include file says where it is asked for; the part is what is missing, and may come."""
    place.write('#include "shared.inc"\n' + PLAIN)
    (place.folder / "shared.inc").write_text("#declare Shared = 1;\n")
    parts = place.parts(2)
    (place.folder / parts[1]).unlink()
    (place.folder / "shared.inc").unlink()
    says(place.render("--shard=2/2", status=1), "s.pov:1:10: error: cannot find the include file 'shared.inc'")
    says(place.call("join", "out.png", *parts, status=75), parts[1])
    (place.folder / "shared.inc").write_text("#declare Shared = 1;\n")
    place.render("--shard=2/2")
    place.render()
    place.call("join", "out.png", *parts)
    tell(place.bytes("out.png") == place.bytes("s.png"), "other bytes")


def clocks(place):
    """Machines whose clocks are an hour apart: no decision goes by a file's time."""
    parts = place.parts(3)
    place.render()
    for name, hours in ((parts[0], 1), (parts[2], -1), ("s.pov", 2)):
        then = time.time() + 3600 * hours
        os.utime(place.folder / name, (then, then))
    for i in (1, 2, 3):
        says(place.render(f"--shard={i}/3", "+C"), "skipped")
    says(place.render("+C"), "skipped")
    place.call("join", "out.png", *parts)
    tell(place.bytes("out.png") == place.bytes("s.png"), "other bytes")


def unreadable(place):
    """A file that is there and fails while it is read, as on a disk that is away: another try may go well."""
    broken = "/proc/self/mem"
    for text in (f'#include "{broken}"', f'mesh {{ file "{broken}" }}', f'sphere {{ 0, 1 pigment {{ image_map {{ png "{broken}" }} }} }}',
                 f'box {{ 0, 1 pigment {{ density_file df3 "{broken}" }} }}', f'height_field {{ png "{broken}" }}'):
        place.write(text + "\n" + PLAIN)
        said = place.render("--shard=1/2", status=75)
        says(said, "Input/output error")
        says(said, "s.pov:1:")
    for read in ("#read (F, A)", "#macro M() #read (F, A) #end M()", "#for (I, 1, 9) #read (F, A, B, C) #end"):
        place.write(f'#declare A = 0; #declare B = 0; #declare C = 0;\n#fopen F "{broken}" read\n{read}\n' + PLAIN)
        says(place.render("--shard=1/2", status=75), f"cannot read '{broken}': Input/output error")
    said = subprocess.run([place.program, f"+I{broken}", "+W8", "+H6", "+Ox.png"], cwd=place.folder, capture_output=True, text=True)
    tell(said.returncode == 75 and "Input/output error" in said.stderr, f"a scene that fails while it is read: {said.stderr}")


def twice_at_once(place):
    words = [place.program, "s.pov", *SIZE, "--shard=1/2", "--state-after=0", "--quiet"]
    both = [subprocess.Popen(words, cwd=place.folder) for _ in range(4)]
    tell([process.wait() for process in both] == [0] * 4, "a part fails beside itself")
    place.render("--shard=2/2")
    place.render()
    place.call("join", "out.png", "s.1-of-2.whittle-part", "s.2-of-2.whittle-part")
    tell(place.bytes("out.png") == place.bytes("s.png"), "other bytes")


def read_only(place):
    parts = place.parts(2)
    if os.geteuid() != 0:
        (place.folder / "closed").mkdir(mode=0o555)
        place.call("join", "closed/out.png", *parts, status=1)
        place.render("+Oclosed/x.png", "--shard=1/2", status=1)
    says(place.call("join", "/proc/out.png", *parts, status=1), "/proc/out.png")  # where root writes nothing either
    place.render("+O/proc/x.png", "--shard=1/2", status=1)
    place.call("join", "nowhere/out.png", *parts, status=1)


def refused(place):
    for words in (["+O-"], ["--faithful", "+WT1"], ["--aov=time"], ["-F"]):
        place.render("--shard=1/2", *words, status=1)
    for wrong in ("0/3", "4/3", "3", "1/0", "a/b", "1/2/3", "-1/3"):
        says(place.render(f"--shard={wrong}", status=1), "--shard wants")
    says(place.render("--shard=1/2", "--time=0.05"), "not that of one run")
    place.call("join", "out.png", status=1)
    place.call("join", status=1)


def frames(place):
    """Parts of a frame have its number, and states of parts are taken up."""
    place.write(PLAIN.replace("sphere { 0", "sphere { clock*x"))
    place.render("+KFF2")
    place.parts(3, "+KFF2")
    for frame in "12":
        parts = [f"s{frame}.{i}-of-3.whittle-part" for i in (1, 2, 3)]
        place.call("join", f"out{frame}.png", *parts)
        tell(place.bytes(f"out{frame}.png") == place.bytes(f"s{frame}.png"), "other bytes")


def older_pictures(place):
    """+C renders a picture of an older scene anew, and leaves the others."""
    for ending, words in ((".png", ["+FN"]), (".exr", ["+FE"])):
        place.write(PLAIN)
        place.render(*words)
        says(place.render("+C", "+WT1", *words), "skipped")
        says(place.render("+C", "+A0.3", *words), "is of an older scene")
        place.write(PLAIN + "#include \"more.inc\"\n")
        (place.folder / "more.inc").write_text("sphere { x, 0.3 }\n")
        says(place.render("+C", *words), "is of an older scene")
        says(place.render("+C", *words), "skipped")
        first = place.bytes("s" + ending)
        (place.folder / "more.inc").write_text("sphere { x, 0.5 }\n")
        says(place.render("+C", *words), "is of an older scene")
        tell(place.bytes("s" + ending) != first, "the picture is the older one")
    place.write(PLAIN)
    place.render("+Fp", "+Ob")
    says(place.render("+Fp", "+Ob", "+C", "+A"), "skipped")  # which says nothing of itself


def edited_while_read(place):
    """A file that is edited between its reading and the picture: +C tells that the picture is of what stood there before."""
    slow = PLAIN + '#include "more.inc"\n#fopen In "data.txt" read\n#read (In, A)\n#debug "it is read\\n"\n' \
                   '#declare I = 0;\n#while (I < 300000)\n#declare I = I + 1;\n#end\nsphere { x, A pigment { rgb Some } }\n'

    def status_of_edited(edited, old, new, *words):
        running = subprocess.Popen([place.program, "s.pov", *SIZE, *words], cwd=place.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        for line in running.stderr:
            if "it is read" in line:
                break
        file = place.folder / edited
        file.write_text(file.read_text().replace(old, new))
        running.communicate()
        return running.returncode

    for edited, old, new in (("s.pov", "0.9", "0.8"), ("more.inc", "1", "0.5"), ("data.txt", "0.3", "0.4")):
        place.write(slow)
        (place.folder / "more.inc").write_text("#declare Some = 1;\n")
        (place.folder / "data.txt").write_text("0.3\n")
        place.render()
        first = place.bytes("s.png")
        (place.folder / "s.png").unlink()
        status = status_of_edited(edited, old, new)
        tell(status == 0 and place.bytes("s.png") == first, f"{edited}: the picture is not of what was read")
        says(place.render("+C"), "is of an older scene")
        tell(place.bytes("s.png") != first, f"{edited}: the picture is the older one")
    status = status_of_edited("s.pov", "0.9", "0.8", "Shutter=0.5", "Motion_Samples=2")  # which reads the scene twice
    tell(status == 75, f"status {status} where the moments of a picture have two scenes")


def fingerprints(place):
    """The same in the picture, in a part's heading and in --json, wherever and by however many threads."""
    def of(*words, at=place):
        at.render("--json", "j.json", *words)
        return re.search('"fingerprint": *"([0-9a-f]{16})"', (at.folder / "j.json").read_text())[1]
    one = of()
    picture = place.bytes("s.png")
    at = picture.index(b"tEXtWhittleFingerprint\0")
    tell(picture[at + 23:at + 39].decode() == one, "the picture has another")
    tell(struct.unpack(">I", picture[at + 39:at + 43])[0] == zlib.crc32(picture[at:at + 39]), "the text's sum is wrong")
    tell(of("--shard=2/3") == one, "a part has another")
    (place.folder / "sub").mkdir()
    other = Place(place.program, place.folder / "sub", name="other name")
    tell(of("+WT1", at=other) == one, "a name or a thread counts")
    seen = {one}
    for words in (["+A"], ["+W95"], ["+K1"], ["Declare=a=1"], ["+FN16"], ["+UA"], ["+Q5"], ["--samples=2"],
                  ["--samples=2", "--seed=3"], ["File_Gamma=1.8"], ["Dither=on"], ["+A", "+BS16"]):
        seen.add(of(*words))
    tell(len(seen) == 13, "options do not count")


def names(place):
    name = "a b \u00e4\u6f22 [1]"
    other = Place(place.program, place.folder, name=name)
    other.render()
    parts = other.parts(3)
    other.call("join", "x \u00fc.png", *parts)
    tell(other.bytes("x \u00fc.png") == other.bytes(name + ".png"), "other bytes")


FAULTS = {f.__name__: f for f in (prepared, killed, missing, truncated, other_picture, sizes, absent_include, clocks, unreadable, twice_at_once,
                                  read_only, refused, frames, older_pictures, edited_while_read,
                                  fingerprints, names)}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, chosen = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2:] or [*CASES, *FAULTS]
    failed = 0
    for name in chosen:
        with tempfile.TemporaryDirectory() as folder:
            try:
                if name in CASES:
                    scene, *rest = CASES[name]
                    joined_as_one_run(Place(program, folder, scene), *rest)
                else:
                    FAULTS[name](Place(program, folder))
                print(f"{name}: as one run" if name in CASES else f"{name}: as told", flush=True)
            except Trouble as trouble:
                failed += 1
                print(f"{name}: {trouble}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
