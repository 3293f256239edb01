"""A scene that `whittle watch` looks at in a folder of its own, and the page that a browser shows of it."""
import argparse
import base64
import os
import shutil
import subprocess
import tempfile
import time

import browser

FIRST_WHOLE_PASS = 4  # 1/1, behind 1/16, 1/8, 1/4 and 1/2
NO_BROWSER = 77  # exit status that ctest takes for "skipped"


def asked():
    """The command line of a test of the page; None, told, where there is no browser."""
    parser = argparse.ArgumentParser()
    parser.add_argument("whittle")
    parser.add_argument("--shots", help="folder for screenshots")
    arguments = parser.parse_args()
    arguments.whittle = os.path.abspath(arguments.whittle)
    if not browser.find():
        print("no chromium: the page is not tested")
        return None
    if arguments.shots:
        os.makedirs(arguments.shots, exist_ok=True)
    return arguments


class Watched:
    """The files, and the program that watches the first of them. Use as a context manager."""

    def __init__(self, program, files, arguments, stay=(), by_name=False):
        """`stay`: the names that may be in the folder at the end; nothing else was written there. `by_name`: without its folder, from there."""
        self.program, self.arguments = program, list(arguments)
        self.folder = tempfile.mkdtemp(prefix="whittle-watch-")
        self.stay = sorted([*files, *stay])
        for name, text in files.items():
            self.write(self.path(name), text)
        self.scene = self.path(next(iter(files)))
        self.process = subprocess.Popen([program, "watch", os.path.basename(self.scene) if by_name else self.scene, *arguments], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, path, text):
        with open(path, "w") as out:
            out.write(text)

    def replace(self, path, text):
        """As most editors save: a new file takes the old one's place."""
        self.write(path + "~", text)
        os.replace(path + "~", path)

    def rendered(self, width, height, *more):
        """The samples of the scene as an ordinary run of the program makes them."""
        out = self.path("out.ppm")
        subprocess.run([self.program, self.scene, f"+W{width}", f"+H{height}", "+A0.3", *more, "+FP", "+O" + out], check=True,
                       stderr=subprocess.DEVNULL)
        with open(out, "rb") as file:
            samples = file.read()[-3 * width * height:]
        os.remove(out)
        return samples

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        self.process.terminate()
        status = self.process.wait(20)
        left = sorted(os.listdir(self.folder))
        shutil.rmtree(self.folder)
        if kind is None:
            assert status == 2, f"status {status}"
            assert left == self.stay, left


class Seen:
    """What the page shows."""

    def __init__(self, page, watched, shots=None, ready="state.doneGeneration > 0"):
        self.page, self.watched, self.shots = page, watched, shots
        page.open(watched.address)
        page.wait(ready, 60)

    def shot(self, name):
        if self.shots:
            self.page.screenshot(os.path.join(self.shots, name + ".png"))

    def after(self, act, check="true", seconds=30):
        """Waits for the picture that follows `act`."""
        before = self.page.ask("state.doneGeneration")
        act()
        self.page.wait(f"state.doneGeneration > {before} && ({check})", seconds)

    def pixel(self, x, y, paper="paper"):
        return self.page.ask(f"Array.from({paper}.getImageData({x}, {y}, 1, 1).data)")

    def samples(self, paper="paper"):
        """Red, green and blue of all pixels."""
        data = bytes(self.page.ask(f"Array.from({paper}.getImageData(0, 0, picture.width, picture.height).data)"))
        return b"".join(data[i:i + 3] for i in range(0, len(data), 4))

    def on_screen(self, x, y):
        """Where a pixel of the picture is in the window."""
        box = self.page.ask("(() => { const b = stage.getBoundingClientRect(); return [b.left, b.top, view.x, view.y, view.scale]; })()")
        return box[0] + box[2] + (x + 0.5) * box[4], box[1] + box[3] + (y + 0.5) * box[4]

    def screen(self, box):
        """Red, green and blue of the window's pixels in a box of left, top, width, height, by rows."""
        shot = self.page.call("Page.captureScreenshot", format="png")["data"]
        data = self.page.ask(f"""(async () => {{
          const bytes = Uint8Array.from(atob('{shot}'), c => c.charCodeAt(0)), [x, y, w, h] = {list(box)};
          const image = await createImageBitmap(new Blob([bytes], {{ type: 'image/png' }}), {{ colorSpaceConversion: 'none' }});
          const canvas = new OffscreenCanvas(w, h).getContext('2d');
          canvas.drawImage(image, -x, -y);
          const data = canvas.getImageData(0, 0, w, h).data;
          let text = '';
          for (let i = 0; i < data.length; i += 4) text += String.fromCharCode(data[i], data[i + 1], data[i + 2]);
          return btoa(text);
        }})()""")
        samples = iter(base64.b64decode(data))
        colours = list(zip(samples, samples, samples))
        return [colours[y * box[2]:][:box[2]] for y in range(box[3])]

    def box(self, selector):
        """left, top, right, bottom of an element in the window."""
        return self.page.ask(f"(() => {{ const b = document.querySelector('{selector}').getBoundingClientRect(); return [b.left, b.top, b.right, b.bottom]; }})()")

    def choose(self, control, value, event="change"):
        """As a hand sets a control of the page."""
        self.page.ask(f"byId('{control}').value = '{value}'; byId('{control}').dispatchEvent(new Event('{event}'))")

    def slide(self, value):
        """Moves the first slider of the numbers. Milliseconds by the browser's clock until each pixel is of that value, and the program's own
        of reading and planning and of tracing these."""
        took = self.page.ask(f"""new Promise(done => {{
          const range = document.querySelector('#numbers input[type=range]'), from = performance.now();
          const look = () => {{
            if (shown.scene?.request !== firstRequest + requests || shown.areas[{FIRST_WHOLE_PASS}] !== picture.width * picture.height) return;
            source.removeEventListener('block', look);
            done(performance.now() - from);
          }};
          source.addEventListener('block', look);
          range.value = {value};
          range.oninput();
        }})""")
        self.page.wait("state.doneGeneration === state.generation")
        times = self.page.ask("[...byId('times').rows].map(row => [row.cells[0].textContent, parseFloat(row.cells[1].textContent)])")
        traced = sum(ms for name, ms in times if name.startswith("1/"))
        return took, sum(ms for name, ms in times if name in ("parse", "plan")), traced

    def sweep(self, low, high, seconds=1, moves=60):
        """Moves it from one value to another as a hand does, so often a second; how many whole pictures were seen meanwhile."""
        return self.page.ask(f"""new Promise(done => {{
          const range = document.querySelector('#numbers input[type=range]'), from = performance.now(), seen = new Set();
          const look = () => {{ if (shown.scene?.request > first) seen.add(shown.scene.g); }}, first = firstRequest + requests;
          source.addEventListener('block', look);
          const move = () => {{
            const share = (performance.now() - from) / {1e3 * seconds};
            if (share >= 1) {{
              source.removeEventListener('block', look);
              return done(seen.size);
            }}
            range.value = {low} + ({high} - {low}) * share;
            range.oninput();
            setTimeout(move, {1e3 / moves});
          }};
          move();
        }})""")

    def save_until(self, text, enough, seconds=60):
        """Saves the scene again and again until `enough(when it was saved)` is true. What a page sees of one save the machine's other
        work may delay and coarse passes may be over before they are sent; that can only add time and take events away."""
        deadline = time.monotonic() + seconds
        number = 0
        while True:
            number += 1
            saved = 1e3 * time.time()
            self.after(lambda: self.watched.write(self.watched.scene, f"{text}\n// {number}\n"), seconds=60)
            if enough(saved):
                return
            assert time.monotonic() < deadline, f"not in {number} saves"


def beyond(a, b):
    """How many pixels of two pictures differ by more than 3 of 255 in a channel, and the worst difference."""
    most = [max(abs(p - q) for p, q in zip(a[i:i + 3], b[i:i + 3])) for i in range(0, len(a), 3)]
    return sum(m > 3 for m in most), max(most)
