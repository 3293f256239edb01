"""What the page of `whittle watch` says of a picture that is older than the text, and where there is none yet, in a real browser.

usage: marks.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no browser
"""
import os
import sys
import time

import browser
from watched import NO_BROWSER, Seen, Watched, asked

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6> rgb 1 }
background { rgb 0.7 }
plane { y, 0 pigment { rgb 0.7 } }
sphere { y, 1 pigment { rgb <%s> } }
"""
RED, GREEN, BLUE = (SCENE % c for c in ("0.9, 0.1, 0.1", "0.1, 0.9, 0.1", "0.1, 0.1, 0.9"))
WRONG = "#version 3.7;\nsphere { y, 1 pigmnt { rgb 1 } }\n"
ENDLESS = "#version 3.7;\n#while (1) #end\n"
SIZE = (640, 480)
MIDDLE = (320, 200)  # a pixel of the sphere

AGE = "byId('age').textContent"
# After the page's own listener: how each block of a picture leaves the mark, with its share of the pass.
RECORD = """window.told = []; on('block', b => told.push({ g: b.g, p: b.p, share: b.w * b.h / (b.W * b.H), mark: standing()[1] })); true"""


def clock(milliseconds):
    return time.strftime("%H:%M:%S", time.localtime(milliseconds / 1e3))


def marked(seen):
    """Where the mark is, checked to be the picture's place and to dim its edge; None: there is none."""
    if seen.page.ask("byId('edge').hidden"):
        assert seen.page.ask(AGE) == ""
        return None
    edge, picture = seen.box("#edge"), seen.box("#picture")
    assert all(abs(e - p) < 1.5 for e, p in zip(edge, picture)), (edge, picture)
    left, top = round(picture[0]), round(picture[3]) - 60  # the lower left corner is plain floor
    rows = seen.screen((left, top, 60, 1))[0]
    assert sum(rows[6]) < 0.7 * sum(rows[59]) and sum(rows[6]) < sum(rows[20]) < sum(rows[59]), rows
    return edge


def check_first(program, shots):
    print("a first text that is wrong")
    with Watched(program, {"scene.pov": WRONG}, [f"+W{SIZE[0]}", f"+H{SIZE[1]}"]) as watched, browser.Browser() as page:
        seen = Seen(page, watched, shots, "state.wrong")
        text = page.ask("byId('empty').innerText")
        assert text.startswith("No picture yet: the text has an error\n"), text
        assert "scene.pov:2:15" in text and "pigmnt" in text and "\n" + " " * 14 + "^" in text, text
        field, said = seen.box("#stage"), seen.box("#empty")
        assert field[0] < said[0] < said[2] < field[2] and field[1] < said[1] < said[3] < field[3], (field, said)
        assert page.ask("[byId('file').textContent, document.title, picture.ariaLabel].join()") == "scene.pov,scene.pov - whittle,no picture yet"
        assert marked(seen) is None
        page.ask("document.querySelector('#empty .place').click()")
        assert page.ask("state.copied") == watched.scene + ":2"
        assert page.ask("byId('note').textContent") == f"copied {watched.scene}:2"
        for width in (1280, 390):
            for scheme in ("dark", "light"):
                page.size(width, 800)
                page.scheme(scheme)
                seen.shot(f"first-{width}-{scheme}")

        print("a first text that is long in reading")
        watched.write(watched.scene, ENDLESS)
        page.wait("byId('empty').innerText === 'Reading scene.pov'")
        seen.after(lambda: watched.write(watched.scene, RED))
        assert page.ask("byId('empty').childNodes.length") == 0 and marked(seen) is None
        assert page.ask("picture.ariaLabel") == "picture of scene.pov"
        assert not page.complaints(), page.complaints()


def check_older(seen):
    page, watched = seen.page, seen.watched
    print("a text that is wrong: the picture has its text's time")
    started = 1e3 * time.time()
    seen.after(lambda: watched.write(watched.scene, RED + "// again\n"))
    assert marked(seen) is None
    read = page.ask("shown.scene.text")
    assert started - 5 < read < 1e3 * time.time(), (started, read)
    time.sleep(1.1)  # the clock shows another second
    before = seen.samples()
    watched.write(watched.scene, WRONG)
    page.wait(AGE)
    assert page.ask(AGE) == f"of {clock(read)}: the text has an error", page.ask(AGE)
    assert marked(seen) and seen.samples() == before
    seen.shot("wrong")

    print("the same for a page that opens now, and when it is zoomed")
    page.open(watched.address)
    page.wait(AGE)
    assert page.ask(AGE) == f"of {clock(read)}: the text has an error", page.ask(AGE)
    assert seen.samples() == before
    page.ask("byId('out').click(); byId('out').click()")
    assert marked(seen)
    page.ask("byId('fit').click()")

    print("a text that is being read")
    watched.write(watched.scene, ENDLESS)
    page.wait(AGE + ".includes('under way')")
    assert page.ask(AGE) == f"of {clock(read)}: the new text is under way", page.ask(AGE)
    assert marked(seen) and seen.samples() == before
    assert page.ask("byId('word').textContent") == "reading"
    seen.shot("reading")

    print("no mark when the first pass of the new text is whole, and not before")
    page.ask(RECORD)
    seen.after(lambda: watched.write(watched.scene, GREEN))
    assert marked(seen) is None
    told, whole, sums = page.ask("told.filter(b => b.g === state.doneGeneration)"), False, {}
    for b in told:
        sums[b["p"]] = sums.get(b["p"], 0) + b["share"]
        whole = whole or abs(sums[b["p"]] - 1) < 1e-9
        assert b["mark"] == ("" if whole else "the new text is under way"), (b, sums)
    assert not told[0]["mark"] == "" and whole, told  # there was more than one block


def check_unread(seen):
    print("a reading that a turn of the camera cancels is begun again")
    page, watched = seen.page, seen.watched
    seen.after(lambda: watched.write(watched.scene, RED))
    started = page.ask("state.text.g")
    watched.write(watched.scene, "#version 3.7;\n#declare N = 0; #while (N < 3e6) #declare N = N + 1; #end\n" + BLUE)
    page.wait(f"state.text.g > {started}")
    page.ask("dollyCamera(0.9)")
    page.wait("state.next.text === state.text.at && state.doneGeneration === state.next.g", 60)
    colour = seen.pixel(*MIDDLE)
    assert colour[2] > 2 * colour[0], colour
    seen.after(lambda: page.ask("byId('reset-camera').click()"))


def check_ended(seen):
    print("whittle has ended")
    read = seen.page.ask("shown.scene.text")
    assert marked(seen) is None
    seen.watched.process.terminate()
    seen.page.wait("state.lost")
    assert seen.page.ask(AGE) == f"of {clock(read)}: whittle watch does not answer", seen.page.ask(AGE)
    assert marked(seen) and seen.page.ask("byId('word').textContent") == "no answer"
    seen.shot("ended")


def main():
    arguments = asked()
    if not arguments:
        return NO_BROWSER
    program = os.path.abspath(arguments.whittle)
    check_first(program, arguments.shots)
    with Watched(program, {"scene.pov": RED}, [f"+W{SIZE[0]}", f"+H{SIZE[1]}"]) as watched, browser.Browser() as page:
        seen = Seen(page, watched, arguments.shots)
        check_older(seen)
        check_unread(seen)
        assert not page.complaints(), page.complaints()
        check_ended(seen)
    print("passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
