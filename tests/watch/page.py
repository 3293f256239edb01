"""Drives the page of `whittle watch` in a real browser: save, error, recovery, slider, camera, cut, comparison, pick.

usage: page.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no browser
"""
import math
import os
import re
import shutil
import subprocess
import sys
import time

import browser
from watched import NO_BROWSER, Seen, Watched, asked, beyond

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Height) #declare Height = 1; #end
#include "part.inc"
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.1, 0.2, 0.4> }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.4 } }
Part(Height)
sphere { <1.8, 0.6, 0>, 0.6 pigment { rgb <0.2, 0.8, 0.3> } finish { phong 0.8 reflection 0.2 } translate x*clock }
"""
PART = """#macro Part(H) box { <-1, 0, -0.5>, <0.5, H, 0.5> pigment { rgb <%s> } } #end
"""


SIZE = (160, 120)


def check_saves(seen):
    """Returns the colour of the box."""
    watched = seen.watched
    red = seen.pixel(70, 55)
    assert red[0] > 2 * red[1], red
    seen.shot("first")

    print("save of an included file, by renaming")
    seen.after(lambda: watched.replace(watched.path("part.inc"), PART % "0.1, 0.2, 0.9"))
    blue = seen.pixel(70, 55)
    assert blue[2] > 2 * blue[0], blue

    print("the same bytes as a render")
    assert seen.samples() == watched.rendered(*SIZE)
    return red, blue


def check_messages(seen, red, blue):
    page, watched, part = seen.page, seen.watched, seen.watched.path("part.inc")
    print("error: message, place, the last good picture")
    watched.write(part, "#macro Part(H)\nbox { <-1, 0, -0.5>, <0.5, H 0.5> pigmnt { rgb 1 } }\n#end\n")
    page.wait("state.wrong")
    text = page.ask("byId('messages').innerText")
    assert "part.inc:2:" in text and "^" in text, text
    assert seen.pixel(70, 55) == blue
    assert page.ask("byId('lamp').className") == "wrong"
    page.ask("document.querySelector('.message .place').click()")
    assert page.ask("state.copied").endswith("part.inc:2"), page.ask("state.copied")
    seen.shot("error")

    print("a file that is missing, and its coming")
    os.rename(part, part + ".away")
    watched.write(watched.scene, SCENE + "// again\n")
    page.wait("byId('messages').innerText.includes('part.inc')")
    seen.after(lambda: watched.write(part, PART % "0.9, 0.2, 0.1"), "!state.wrong")
    assert seen.pixel(70, 55) == red, (seen.pixel(70, 55), red)

    print("warning")
    seen.after(lambda: watched.write(watched.scene, SCENE + '#warning "look here"\n'))
    assert "look here" in page.ask("byId('messages').innerText")
    seen.after(lambda: watched.write(watched.scene, SCENE))


def check_before(seen):
    print("comparison with the save before")
    page, watched = seen.page, seen.watched
    before = seen.samples()
    seen.after(lambda: watched.write(watched.path("part.inc"), PART % "0.86, 0.2, 0.1"))  # differences of 3 and of 4: the second are told
    now = seen.samples()
    seen.choose("compare", "before")
    seen.choose("wipe", 1, "input")
    assert seen.samples("other.getContext('2d')") == before
    seen.choose("compare-how", "difference")
    count, worst = beyond(now, before)
    assert 0 < count < sum(a != b for a, b in zip(now[::3], before[::3]))
    assert page.ask("byId('compare-note').textContent") == f"{count} pixels differ by more than 3, the worst by {worst}, of 255"
    seen.shot("difference")
    seen.choose("compare", "")


def check_sliders(seen):
    print("sliders of the clock and of a constant")
    page, watched = seen.page, seen.watched
    assert page.ask("[...byId('values').children].map(r => r.dataset.name).join()") == "clock,Height"
    move = "(() => {{ const r = document.querySelector('[data-name={0}] input[type=range]'); r.value = {1}; r.oninput(); }})()"
    still = seen.samples()
    seen.after(lambda: page.ask(move.format("Height", 2)))
    grown = seen.samples()
    assert grown != still and grown == watched.rendered(*SIZE, "Declare=Height=2")
    seen.after(lambda: page.ask(move.format("clock", 0.5)))
    both = seen.samples()
    assert both != grown and both == watched.rendered(*SIZE, "Declare=Height=2", "+K0.5")
    seen.shot("sliders")
    seen.after(lambda: page.ask("document.querySelector('[data-name=clock] button').click()"))
    assert seen.samples() == grown
    seen.after(lambda: page.ask("document.querySelector('[data-name=Height] button').click()"))
    assert seen.samples() == still


def vectors(camera):
    """location and direction of a camera's text."""
    return [[float(n) for n in re.search(name + r" <(.*?)>", camera)[1].split(",")] for name in ("location", "direction")]


def check_camera(seen):
    print("camera by mouse, copied as text")
    page, watched = seen.page, seen.watched
    text = lambda: page.ask("byId('camera').textContent")
    page.ask("window.last = {}; on('controls', c => { last = c; }); document.querySelector('[data-tool=orbit]').click()")
    # The server has heard of it, and the picture is whole.
    there = lambda test: page.wait(f"last.orbit && ({test}) && state.doneGeneration === state.next.g && byId('lamp').className === 'done'")
    before, whole = text(), seen.samples()
    x, y = seen.on_screen(80, 60)
    # The middle of the picture shows the box's front at (0, 0.625, -0.5): what the camera comes nearer to, and turns about.
    pivot, near = (0, 0.625, -0.5), math.exp(-0.5)
    seen.after(lambda: page.mouse("mouseWheel", x, y, button="none", deltaX=0, deltaY=-200))
    there(f"Math.abs(last.orbit.dolly - {near}) < 1e-9")
    (eye, ahead) = vectors(text())
    assert all(abs(e - p - near * (o - p)) < 0.02 for e, p, o in zip(eye, pivot, (0, 2, -6))), eye
    assert ahead == vectors(before)[1]
    shown = page.ask("view.scale * picture.width")
    page.drag(x, y, x + 120, y + 30)
    there(f"Math.abs(last.orbit.yaw - {180 * 120 / shown}) < {180 / shown}")
    (turned_eye, turned) = vectors(text())
    assert abs(math.dist(turned_eye, pivot) - math.dist(eye, pivot)) < 0.02 and math.dist(turned_eye, eye) > 0.5, turned_eye
    page.drag(x, y, x + 40, y, modifiers=8)  # with shift: aside, looking the same way
    there(f"Math.abs(last.orbit.right + {40 / shown}) < {1 / shown}")
    (shifted_eye, shifted) = vectors(text())
    aside = [a - b for a, b in zip(shifted_eye, turned_eye)]
    assert shifted == turned and math.hypot(*aside) > 0.05 and abs(sum(a * d for a, d in zip(aside, turned))) < 1e-6, (aside, turned)

    page.ask("byId('copy-camera').click()")
    copied = page.wait("state.copied.startsWith('camera') && state.copied")
    assert copied == text() != before
    seen.shot("camera")
    # The block in the scene's place gives the picture that is seen, but for the digits that text has.
    moved = seen.samples()
    seen.after(lambda: page.ask("byId('reset-camera').click()"))
    assert text() == before and seen.samples() == whole
    replaced = SCENE.replace("camera { location <0, 2, -6> look_at <0, 0.5, 0> }", copied)
    assert replaced != SCENE
    seen.after(lambda: watched.write(watched.scene, replaced))
    assert beyond(moved, seen.samples())[0] < 0.005 * SIZE[0] * SIZE[1]
    seen.after(lambda: watched.write(watched.scene, SCENE))
    page.ask("document.querySelector('[data-tool=pan]').click()")


def check_cut(seen):
    print("cutting plane")
    whole = seen.samples()
    seen.after(lambda: seen.choose("cut-axis", "0,1,0"))  # all above y = 0 away
    seen.after(lambda: seen.choose("cut-offset", 0.3))
    seen.shot("cut")
    cut = seen.samples()
    # The box cut at 0.3 is the box of that height; the picture's left half has nothing of the sphere.
    low = seen.watched.rendered(*SIZE, "Declare=Height=0.3")
    left = [k for k in range(len(whole)) if k // 3 % SIZE[0] < SIZE[0] // 2]
    assert [cut[k] for k in left] == [low[k] for k in left] != [whole[k] for k in left]
    seen.after(lambda: seen.choose("cut-axis", ""))
    assert seen.samples() == whole


def check_zoom(seen):
    print("zoom and pan")
    page = seen.page
    x, y = seen.on_screen(80, 60)
    scale = page.ask("view.scale")
    page.mouse("mouseWheel", x, y, button="none", deltaX=0, deltaY=-200)
    page.wait(f"view.scale > {scale}")
    left = page.ask("view.x")
    page.drag(x, y, x + 40, y)
    assert abs(page.ask("view.x") - left - 40) < 1.5


def check_pick(seen):
    print("pick")
    page, watched = seen.page, seen.watched
    x, y = seen.on_screen(70, 55)
    page.click(x, y)
    page.wait("state.picked")
    text = page.ask("byId('pixel').innerText")
    assert "box" in text and "part.inc:1" in text, text
    assert page.ask("[state.picked.x, state.picked.y, ...state.picked.shown]") == [70, 55, *seen.pixel(70, 55)[:3]]
    printed = subprocess.run([watched.program, "pixel", watched.scene, "70,55", "+W160", "+H120"], check=True, capture_output=True, text=True,
                             cwd=watched.folder).stdout
    assert printed == page.ask("state.picked.text"), printed
    seen.shot("pick")


def check_povray(seen):
    print("POV-Ray beside it")
    seen.choose("compare", "povray")
    seen.page.wait("!!compared.povray", 60)
    assert seen.page.ask("compared.povray.width") == SIZE[0]
    seen.shot("povray")


def check_endless(seen):
    print("a scene that never ends, and a save that ends it")
    watched = seen.watched
    watched.write(watched.scene, "#while (1) #end\n")
    time.sleep(0.3)
    started = time.monotonic()
    seen.after(lambda: watched.write(watched.scene, SCENE), "!state.wrong", 10)
    assert time.monotonic() - started < 5


def run(program, shots):
    files = {"scene.pov": SCENE, "part.inc": PART % "0.9, 0.2, 0.1"}
    with Watched(program, files, ["+W160", "+H120"], ["part.inc.away"]) as watched, browser.Browser() as page:
        seen = Seen(page, watched, shots)
        red, blue = check_saves(seen)
        check_messages(seen, red, blue)
        check_before(seen)
        check_sliders(seen)
        check_camera(seen)
        check_cut(seen)
        check_zoom(seen)
        check_pick(seen)
        if shutil.which("povray"):
            check_povray(seen)
        check_endless(seen)
        assert not page.complaints(), page.complaints()
    print("passed")


def main():
    arguments = asked()
    if not arguments:
        return NO_BROWSER
    run(os.path.abspath(arguments.whittle), arguments.shots)
    return 0


if __name__ == "__main__":
    sys.exit(main())
