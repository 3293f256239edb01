"""The classes of random scenes: one file each, a function scene(rng) that returns the text."""
import png
from rng import Rng
from scenes import cameras, csg, finishes, language, lights, radiosity, solids, textures, versions

CLASSES = {"lights": lights, "finishes": finishes, "cameras": cameras, "csg": csg, "textures": textures,
           "language": language, "versions": versions, "solids": solids}
NOISY = {"radiosity": radiosity}  # not the same twice in POV-Ray: judged apart, and never recorded


def text(kind, seed):
    """The scene of a class and a seed."""
    return f"// {kind} {seed}\n" + {**CLASSES, **NOISY}[kind].scene(Rng(kind, seed)) + "\n"


def write_companions(folder):
    """The picture that scenes with image_map and the like name: 12x8 pixels, every one another colour."""
    rows = [bytearray(v for x in range(12) for v in (21 * x, 31 * y, (37 * x * y + 90) % 256)) for y in range(8)]
    png.write(folder / "picture.png", 12, rows)
