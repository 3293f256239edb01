"""Jobs for the tests of farms: scenes, plain runs to compare with, processes of tasks."""
import os
import pathlib
import signal
import subprocess

ANIMATION = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-5, 5, -5>, 1 area_light x, y, 5, 5 }
plane { y, -1 pigment { bozo turbulence 0.5 scale 0.3 } finish { reflection 0.2 } }
sphere { <2*clock - 1, 0, 0>, 1 pigment { granite } finish { reflection 0.4 } }
"""
STILL = """#version 3.7;
global_settings { assumed_gamma 1 radiosity { pretrace_start 0.08 pretrace_end 0.02 count 25 recursion_limit 1 } photons { count 3000 } }
camera { location <0, 1, -4> look_at 0 }
light_source { <-5, 5, -5>, 1 }
plane { y, -1 pigment { checker rgb 0.2 rgb 0.9 } finish { reflection 0.2 } }
sphere { 0, 1 photons { target refraction on reflection on } pigment { rgbt 0.9 } interior { ior 1.4 } }
"""


class Job:
    """A scene with a name that has blanks and letters beyond ASCII, in a folder of its own."""

    def __init__(self, program, folder, still, size=(320, 240)):
        self.program, self.folder, self.still = program, pathlib.Path(folder), still
        self.folder.mkdir(parents=True, exist_ok=True)
        self.scene = self.folder / "a scené.pov"
        self.write(STILL if still else ANIMATION)
        self.words = ["a scené.pov", f"+W{size[0]}", f"+H{size[1]}", "+A0.1", "--state-after=0.05"]
        if not still:
            self.words.append("+KFF12")
        self.farm = self.folder / "the farm"

    def write(self, text):
        self.text = text
        self.scene.write_text(text)

    def make_farm(self, engine, *more):
        tasks = "--tasks=16" if self.still else "--tasks=12"
        subprocess.run([self.program, "farm", *self.words, f"--for={engine}", tasks, "-o", "the farm", *more],
                       cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    def pictures(self, folder=None):
        return {p.name: p.read_bytes() for p in (folder or self.folder).glob("*.png") if ".partial." not in p.name}

    def plain(self):
        """The pictures of one run, of the scene as it is now."""
        other = self.folder / "plain"
        other.mkdir(exist_ok=True)
        (other / self.scene.name).write_text(self.text)
        subprocess.run([self.program, *self.words, "--quiet"], cwd=other, check=True)
        return self.pictures(other)

    def script(self, name, *words, **more):
        return subprocess.run(["bash", str(self.farm / name), *words], capture_output=True, text=True, **more)

    def renderers(self):
        """Processes of this job's tasks, by number of the task."""
        found = {}
        mark = str(self.farm / "done") + "/"
        for entry in pathlib.Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                words = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
            except OSError:
                continue
            task = [w[len(mark):].removesuffix(".json") for w in words if w.startswith(mark)]
            if task and os.path.basename(words[0]) == os.path.basename(self.program):
                found[int(task[0])] = int(entry.name)
        return found


def end(process, how=signal.SIGKILL):
    try:
        os.kill(process, how)
        return True
    except ProcessLookupError:
        return False


def differences(found, wanted):
    lines = [f"missing: {name}" for name in sorted(wanted.keys() - found.keys())]
    lines += [f"not asked for: {name}" for name in sorted(found.keys() - wanted.keys())]
    return lines + [f"other bytes: {name}" for name in sorted(found.keys() & wanted.keys()) if found[name] != wanted[name]]
