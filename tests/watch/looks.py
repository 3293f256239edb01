"""How the page of `whittle watch` looks, in a real browser: layout from wide to narrow, big and small pixels, light and dark.

usage: looks.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no browser
"""
import os
import sys

import browser
from watched import NO_BROWSER, Seen, Watched, asked

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (A_Constant_With_A_Long_Name) #declare A_Constant_With_A_Long_Name = 1; #end
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.2 } }
sphere { y, A_Constant_With_A_Long_Name pigment { rgb <0.9, 0.2, 0.1> } }
#warning "a warning of some length, so that a message has to be broken into lines where the panel is narrow"
"""
SIZE = (160, 120)
# Window, and whether the panel is beside the picture.
WINDOWS = {(1280, 860): True, (800, 700): True, (799, 700): False, (500, 700): False, (390, 844): False, (320, 256): False}
SCHEMES = ("dark", "light")

# What is too large, too small or covered by another; `all` leaves the pixel's tree out, whose places stand in lines of text.
FAULTS = """(() => {
  const faults = [], box = e => e.getBoundingClientRect(), seen = e => e.checkVisibility();
  const name = e => e.tagName + (e.id ? '#' + e.id : '') + ' ' + e.textContent.trim().slice(0, 20);
  const all = [...document.querySelectorAll('header *, aside *')].filter(e => seen(e) && !e.closest('option, #pixel .wide'));
  for (const e of all) {
    const b = box(e), frame = box(e.closest('header, aside'));
    if (!e.closest('.wide') && (b.left < frame.left - 0.5 || b.right > frame.right + 0.5)) faults.push('sticks out: ' + name(e));
    if (parseFloat(getComputedStyle(e).fontSize) < 12) faults.push('small print: ' + name(e));
    if (e.matches('button, select, input, summary') && (b.width < 23.99 || b.height < 23.99)) faults.push(`hard to hit: ${name(e)} ${b.width}x${b.height}`);
    if (e.matches('button, h1, h2, th, td') && !e.closest('h1') && e.scrollWidth > e.clientWidth + 1 && e.clientWidth) faults.push('cut off: ' + name(e));
  }
  const controls = all.filter(e => e.matches('button, select, input, summary, h1, #state'));
  for (const a of controls) for (const b of controls) {
    if (a === b || a.contains(b) || b.contains(a)) continue;
    const p = box(a), q = box(b);
    if (Math.min(p.right, q.right) - Math.max(p.left, q.left) > 0.5 && Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) > 0.5) faults.push(`covered: ${name(a)} by ${name(b)}`);
  }
  if (document.documentElement.scrollWidth > innerWidth) faults.push('the page is wider than the window');
  return faults;
})()"""


def check_layout(seen):
    print("layout")
    page = seen.page
    page.ask("document.querySelectorAll('details').forEach(d => { d.open = true; })")
    for window, beside in WINDOWS.items():
        for scheme in SCHEMES:
            page.size(*window)
            page.scheme(scheme)
            stage, panel, edge = seen.box("#stage"), seen.box("aside"), seen.box("#picture")
            assert not page.ask(FAULTS), (window, page.ask(FAULTS))
            if beside:
                assert panel[0] >= stage[2] > 0.5 * window[0] and panel[2] == window[0], (window, stage, panel)
                assert panel[3] == stage[3] == window[1], (window, stage, panel)
            else:
                width = page.ask("document.documentElement.clientWidth")  # without a scroll bar
                assert panel[1] >= stage[3] and panel[0] == stage[0] == 0 and panel[2] == stage[2] == width, (window, stage, panel)
                assert panel[1] < window[1], (window, panel)  # some of it is seen
            # The whole picture, in most of its field; and nothing lies over it.
            assert stage[0] <= edge[0] and stage[1] <= edge[1] and edge[2] <= stage[2] and edge[3] <= stage[3], (window, stage, edge)
            share = max((edge[2] - edge[0]) / (stage[2] - stage[0]), (edge[3] - edge[1]) / (stage[3] - stage[1]))
            assert share > 0.75, (window, stage, edge)
            for x, y in ((0, 0), (159, 0), (0, 119), (159, 119), (80, 60)):
                at = seen.on_screen(x, y)
                assert page.ask(f"document.elementFromPoint({at[0]}, {at[1]}).closest('#stage') === stage"), (window, x, y)
            seen.shot(f"{window[0]}-{scheme}")
    # The picture of 500x700 has four fifths of the width and more, as the panel has all of the rest.
    page.size(500, 700)
    edge, panel = seen.box("#picture"), seen.box("aside")
    assert edge[2] - edge[0] > 400 and panel[3] == 700, (edge, panel)


def shown(seen):
    """The colours of the screen where the picture is, without a frame of two pixels, and scale and place of it."""
    left, top, right, bottom = (round(x) for x in seen.box("#picture"))
    return {c for row in seen.screen((left + 2, top + 2, right - left - 4, bottom - top - 4)) for c in row}


def check_pixels(seen):
    print("big pixels: smooth between whole multiples, exact on them")
    page = seen.page
    samples = seen.samples()
    colours = {tuple(samples[i:i + 3]) for i in range(0, len(samples), 3)}
    scale = lambda: page.ask("view.scale")
    kind = lambda: page.ask("getComputedStyle(picture).imageRendering")

    def exact(k):
        assert scale() == k and kind() == "pixelated", (scale(), kind())
        assert shown(seen) <= colours
        left, top, right, bottom = seen.box("#picture")
        stage = seen.box("#stage")
        # Each square of k pixels, as far as the picture is seen, is its pixel.
        wide, high = int(min(right, stage[2]) - left) // k, int(min(bottom, stage[3]) - top) // k
        rows = seen.screen((round(left), round(top), wide * k, high * k))
        for y in range(0, high, 7):
            for x in range(wide):
                want = tuple(samples[3 * (y * SIZE[0] + x):][:3])
                assert {rows[y * k + i][x * k + j] for i in (0, k - 1) for j in (0, k - 1)} == {want}, (k, x, y)

    page.size(800, 700)
    page.ask("byId('fit').click()")
    assert 2.5 < scale() < 3 and kind() == "auto", (scale(), kind())
    assert len(shown(seen) - colours) > len(colours)
    page.size(1280, 860)  # 5.4 would fit
    exact(5)
    page.ask("byId('one').click()")
    exact(1)
    # By the wheel: smooth on the way, whole multiples next to them and from 4 on.
    kinds, x, y = [], *seen.on_screen(4, 4)
    while scale() < 7:
        before = page.ask("view.wished")
        page.mouse("mouseWheel", x, y, button="none", deltaX=0, deltaY=-20)
        page.wait(f"view.wished > {before}")
        page.ask("new Promise(done => requestAnimationFrame(() => done(true)))")
        kinds.append((scale(), kind()))
    assert all((k == "pixelated") == (s == round(s)) for s, k in kinds), kinds
    assert {s for s, _ in kinds} >= {5, 6, 7} and any(1 < s < 2 for s, _ in kinds), kinds
    assert all(s == round(s) for s, _ in kinds if s > 4.5), kinds
    # Smaller than the picture: smooth too.
    page.ask("byId('one').click(); byId('out').click(); byId('out').click()")
    assert abs(scale() - 0.64) < 1e-9 and kind() == "auto", (scale(), kind())
    page.ask("byId('fit').click()")


def luminance(colour):
    """Relative, as the Web Content Accessibility Guidelines define it."""
    linear = [c / 3294.6 if c <= 10.31475 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in colour]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def check_schemes(seen):
    print("light and dark, as the reader prefers; scroll bars too")
    page = seen.page
    page.size(500, 700)
    found = {}
    for scheme in SCHEMES:
        page.scheme(scheme)
        assert page.ask("getComputedStyle(document.documentElement).colorScheme") == scheme
        assert page.ask("byId('messages').parentNode.scrollHeight > byId('messages').parentNode.clientHeight")
        header, stage, panel = (seen.box(s) for s in ("header", "#stage", "aside"))
        # A corner of each, and all colours of the panel's scroll bar.
        corners = [seen.screen((round(b[0]) + 1, round(b[3]) - 3, 1, 1))[0][0] for b in (header, stage, panel)]
        bar = page.ask("(a => a.offsetWidth - a.clientWidth)(document.querySelector('aside'))")
        assert bar >= 4, bar
        rows = seen.screen((round(panel[2]) - bar, round(panel[1]) + 2, bar, round(panel[3] - panel[1]) - 4))
        ground, thumb = corners[2], {c for row in rows for c in row}
        share = sum(c == ground for row in rows for c in row) / (len(rows) * bar)
        assert share > 0.2 and len(thumb) > 1, (scheme, share)  # the track has the panel's colour, and there is a thumb
        found[scheme] = [luminance(c) for c in corners]
    assert max(found["dark"]) < 0.03 and min(found["light"]) > 0.6, found


def main():
    arguments = asked()
    if not arguments:
        return NO_BROWSER
    with Watched(os.path.abspath(arguments.whittle), {"scene.pov": SCENE}, [f"+W{SIZE[0]}", f"+H{SIZE[1]}"]) as watched, browser.Browser() as page:
        seen = Seen(page, watched, arguments.shots)
        check_layout(seen)
        check_pixels(seen)
        check_schemes(seen)
        assert not page.complaints(), page.complaints()
    print("passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
