"""The page of `whittle watch` and an editor at one file: a click shows the line, a cursor lights its pixels up, numbers have sliders.

usage: editor.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no browser
"""
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import browser
from watched import NO_BROWSER, Seen, Watched, asked

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "lsp"))
from client import Client, uri  # noqa: E402

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.4 } }
sphere { <-1.2, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.2, 0.1> } } sphere { <-2.6, 0.3, 0>, 0.3 pigment { rgb <0.8, 0.8, 0.9> } }
difference {
  box { <0.4, 0, -0.5>, <1.6, 1.2, 0.5> pigment { rgb <0.1, 0.2, 0.9> } }
  sphere { <1, 1.2, -0.5>, 0.4 pigment { rgb <0.2, 0.8, 0.3> } }
}
"""
SIZE = (160, 120)


class Editor(Client):
    """What an editor does with what it is told."""

    def __init__(self, program, watched):
        super().__init__(program, initialize=False)
        self.ask("initialize", {"processId": os.getpid(), "rootUri": uri(watched.folder), "capabilities": {
            "window": {"showDocument": {"support": True}}, "workspace": {"applyEdit": True}, "general": {"positionEncodings": ["utf-8"]}}})
        self.tell("initialized", {})
        self.uri = uri(watched.scene)
        self.tell("textDocument/didOpen", {"textDocument": {"uri": self.uri, "languageId": "pov", "version": 1, "text": SCENE}})

    def cursor(self, text, more=0):
        """On the first place of a text, so many bytes on."""
        before = SCENE[:SCENE.index(text) + more]
        self.tell("whittle/cursor", {"textDocument": {"uri": self.uri}, "position": {"line": before.count("\n"), "character": len(before.split("\n")[-1])}})

    def request(self, method, seconds=20):
        """The parameters of the next request of the server's, which is answered."""
        deadline = time.monotonic() + seconds
        while True:
            found = next((m for m in self.told if m.get("method") == method), None)
            if found:
                self.told.remove(found)
                self.send({"jsonrpc": "2.0", "id": found["id"], "result": {"success": True, "applied": True}})
                return found["params"]
            message = self.read(deadline)
            if "method" in message:
                self.told.append(message)


def lit_share(page, x0, y0, x1, y1):
    """The share of lit pixels in a box of the picture."""
    return page.ask(f"""(() => {{
      const told = state.focus.lit, s = told.step;
      let at = 0, on = 0, all = 0, lit = 0;
      const mask = [];
      for (const run of told.runs) {{ for (let i = 0; i < run; ++i) mask.push(on); on = 1 - on; }}
      for (let y = {y0}; y < {y1}; ++y) for (let x = {x0}; x < {x1}; ++x) {{ ++all; lit += mask[Math.floor(y / s) * told.w + Math.floor(x / s)]; }}
      return lit / all; }})()""")


def focus(page, act, check):
    before = page.ask("state.focus ? state.focus.n = 1 : 0")
    act()
    page.wait(f"state.focus && !state.focus.n && ({check})", 20)
    return before


def check_cursor(seen, editor):
    page = seen.page
    print("the cursor's statement lights up")
    page.wait("state.doneGeneration > 0")
    focus(page, lambda: editor.cursor("sphere", 2), "state.focus.line === 6 && state.focus.lit")
    # Where the sphere is by its colour, and nowhere else.
    agree = page.ask("""(() => {
      const told = state.focus.lit, data = paper.getImageData(0, 0, picture.width, picture.height).data;
      let at = 0, on = 0, wrong = 0, lit = 0;
      for (const run of told.runs) { for (let i = 0; i < run; ++i, ++at) {
        const red = data[4 * at] > 2.2 * data[4 * at + 2];
        lit += on;
        wrong += red !== !!on;
      } on = 1 - on; }
      return [told.w, told.h, lit, wrong]; })()""")
    assert agree[:2] == list(SIZE) and agree[2] > 300 and agree[3] < 0.12 * agree[2], agree  # its edge is antialiased, its shadow dark
    assert not page.ask("lit.hidden")
    seen.shot("lit_sphere")
    focus(page, lambda: editor.cursor("rgb <0.9", 5), "state.focus.line === 6 && state.focus.lit && state.focus.numbers.length === 3")
    focus(page, lambda: editor.cursor("difference", 1), "state.focus.line === 7 && state.focus.lit")
    whole = lit_share(page, 0, 0, *SIZE)
    focus(page, lambda: editor.cursor("sphere { <1,", 1), "state.focus.line === 9 && state.focus.lit")
    part = lit_share(page, 0, 0, *SIZE)
    assert 0 < part < 0.6 * whole, (part, whole)  # the hollow alone
    seen.shot("lit_part")
    page.ask("byId('light-up').click()")
    assert page.ask("lit.hidden")
    page.ask("byId('light-up').click()")
    print("a text that is not saved")
    editor.tell("textDocument/didChange", {"textDocument": {"uri": editor.uri, "version": 2}, "contentChanges": [{"text": SCENE + "// more\n"}]})
    focus(page, lambda: editor.cursor("sphere", 2), "state.focus.why")
    assert "not saved" in page.ask("byId('focus-place').innerText")
    editor.tell("textDocument/didChange", {"textDocument": {"uri": editor.uri, "version": 3}, "contentChanges": [{"text": SCENE}]})


def check_click(seen, editor):
    page = seen.page
    print("a click shows the line")
    x, y = page.ask("""(() => { const d = paper.getImageData(0, 0, picture.width, picture.height).data;
      for (let y = 40; y < 120; ++y) for (let x = 0; x < 160; ++x) { const i = 4 * (160 * y + x); if (d[i + 1] > 1.3 * d[i] && d[i + 1] > 1.3 * d[i + 2]) return [x, y + 1]; }
      return [0, 0]; })()""")
    page.click(*seen.on_screen(x, y))
    asked_for = editor.request("window/showDocument")
    assert asked_for["uri"] == editor.uri and asked_for["takeFocus"], asked_for
    assert asked_for["selection"] == {"start": {"line": 8, "character": 2}, "end": {"line": 8, "character": 8}}, asked_for
    page.wait("state.shown && state.shown.shown")
    page.wait("state.focus.line === 9")
    assert page.ask("byId('focus-place').innerText") == "scene.pov:9:3"


def check_numbers(seen, editor):
    page, watched = seen.page, seen.watched
    print("numbers have sliders, and the picture is that of the text with them")
    focus(page, lambda: editor.cursor("0.7 pigment", 1), "state.focus.line === 6 && state.focus.numbers.length > 3")
    first = page.ask("byId('numbers').children[0].dataset.name")
    assert first == "6:26 sphere", first  # the number under the cursor
    move = "(() => { const r = document.querySelector('#numbers input[type=range]'); r.value = %g; r.oninput(); })()"
    seen.after(lambda: page.ask(move % 1.1))
    grown = seen.samples()
    other = watched.path("out.pov")
    watched.write(other, SCENE.replace("0>, 0.7 pigment", "0>, 1.1 pigment"))
    subprocess.run([watched.program, other, "+W160", "+H120", "+A0.3", "+FP", "+O" + watched.path("out.ppm")], check=True, stderr=subprocess.DEVNULL)
    with open(watched.path("out.ppm"), "rb") as file:
        assert grown == file.read()[-3 * 160 * 120:]
    os.remove(other)
    os.remove(watched.path("out.ppm"))
    with open(watched.scene) as file:
        assert file.read() == SCENE  # the server writes nothing
    page.ask("byId('numbers').scrollIntoView()")
    seen.shot("slider")

    print("how soon")
    above = []
    for i in range(12):
        took, _, traced = seen.slide(0.5 + 0.04 * i)
        above.append(took - traced)
    print("  from the slider to a whole picture without its tracing, ms:", " ".join(f"{t:.0f}" for t in above), "median", round(statistics.median(above)))
    assert min(above) < 30, above  # other work on the machine can only add
    print("while it moves")
    counts = []
    while max(counts, default=0) < 10 and len(counts) < 5:
        counts.append(seen.sweep(0.5, 1.2))
    print("  whole pictures a second:", counts)
    assert max(counts) >= 10, counts
    page.wait("!sending && state.doneGeneration === state.next.g")

    print("places are those of the file, whatever was set before them in the line")
    assert len(page.ask("document.querySelector('#numbers input[type=number]').value")) > 3
    page.click(*seen.on_screen(26, 64))
    page.wait("state.shown.place && state.shown.place.line === 6")
    assert page.ask("state.shown.place.column") == 1 + SCENE.split("\n")[5].rindex("sphere"), page.ask("state.shown")
    editor.request("window/showDocument")
    focus(page, lambda: editor.cursor("0.7 pigment", 1), "state.focus.numbers[0].set")

    print("into the editor's text")
    value = page.ask("+document.querySelector('#numbers input[type=number]').value")
    page.ask("byId('write-numbers').click()")
    edit = editor.request("workspace/applyEdit")["edit"]["changes"][editor.uri]
    assert edit == [{"range": {"start": {"line": 5, "character": 25}, "end": {"line": 5, "character": 28}}, "newText": f"{value:g}"}], edit
    page.wait("byId('note').textContent.includes('written')")
    print("a save of the same text leaves it, another text takes its place, also when the first one comes back")
    set_now = seen.samples()
    for text, same in ((SCENE, True), (SCENE + "// more\n", False), (SCENE, False)):
        seen.after(lambda: watched.write(watched.scene, text))
        assert (seen.samples() == set_now) == same and (same or seen.samples() == watched.rendered(*SIZE))
        assert page.ask("Object.keys(setNumbers).length") == (1 if same else 0)
    print("numbers of files that the scene does not read, and places without one")
    for numbers in ('[{"file": "/etc/passwd", "offset": 1, "value": 2}]', f'[{{"file": "{watched.scene}", "offset": 3, "value": 2}}]', '[1, {"file": 3}]', '{"a": 1}'):
        seen.after(lambda: page.ask(f"post('set', {{ numbers: {numbers} }})"))
        assert seen.samples() == watched.rendered(*SIZE)


def main():
    arguments = asked()
    if arguments is None:
        return NO_BROWSER
    with tempfile.TemporaryDirectory(prefix="whittle-mail-") as mail:
        os.environ["XDG_RUNTIME_DIR"] = mail
        with browser.Browser() as page, Watched(arguments.whittle, {"scene.pov": SCENE}, [f"+W{SIZE[0]}", f"+H{SIZE[1]}", "--povray=off"], by_name=True) as watched:
            seen = Seen(page, watched, arguments.shots)
            print("without an editor: a place to copy")
            page.click(*seen.on_screen(80, 100))
            page.wait("state.shown && !state.shown.shown && state.shown.place.line === 5")
            editor = Editor(arguments.whittle, watched)
            check_cursor(seen, editor)
            check_click(seen, editor)
            check_numbers(seen, editor)
            editor.ask("shutdown", {})
            editor.tell("exit", {})
            assert editor.process.wait(20) == 0
            assert not page.complaints(), page.complaints()
        assert not os.listdir(os.path.join(mail, "whittle"))  # both tidied up
        assert os.stat(os.path.join(mail, "whittle")).st_mode & 0o777 == 0o700
    return 0


if __name__ == "__main__":
    sys.exit(main())
