"""The page of `whittle watch` for keyboard and screen reader, in a real browser: names, landmarks, headings, contrast, focus, keys. What these
rules leave out is for `axe.py`.

usage: access.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no browser
"""
import math
import os
import sys

import browser
from watched import NO_BROWSER, Seen, Watched, asked

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Height) #declare Height = 1; #end
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.4 } }
sphere { y, Height pigment { rgb <0.9, 0.2, 0.1> } finish { reflection 0.2 } }
#warning "look here"
"""
WRONG = "#version 3.7;\n#macro Part(H) sphere { y, H pigmnt { rgb 1 } finish { reflection 0.2 } translate x*3 rotate y*45 scale 2 } #end\nPart(1)\n"
SIZE = ["+W160", "+H120"]
TALL = 3000  # a window in which all of the panel is seen
LOOKS = [(width, scheme) for width in (1280, 390) for scheme in ("dark", "light")]

OPEN = "document.querySelectorAll('details').forEach(d => { d.open = true; }); true"
FOCUSABLE = "[...document.querySelectorAll('button, select, input, summary, [tabindex]')].filter(e => e.checkVisibility() && !e.disabled)"
NAMED = {"button", "textbox", "spinbutton", "slider", "combobox", "image", "application", "progressbar", "main", "complementary", "region",
         "table", "DisclosureTriangle", "heading"}

# Contrast of texts (4.5), of the borders of controls and of the lamp (3), as computed styles have them.
CONTRAST = """(() => {
  const parts = text => { const n = text.match(/[\\d.]+/g).map(Number); return [n[0], n[1], n[2], n.length > 3 ? n[3] : 1]; };
  const over = (top, ground) => [0, 1, 2].map(i => top[i] * top[3] + ground[i] * (1 - top[3]));
  const ground = e => !e ? [255, 255, 255] : over(parts(getComputedStyle(e).backgroundColor), ground(e.parentElement));
  const light = c => c.map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4).reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
  const contrast = (a, b) => { const [p, q] = [light(a), light(b)].sort((x, y) => y - x); return (p + 0.05) / (q + 0.05); };
  const faults = [], seen = new Set();
  let texts = 0, borders = 0;
  const need = (e, what, colour, on, least) => { if (contrast(colour, on) < least) faults.push(`${what} ${contrast(colour, on).toFixed(2)}: ${e.outerHTML.slice(0, 90)}`); };
  const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) if (walk.currentNode.data.trim() && walk.currentNode.parentElement.checkVisibility()) seen.add(walk.currentNode.parentElement);
  document.querySelectorAll('input[type=number], select, .sign').forEach(e => seen.add(e));
  for (const e of seen) if (e.checkVisibility() && !e.closest('script, style')) { ++texts; need(e, 'text', over(parts(getComputedStyle(e).color), ground(e)), ground(e), 4.5); }
  for (const e of document.querySelectorAll('button:not(.place), select, input[type=number]'))
    if (e.checkVisibility()) { ++borders; need(e, 'border', parts(getComputedStyle(e).borderTopColor), ground(e.parentElement), 3); }
  const lamp = getComputedStyle(byId('lamp'));
  need(byId('lamp'), 'lamp', parts(lamp.backgroundColor), ground(byId('lamp').parentElement), 3);
  return { faults, texts, borders };
})()"""

# Of the element that has the focus: its place among all, and what is wrong with how that is seen.
FOCUS = f"""(() => {{
  const e = document.activeElement, style = getComputedStyle(e), b = e.getBoundingClientRect(), faults = [];
  if (!e.matches(':focus-visible') || style.outlineStyle === 'none' || parseFloat(style.outlineWidth) < 2) faults.push('no outline');
  if (b.bottom <= 0 || b.top >= innerHeight || b.right <= 0 || b.left >= innerWidth) faults.push('out of the window');
  const at = document.elementFromPoint(b.left + Math.min(b.width, 40) / 2, b.top + Math.min(b.height, 20) / 2);
  if (!at || !(e.contains(at) || at.contains(e))) faults.push('covered');
  return {{ place: {FOCUSABLE}.indexOf(e), html: e.outerHTML.slice(0, 90), faults }};
}})()"""


def states(program, shots):
    """The page as it is when all is well, with all of the panel open; with a wrong text; with a first text that is wrong."""
    with Watched(program, {"scene.pov": SCENE}, SIZE) as watched, browser.Browser() as page:
        seen = Seen(page, watched, shots)

        def opened():
            page.ask(OPEN)
            page.wait("state.gallery && Object.keys(state.gallery).length === gallery.children.length")

        def well():
            opened()
            seen.choose("compare", "before")
            page.ask("pick(80, 60)")
            page.wait("state.picked")

        yield "well", seen, well
        watched.write(watched.scene, WRONG)
        page.wait("state.wrong && byId('age').textContent")
        yield "wrong", seen, lambda: (page.wait("state.wrong && byId('age').textContent"), opened())
        assert not page.complaints(), page.complaints()
    with Watched(program, {"scene.pov": WRONG}, SIZE) as watched, browser.Browser() as page:
        yield "first", Seen(page, watched, shots, "state.wrong"), lambda: page.wait("state.wrong")


def fresh(seen, ready):
    """The page anew: no focus, nothing remembered."""
    seen.page.open(seen.watched.address)
    seen.page.wait("state.doneGeneration > 0 || state.wrong")
    ready()


def check_tree(page, state):
    """What a screen reader is told, by the browser's own reckoning."""
    nodes = [n for n in page.call("Accessibility.getFullAXTree")["nodes"] if not n["ignored"]]
    role, name = (lambda n: n.get("role", {}).get("value")), (lambda n: n.get("name", {}).get("value", ""))
    nameless = [n for n in nodes if role(n) in NAMED and not name(n).strip()]
    assert not nameless, nameless
    assert sum(role(n) in NAMED for n in nodes) > (8 if state == "first" else 40)
    landmarks = [(role(n), name(n)) for n in nodes if role(n) in ("banner", "main", "complementary", "region", "navigation", "contentinfo")]
    panel = [] if state == "first" else [("complementary", "scene"), ("region", "messages")]
    assert sorted(landmarks) == sorted([("banner", ""), ("main", "picture"), *panel]), landmarks
    levels = page.ask("[...document.querySelectorAll('h1, h2, h3, h4, h5, h6')].filter(e => e.checkVisibility()).map(e => +e.tagName[1])")
    assert levels[0] == 1 and levels.count(1) == 1 and all(b <= a + 1 for a, b in zip(levels, levels[1:])) and len(levels) > 1, levels
    assert page.ask("document.documentElement.lang") == "en"
    assert page.ask("document.title") == "scene.pov - whittle"
    # Buttons that look alike are told apart.
    buttons = [name(n) for n in nodes if role(n) == "button" and ":" not in name(n)]
    assert len(set(buttons)) == len(buttons), buttons


def check_focus(page):
    """Tab goes through all controls in the order in which they stand, and each shows that it has the focus."""
    # From the top, wherever this version of the browser has scrolled to.
    page.ask("document.body.tabIndex = -1; document.body.focus(); document.body.removeAttribute('tabindex')")
    count = page.ask(FOCUSABLE + ".length")
    for k in range(count):
        page.key("Tab")
        page.ask("new Promise(done => requestAnimationFrame(() => done(true)))")
        now = page.ask(FOCUS)
        assert now["place"] == k and not now["faults"], (k, now)
    page.key("Tab")  # and leaves it, or begins again
    assert page.ask(f"document.activeElement === document.body || {FOCUSABLE}.indexOf(document.activeElement) === 0")
    return count


def check_keys(seen):
    print("the picture by keys")
    page = seen.page
    page.size(1280, 860)
    page.ask("window.last = {}; on('controls', c => { last = c; }); byId('fit').click(); stage.focus()")
    scale, left = page.ask("view.scale"), page.ask("view.x")
    page.key("ArrowRight")
    assert page.ask("view.x") == left + 40 and not page.ask("view.fitted")
    page.key("+")
    assert page.ask("view.scale") > scale
    page.key("-")
    page.key("-")
    assert page.ask("view.scale") < scale
    page.key("1")
    assert page.ask("view.scale") == 1
    page.key("0")
    assert page.ask("view.scale") == scale and page.ask("view.fitted")

    page.ask("document.querySelector('[data-tool=orbit]').focus()")
    page.key(" ")
    assert page.ask("view.tool") == "orbit"
    assert page.ask("[...document.querySelectorAll('[data-tool]')].map(b => b.getAttribute('aria-pressed')).join()") == "false,true"
    page.ask("stage.focus()")
    page.key("ArrowRight")
    page.wait(f"last.orbit && Math.abs(last.orbit.yaw - {180 * 40 / (160 * scale)}) < 1e-6")
    page.key("ArrowUp", modifiers=8)
    page.wait(f"Math.abs(last.orbit.up + {40 / (120 * scale)}) < 1e-6")
    page.key("+")
    page.wait("Math.abs(last.orbit.dolly - 0.8) < 1e-6")
    page.ask("byId('reset-camera').focus()")
    page.key("Enter")
    page.wait("last.orbit.dolly === 1 && last.orbit.yaw === 0 && state.doneGeneration === state.next.g && byId('lamp').className === 'done'")
    page.ask("document.querySelector('[data-tool=pan]').click()")

    print("a value, its way back, and a pixel by keys")
    page.ask("byId('value-Height').focus()")
    seen.after(lambda: page.key("ArrowRight"), "last.constants[0].value > 1")
    page.ask("document.querySelector('[data-name=Height] button').focus()")
    seen.after(lambda: page.key(" "), "last.constants[0].value === 1 && byId('value-Height').value === '1'")
    assert page.ask("document.activeElement === document.querySelector('[data-name=Height] button')")  # the focus stays
    page.ask("state.picked = null; byId('pixel-x').value = 70; byId('pixel-y').value = 55; byId('pixel-y').focus()")
    page.key("Enter")
    page.wait("state.picked")
    assert page.ask("[state.picked.x, state.picked.y, ...state.picked.shown]") == [70, 55, *seen.pixel(70, 55)[:3]]
    page.ask("document.querySelector('#pixel .place').focus()")
    page.key("Enter")
    assert page.ask("byId('note').textContent").startswith(f"copied {seen.watched.scene}:"), page.ask("byId('note').textContent")


def main():
    arguments = asked()
    if not arguments:
        return NO_BROWSER
    for state, seen, ready in states(os.path.abspath(arguments.whittle), arguments.shots):
        page = seen.page
        for width, scheme in LOOKS:
            page.size(width, 700)
            page.scheme(scheme)
            fresh(seen, ready)
            check_tree(page, state)
            found = page.ask(CONTRAST)
            assert not found["faults"] and found["texts"] > 6 and found["borders"] > 5, found
            fresh(seen, ready)
            count = check_focus(page)
            print(f"{state}, {width} pixels wide, {scheme}: contrast of {found['texts']} texts and {found['borders']} borders, {count} controls by Tab")
            seen.shot(f"access-{state}-{width}-{scheme}")
        if state == "well":
            check_keys(seen)
    print("passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
