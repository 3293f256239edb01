"""Drives the page of `whittle watch` in a real browser: save, error, recovery, slider, camera, cut, comparison, pick.

usage: page.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no browser
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time

import browser

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


class Watched:
    """A scene in a folder of its own, the program that watches it, and the page."""

    def __init__(self, program, arguments=()):
        self.folder = tempfile.mkdtemp(prefix="whittle-watch-")
        self.scene = os.path.join(self.folder, "scene.pov")
        self.part = os.path.join(self.folder, "part.inc")
        self.write(self.scene, SCENE)
        self.write(self.part, PART % "0.9, 0.2, 0.1")
        self.process = subprocess.Popen([program, "watch", self.scene, "+W160", "+H120", *arguments], cwd=self.folder,
                                        stdout=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()

    def write(self, path, text):
        with open(path, "w") as out:
            out.write(text)

    def replace(self, path, text):
        """As most editors save: a new file takes the old one's place."""
        self.write(path + "~", text)
        os.replace(path + "~", path)

    def close(self):
        self.process.terminate()
        status = self.process.wait(20)
        left = sorted(os.listdir(self.folder))
        shutil.rmtree(self.folder)
        assert status == 2, f"status {status}"
        return left


def pixel(page, x, y):
    return page.ask(f"Array.from(paper.getImageData({x}, {y}, 1, 1).data)")


def middle(page, x, y):
    """Where a pixel of the picture is on the screen."""
    box = page.ask("(() => { const b = stage.getBoundingClientRect(); return [b.left, b.top, view.x, view.y, view.scale]; })()")
    return box[0] + box[2] + (x + 0.5) * box[4], box[1] + box[3] + (y + 0.5) * box[4]


def run(program, shots):
    watched = Watched(program, ["--reference=" + os.path.join(os.path.dirname(__file__), "reference.png")]
                      if os.path.exists(os.path.join(os.path.dirname(__file__), "reference.png")) else [])
    shot = lambda page, name: shots and page.screenshot(os.path.join(shots, name + ".png"))
    try:
        with browser.Browser() as page:
            generation = lambda: page.ask("state.doneGeneration")

            def after(act, check="true", seconds=30):
                """Waits for the picture that follows `act`."""
                before = generation()
                act()
                page.wait(f"state.doneGeneration > {before} && ({check})", seconds)

            page.open(watched.address)
            page.wait("state.doneGeneration > 0")
            red = pixel(page, 70, 55)
            assert red[0] > 2 * red[1], red
            shot(page, "first")

            print("save of an included file, by renaming")
            after(lambda: watched.replace(watched.part, PART % "0.1, 0.2, 0.9"))
            blue = pixel(page, 70, 55)
            assert blue[2] > 2 * blue[0], blue

            print("the same bytes as a render")
            out = os.path.join(watched.folder, "out.ppm")
            subprocess.run([program, watched.scene, "+W160", "+H120", "+A0.3", "+FP", "+O" + out], check=True,
                           stderr=subprocess.DEVNULL)
            with open(out, "rb") as file:
                wanted = file.read()[-3 * 160 * 120:]
            shown = bytes(page.ask("Array.from(paper.getImageData(0, 0, 160, 120).data)"))
            seen = b"".join(shown[i:i + 3] for i in range(0, len(shown), 4))
            assert seen == wanted, sum(a != b for a, b in zip(seen, wanted))
            os.remove(out)

            print("error: message, place, the last good picture")
            watched.write(watched.part, "#macro Part(H)\nbox { <-1, 0, -0.5>, <0.5, H 0.5> pigmnt { rgb 1 } }\n#end\n")
            page.wait("state.wrong")
            text = page.ask("byId('messages').innerText")
            assert "part.inc:2:" in text and "^" in text, text
            assert pixel(page, 70, 55) == blue
            assert page.ask("byId('lamp').className") == "wrong"
            page.ask("document.querySelector('.message .place').click()")
            assert page.ask("state.copied").endswith("part.inc:2"), page.ask("state.copied")
            shot(page, "error")

            print("a file that is missing, and its coming")
            os.rename(watched.part, watched.part + ".away")
            watched.write(watched.scene, SCENE + "// again\n")
            page.wait("byId('messages').innerText.includes('part.inc')")
            after(lambda: watched.write(watched.part, PART % "0.9, 0.2, 0.1"), "!state.wrong")
            assert pixel(page, 70, 55) == red, (pixel(page, 70, 55), red)

            print("warning")
            after(lambda: watched.write(watched.scene, SCENE + '#warning "look here"\n'))
            assert "look here" in page.ask("byId('messages').innerText")
            after(lambda: watched.write(watched.scene, SCENE))

            print("comparison with the save before")
            after(lambda: watched.write(watched.part, PART % "0.1, 0.9, 0.2"))
            page.ask("byId('compare').value = 'before'; byId('compare').onchange(); byId('wipe').value = 1; drawComparison()")
            seen = page.ask("Array.from(other.getContext('2d').getImageData(70, 55, 1, 1).data)")
            assert seen == red, (seen, red)
            page.ask("byId('compare-how').value = 'difference'; drawComparison()")
            assert "pixels differ" in page.ask("byId('compare-note').textContent")
            shot(page, "difference")
            page.ask("byId('compare').value = ''; drawComparison()")

            print("sliders")
            assert page.ask("[...byId('values').children].map(r => r.dataset.name).join()") == "clock,Height"
            sky = pixel(page, 70, 30)
            move = "(() => {{ const r = document.querySelector('[data-name={0}] input[type=range]'); r.value = {1}; r.oninput(); }})()"
            after(lambda: page.ask(move.format("Height", 2)))
            grown = pixel(page, 70, 30)
            assert grown != sky and grown[1] > grown[0], (sky, grown)
            still = pixel(page, 118, 56)
            after(lambda: page.ask(move.format("clock", 1)))
            assert pixel(page, 118, 56) != still
            shot(page, "sliders")
            after(lambda: page.ask("document.querySelector('[data-name=clock] button').click()"))
            after(lambda: page.ask("document.querySelector('[data-name=Height] button').click()"))

            print("camera by mouse, copied as text")
            before = page.ask("byId('camera').textContent")
            page.ask("document.querySelector('[data-tool=orbit]').click()")
            x, y = middle(page, 80, 60)
            after(lambda: page.drag(x, y, x + 120, y + 30))
            page.wait("byId('lamp').className === 'done'")
            page.ask("byId('copy-camera').click()")
            text = page.wait("state.copied.startsWith('camera') && state.copied")
            assert text != before
            shot(page, "camera")
            # The block in the scene's place gives the picture that is seen.
            time.sleep(0.5)
            turned = page.ask("Array.from(paper.getImageData(0, 0, 160, 120).data)")
            after(lambda: page.ask("byId('reset-camera').click()"))
            assert page.ask("byId('camera').textContent") == before
            replaced = SCENE.replace("camera { location <0, 2, -6> look_at <0, 0.5, 0> }", text)
            after(lambda: watched.write(watched.scene, replaced))
            again = page.ask("Array.from(paper.getImageData(0, 0, 160, 120).data)")
            off = sum(abs(a - b) > 3 for a, b in zip(turned, again))
            assert off < 0.005 * len(again), off
            after(lambda: watched.write(watched.scene, SCENE))
            page.ask("document.querySelector('[data-tool=pan]').click()")

            print("cutting plane")
            whole = pixel(page, 70, 55)
            after(lambda: page.ask("byId('cut-axis').value = '0,1,0'; byId('cut-offset').value = 0.3; askCut()"))
            assert pixel(page, 70, 55) != whole
            shot(page, "cut")
            after(lambda: page.ask("byId('cut-axis').value = ''; askCut()"))
            assert pixel(page, 70, 55) == whole

            print("zoom and pan")
            x, y = middle(page, 80, 60)
            scale = page.ask("view.scale")
            page.mouse("mouseWheel", x, y, button="none", deltaX=0, deltaY=-200)
            page.wait(f"view.scale > {scale}")
            left = page.ask("view.x")
            page.drag(x, y, x + 40, y)
            assert abs(page.ask("view.x") - left - 40) < 1.5

            print("pick")
            x, y = middle(page, 70, 55)
            page.click(x, y)
            page.wait("state.picked")
            text = page.ask("byId('pixel').innerText")
            assert "box" in text and "part.inc:1" in text, text
            printed = subprocess.run([program, "pixel", watched.scene, "70,55", "+W160", "+H120"], check=True,
                                     capture_output=True, text=True, cwd=watched.folder).stdout
            assert printed == page.ask("state.picked.text"), printed
            shot(page, "pick")

            if shutil.which("povray"):
                print("POV-Ray beside it")
                page.ask("byId('compare').value = 'povray'; byId('compare').onchange()")
                page.wait("!!compared.povray", 60)
                assert page.ask("compared.povray.width") == 160
                shot(page, "povray")

            print("a scene that never ends, and a save that ends it")
            watched.write(watched.scene, "#while (1) #end\n")
            time.sleep(0.3)
            started = time.monotonic()
            after(lambda: watched.write(watched.scene, SCENE), "!state.wrong", 10)
            assert time.monotonic() - started < 5
            assert not page.complaints(), page.complaints()
    finally:
        left = watched.close()
    assert left == ["part.inc", "part.inc.away", "scene.pov"], left  # nothing was written
    print("passed")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("whittle")
    parser.add_argument("--shots", help="folder for screenshots")
    arguments = parser.parse_args()
    if not browser.find():
        print("no chromium: the page is not tested")
        return 77
    if arguments.shots:
        os.makedirs(arguments.shots, exist_ok=True)
    run(os.path.abspath(arguments.whittle), arguments.shots)
    return 0


if __name__ == "__main__":
    sys.exit(main())
