"""A folder with a scene for the tests of stills in parts, and what they tell."""
import pathlib
import subprocess

HEAD = """#version 3.7;
global_settings { assumed_gamma 1 %s }
camera { location <0, 1, -4> look_at 0 %s }
light_source { <-5, 5, -5>, 1 %s }
plane { y, -1 pigment { checker rgb 0.2 rgb 0.9 } finish { reflection 0.2 } }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.25> } %s }
%s
"""
PLAIN = HEAD % ("", "", "", "finish { reflection 0.4 }", "")
SIZE = ["+W96", "+H71", "+BS8", "+WT2"]


class Trouble(Exception):
    pass


class Place:
    """A folder with a scene, in which the program is called."""

    def __init__(self, program, folder, scene=PLAIN, name="s"):
        self.program, self.folder, self.name = program, pathlib.Path(folder), name
        self.write(scene)

    def write(self, scene):
        (self.folder / f"{self.name}.pov").write_text(scene)

    def call(self, *words, status=0):
        done = subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True)
        if done.returncode != status:
            raise Trouble(f"{words}: status {done.returncode} in place of {status}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def render(self, *words, status=0):
        return self.call(f"{self.name}.pov", *SIZE, *words, status=status)

    def parts(self, number, *words):
        """Renders them, the last one first, and gives their names."""
        for i in range(number, 0, -1):
            self.render(f"--shard={i}/{number}", *words)
        return sorted(p.name for p in self.folder.glob(f"*-of-{number}.whittle-part"))

    def bytes(self, name):
        return (self.folder / name).read_bytes()


def tell(condition, text):
    if not condition:
        raise Trouble(text)


def says(text, *wanted):
    for words in wanted:
        tell(words in text, f"'{words}' is not in:\n{text}")
