"""The page of `whittle watch`: the clock as a film with frames kept, and the scenes of the folder.

usage: film.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no browser
"""
import json
import sys

import browser
from watched import NO_BROWSER, Seen, Watched, asked

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <5, 8, -6> rgb 1 }
sphere { x*(2*clock - 1), 0.7 pigment { rgb <0.9, 0.6, 0.1> } }
"""
OTHER = SCENE.replace("<0.9, 0.6, 0.1>", "<0.1, 0.5, 0.9>")
SIZE = (96, 72)
CALM = "!sending && state.next.request === firstRequest + requests && state.doneGeneration === state.next.g"  # all that was asked for is done


def check_film(seen):
    page, watched = seen.page, seen.watched
    print("frames of the options' animation, played once")
    assert page.ask("[film.count, film.first, film.last].join()") == "5,0,1"
    page.ask("byId('folder-scenes').parentNode.querySelectorAll('details').forEach(d => { if (d.querySelector('#play')) d.open = true; })")
    page.ask("byId('loop').checked = false; byId('frame-rate').value = 30; byId('play').click()")
    page.wait("!film.playing && film.at === 4 && film.kept.size === 5 && " + CALM, 30)
    print("scrubbing shows kept frames at once, with the bytes of a render")
    before = page.ask("state.next.g")
    for frame in (3, 1, 5):
        page.ask(f"byId('frame').value = {frame}; byId('frame').oninput()")
        clock = (frame - 1) / 4
        assert seen.samples() == watched.rendered(*SIZE, f"+K{clock}", "+KFI1", "+KFF1"), frame
    assert page.ask("state.next.g") == before  # nobody was asked for one
    print("what was asked for before is not drawn over them")
    for frame in (4, 2, 5):
        before = page.ask(f"(g => (ask({{ clock: clockOf(0) }}), byId('frame').value = {frame}, byId('frame').oninput(), byId('frame').onchange(), g))(state.next.g)")
        page.wait(f"state.next.g > {before} && {CALM}")
        assert seen.samples() == watched.rendered(*SIZE, f"+K{(frame - 1) / 4}", "+KFI1", "+KFF1"), frame
        assert page.ask("state.next.clock") == (frame - 1) / 4 and page.ask("film.kept.size") == 5
    page.ask("byId('frame').value = 1; byId('frame').oninput()")
    assert seen.samples() == watched.rendered(*SIZE, "+K0", "+KFI1", "+KFF1")
    seen.shot("film")
    print("loop, pause by the keyboard")
    page.ask("byId('loop').checked = true; byId('stage').focus()")
    page.key(" ")
    page.wait("film.playing")
    page.ask("new Promise(done => setTimeout(done, 700))")
    assert page.ask("film.playing")
    page.key(" ")
    page.wait("!film.playing")
    print("another view forgets them, a save too")
    assert page.ask("(ask({ orbit: { yaw: 20, pitch: 0, dolly: 1, right: 0, up: 0 } }), film.kept.size)") == 0
    page.wait("film.kept.size === 1 && state.doneGeneration === state.generation")
    seen.after(lambda: watched.write(watched.scene, SCENE + "// again\n"), "film.kept.size === 1")
    print("a text that is wrong ends it")
    page.ask("byId('play').click()")
    watched.write(watched.scene, SCENE + "spher { }\n")
    page.wait("state.wrong && !film.playing")
    seen.after(lambda: watched.write(watched.scene, SCENE))
    page.ask("ask({ orbit: null, clock: null })")
    page.wait("film.at === 0 && byId('film-note').textContent.startsWith('frame 1 of 5, clock 0;')")


def check_folder(seen):
    page, watched = seen.page, seen.watched
    print("the folder's scenes")
    page.ask("byId('folder-scenes').open = true")
    page.wait("state.gallery && Object.keys(state.gallery).length === 3", 30)
    assert page.ask("JSON.stringify(state.gallery)") == json.dumps(
        {"blue.pov": "seen", "scene.pov": "seen", "wrong.pov": "has an error"}, separators=(",", ":"))
    colour = page.ask("Array.from(document.querySelector('[data-name=\"blue.pov\"] canvas').getContext('2d').getImageData(42, 48, 1, 1).data)")
    assert colour[2] > 2 * colour[0], colour
    assert page.ask("document.querySelector('[aria-current=true]').dataset.name") == "scene.pov"
    page.ask("byId('folder-scenes').scrollIntoView()")
    seen.shot("folder")
    seen.after(lambda: page.ask("document.querySelector('[data-name=\"blue.pov\"]').click()"), "state.text.file.endsWith('blue.pov')")
    watched.scene = watched.path("blue.pov")
    assert seen.samples() == watched.rendered(*SIZE, "+KFI1", "+KFF1", "+K0")
    seen.after(lambda: watched.write(watched.scene, SCENE))
    assert seen.samples() == watched.rendered(*SIZE, "+KFI1", "+KFF1", "+K0")
    print("and no others")
    for name in ("../etc/passwd", "/etc/passwd", "none.pov", "note.txt", ""):
        assert page.ask(f"post('open', {{ name: {json.dumps(name)} }}).then(r => r.status)") == 404
        assert page.ask(f"fetch('thumbnail?name=' + encodeURIComponent({json.dumps(name)})).then(r => r.status)") == 404


def main():
    arguments = asked()
    if arguments is None:
        return NO_BROWSER
    files = {"scene.pov": SCENE, "blue.pov": OTHER, "wrong.pov": "shpere {}\n", "note.txt": "no scene\n"}
    with browser.Browser() as page, Watched(arguments.whittle, files, [f"+W{SIZE[0]}", f"+H{SIZE[1]}", "+KFI1", "+KFF5", "--povray=off"]) as watched:
        seen = Seen(page, watched, arguments.shots)
        check_film(seen)
        check_folder(seen)
        assert not [c for c in page.complaints() if "404" not in json.dumps(c)], page.complaints()
    return 0


if __name__ == "__main__":
    sys.exit(main())
