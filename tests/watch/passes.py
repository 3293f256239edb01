"""How a picture comes to the page of `whittle watch`, in a real browser: first picture after a save, passes from coarse to fine, time left,
times of the stages; and the comparison with a reference, POV-Ray's picture of the same scene.

usage: passes.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no browser
"""
import base64
import os
import re
import sys

import browser
from watched import NO_BROWSER, Seen, Watched, asked, beyond

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SIZE = (640, 480)  # whole blocks of 16 pixels, so that each cell of a coarse pass is a square of the picture
STEPS = [16, 8, 4, 2, 1, 1]
STAGES = ["parse", "plan", "1/16", "1/8", "1/4", "1/2", "1/1", "antialiasing"]
SOONEST = 100  # milliseconds from a save to the first picture of a simple scene

# After the page's own listeners: what was told and what the page makes of it. `even`: each cell of a coarse block has one colour.
RECORD = """window.told = [];
const even = b => {
  const step = picture.width / b.W;
  const w = b.w * step, data = new Uint32Array(paper.getImageData(b.x * step, b.y * step, w, b.h * step).data.buffer);
  return data.every((one, i) => one === data[(Math.floor(i / w) - Math.floor(i / w) % step) * w + i % w - i % w % step]);
};
on('block', b => told.push({ name: 'block', g: b.g, pass: b.p, w: b.w, h: b.h, W: b.W, H: b.H, even: even(b) }));
on('progress', p => told.push({ name: 'progress', ...p, text: byId('left').textContent, bar: byId('progress').value, stage: byId('pass').textContent }));
on('done', d => told.push({ name: 'done', ...d }));
true"""


def first_light():
    with open(os.path.join(ROOT, "scenes", "first_light.pov")) as file:
        return file.read()


def check_first(seen):
    print("the first picture")
    page, found = seen.page, []

    def soon(saved):
        found.append(page.ask("state.firstAt") - saved)
        return 0 < found[-1] < SOONEST

    seen.save_until(first_light(), soon)
    print(f"  {found[-1]:.0f} ms after the save")


def check_blocks(blocks):
    passes = [b["pass"] for b in blocks]
    assert passes == sorted(passes), passes  # coarse to fine
    for b in blocks:
        step = STEPS[b["pass"]]
        assert (b["W"] * step, b["H"] * step) == SIZE, b
        assert b["even"], b
    # The last pass is whole: nothing of the one before is left.
    assert sum(b["w"] * b["h"] for b in blocks if b["pass"] == 5) == SIZE[0] * SIZE[1]
    return set(passes)


def check_progress(events, antialiasing):
    """Returns how many told a time left in the last pass. There the share s and the time left l say how long the pass has been running,
    l s / (1 - s): never less than before, never more than it took in the end, whatever else the machine does."""
    shares, before, count = {}, 0.0, 0
    for e in events:
        share, left = e["share"], e["left"]
        assert shares.get(e["pass"], 0.0) <= share <= 1, e
        shares[e["pass"]] = share
        assert e["pass"] in STAGES and e["stage"] == e["pass"] and abs(e["bar"] - share) < 1e-9, e
        if left < 0:
            assert e["text"] == "", e
            continue
        shown = re.fullmatch(r"(\d+\.\d) s left|(\d+) min left", e["text"])
        assert shown and (abs(float(shown[1]) - left) < 0.051 if left < 60 else abs(60 * int(shown[2]) - left) < 31), e
        if e["pass"] != "antialiasing" or not 0 < share < 0.9:
            continue
        ratio = share / (1 - share)
        rounding = 0.005 * ratio + left * 5e-5 / (1 - share) ** 2  # `left` has two digits, `share` four
        running = left * ratio
        assert before - rounding <= running <= antialiasing + rounding, (e, before, antialiasing)
        before = max(before, running - rounding)
        count += 1
    return count


def check_passes(seen):
    print("passes from coarse to fine, time left, times of the stages")
    page = seen.page
    page.ask(RECORD)
    found, left_told = set(), 0

    def all_seen(saved):
        nonlocal left_told
        now = page.ask("""(() => {
          const g = state.doneGeneration, all = told.filter(e => e.g <= g);
          told = told.filter(e => e.g > g);
          return { told: all.filter(e => e.g === g), at: state.doneAt, bar: byId('progress').value, left: byId('left').textContent,
                   total: byId('pass').textContent, rows: [...byId('times').rows].map(r => [...r.cells].map(c => c.textContent)) };
        })()""")
        done = now["told"][-1]
        names, seconds = zip(*done["times"])
        assert done["name"] == "done" and list(names) == STAGES, done
        assert min(seconds) > 0 and sum(seconds) <= done["total"] + 1e-6, done
        assert done["total"] <= (now["at"] - saved) / 1e3 + 0.05, done  # the clocks of two programs
        found.update(check_blocks([e for e in now["told"] if e["name"] == "block"]))
        left_told += check_progress([e for e in now["told"] if e["name"] == "progress"], dict(done["times"])["antialiasing"])
        # What the page shows of it.
        assert [row[0] for row in now["rows"]] == STAGES, now["rows"]
        for (_, text), one in zip(now["rows"], seconds):
            assert text.endswith(" ms") and abs(float(text[:-3]) - 1e3 * one) < 0.051, (text, one)
        assert (now["left"], now["bar"]) == ("", 1), now
        assert abs(float(now["total"].removesuffix(" s")) - done["total"]) <= (0.0051 if done["total"] < 10 else 0.51), now
        return len(found) == len(STEPS) and left_told > 0

    seen.save_until(first_light(), all_seen, 120)
    seen.shot("passes")


def check_reference(program, shots):
    print("the comparison with a reference")
    path = os.path.join(ROOT, "reference_images", "first_light.png")
    with Watched(program, {"scene.pov": first_light()}, ["+W480", "+H360", "-A", "--reference=" + path]) as watched, browser.Browser() as page:
        seen = Seen(page, watched, shots)
        seen.choose("compare", "reference")
        page.wait("!!compared.reference")
        # The file as the browser itself reads it.
        with open(path, "rb") as file:
            text = base64.b64encode(file.read()).decode()
        page.ask(f"""(async () => {{
          const bytes = Uint8Array.from(atob('{text}'), c => c.charCodeAt(0));
          const image = await createImageBitmap(new Blob([bytes], {{ type: 'image/png' }}), {{ colorSpaceConversion: 'none' }});
          window.file = document.createElement('canvas').getContext('2d');
          [file.canvas.width, file.canvas.height] = [image.width, image.height];
          file.drawImage(image, 0, 0);
        }})()""")
        reference, shown = seen.samples("file"), seen.samples()
        assert seen.samples("compared.reference.getContext('2d')") == reference
        # The left half is the reference, the right half shows the picture below.
        seen.choose("wipe", 0.5, "input")
        column = "other.getContext('2d').getImageData({}, 100, 1, 1).data[3]"
        assert [page.ask(column.format(x)) for x in (0, 239, 241, 479)] == [255, 255, 0, 0]
        left = page.ask("Array.from(other.getContext('2d').getImageData(200, 250, 1, 1).data)")
        assert bytes(left[:3]) == reference[3 * (250 * 480 + 200):][:3], left
        assert page.ask("byId('compare-note').textContent") == "the reference is on the left"
        seen.choose("compare-how", "difference")
        count, worst = beyond(shown, reference)
        assert page.ask("byId('compare-note').textContent") == f"{count} pixels differ by more than 3, the worst by {worst}, of 255"
        assert count <= 0.0005 * 480 * 360, count  # as the golden case of this scene
        seen.shot("reference")
        assert not page.complaints(), page.complaints()


def main():
    arguments = asked()
    if not arguments:
        return NO_BROWSER
    program = os.path.abspath(arguments.whittle)
    # One thread, so that the last pass lasts some tenths of a second: the time left is told ten times a second.
    size = [f"+W{SIZE[0]}", f"+H{SIZE[1]}", "+WT1"]
    with Watched(program, {"scene.pov": first_light()}, size) as watched, browser.Browser() as page:
        seen = Seen(page, watched, arguments.shots)
        check_first(seen)
        check_passes(seen)
        assert not page.complaints(), page.complaints()
    check_reference(program, arguments.shots)
    print("passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
