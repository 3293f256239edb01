"""--partial: a valid picture on disk while a render runs, left by a cancelled run, taken up by +C; never without being asked for.

usage: partial.py WHITTLE
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

BYTES = 3 * 640 * 480

# Some seconds on any machine: every pixel asks an isosurface of noise.
SLOW = """#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
camera { location <0, 0, -4> look_at 0 }
light_source { <5, 8, -6> rgb 1 }
isosurface {
  function { x*x + y*y + z*z - 1 + 0.4*f_noise3d(x*9, y*9, z*9) + 0.1*f_noise3d(x*40, y*40, z*40) }
  contained_by { box { -1.5, 1.5 } } max_gradient 12 accuracy 1e-7 pigment { rgb <1, 0.6, 0.2> }
}
"""


def read(path):
    """The bytes of a picture in PPM, which has to be whole."""
    with open(path, "rb") as file:
        data = file.read()
    assert data.startswith(b"P6") and len(data) > BYTES, len(data)
    return data[-BYTES:]


def main():
    program = os.path.abspath(sys.argv[1])
    folder = tempfile.mkdtemp(prefix="whittle-partial-")
    picture, scene = os.path.join(folder, "out.ppm"), os.path.join(folder, "slow.pov")
    with open(scene, "w") as out:
        out.write(SLOW)
    words = [program, scene, "+W640", "+H480", "+A0.05", "+R4", "+WT1", "+FP", "+O" + picture]

    def start(*more):
        return subprocess.Popen(words + list(more), stderr=subprocess.DEVNULL)

    try:
        # Asked for: it comes, it grows, a cancelled run leaves it.
        run = start("--partial=0.1")
        seen = set()
        deadline = time.monotonic() + 60
        while len(seen) < 3 and run.poll() is None and time.monotonic() < deadline:
            if os.path.exists(picture):
                seen.add(sum(b != 0 for b in read(picture)))  # whole whenever it is looked at
            time.sleep(0.01)
        assert len(seen) >= 3, f"{len(seen)} pictures were seen, status {run.poll()}"
        run.send_signal(signal.SIGINT)
        assert run.wait(10) == 2
        left = sum(b != 0 for b in read(picture))
        assert left >= max(seen), (left, seen)
        assert not os.path.exists(os.path.join(folder, "out.partial.png"))

        # +C goes on, and the picture is that of an undisturbed run.
        assert start("--partial=0.1", "+C").wait(300) == 0
        resumed = read(picture)
        assert start().wait(300) == 0
        assert read(picture) == resumed
        assert sorted(os.listdir(folder)) == ["out.ppm", "slow.pov"], os.listdir(folder)

        # Not asked for: what was there stays.
        run = start()
        time.sleep(0.5)
        run.send_signal(signal.SIGINT)
        if run.wait(10) == 2:
            assert read(picture) == resumed
        bad = os.path.join(folder, "bad.pov")
        with open(bad, "w") as out:
            out.write("sphere {")
        words[1] = bad
        assert start("--partial=0.1").wait(30) == 1  # a scene that fails has no picture to put there
        assert read(picture) == resumed
    finally:
        shutil.rmtree(folder)
    print("passed")


main()
