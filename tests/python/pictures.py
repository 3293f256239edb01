"""Pictures from Python are those of the command line; mistakes, threads and interrupts are told as Python tells them."""

import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

try:
    import numpy
except ImportError:
    sys.exit(77)
import whittle

PROGRAM = sys.argv.pop(1)
SOURCE = os.environ["WHITTLE_SOURCE"]
BALL = """
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -6>, 1 }
sphere { 0, 1 pigment { rgb <1, 0.4, 0.1> } finish { phong 0.6 } }
plane { y, -1 pigment { checker rgb 0.2, rgb 0.9 } finish { reflection 0.3 } }
"""
#: Takes a minute or more: nobody waits for its end.
LONG = BALL + "global_settings { radiosity { count 1000 error_bound 0.05 nearest_count 20 } }" + "".join(
    f"sphere {{ <{i % 9 - 4}, {i // 9}, 3>, 0.5 pigment {{ rgbt <1, 1, 1, 0.5> }} interior {{ ior 1.3 }} "
    "finish { reflection 0.5 } }\n"
    for i in range(81)
)


def by_program(folder, scene, *words):
    """The file that the command line makes."""
    out = os.path.join(folder, "program.png")
    given = scene if isinstance(scene, str) and "{" in scene else None
    command = [PROGRAM, *words, "+I-" if given else os.fspath(scene), f"Output_File_Name={out}"]
    subprocess.run(command, input=given, text=True, check=True, capture_output=True, timeout=60)
    with open(out, "rb") as file:
        return file.read()


class Pictures(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = kept.name

    def saved(self, picture, name="python.png"):
        path = os.path.join(self.folder, name)
        picture.save(path)
        with open(path, "rb") as file:
            return file.read()

    def test_files_have_the_same_bytes(self):
        scene = os.path.join(SOURCE, "scenes/csg/bite.pov")
        for words, asked in [
            ((), {}),
            (("+A0.2",), {"antialias": 0.2}),
            (("--samples=3",), {"options": ["--samples=3"]}),
            (("--integrator=path", "--samples=2"), {"options": ["--integrator=path", "--samples=2"]}),
            (("+FN16",), {"options": ["+FN16"]}),
            (("+UA",), {"options": ["+UA"]}),
        ]:
            with self.subTest(words=words):
                picture = whittle.render(scene, width=80, height=60, **asked)
                self.assertEqual(self.saved(picture), by_program(self.folder, scene, "+W80", "+H60", *words))

    def test_a_text_is_what_standard_input_is(self):
        picture = whittle.render(BALL, width=64, height=48)
        self.assertEqual(self.saved(picture), by_program(self.folder, BALL, "+W64", "+H48"))

    def test_a_picture_that_is_looked_at_has_the_same_bytes(self):
        plain = whittle.Scene(BALL)
        seen = []
        words = ["Width=200", "Height=150", "Antialias=on", "Antialias_Threshold=0.1"]
        made = plain._source.render([], words, None, "", seen.append)
        other = plain.render(width=200, height=150, antialias=0.1)
        self.assertTrue(numpy.array_equal(made.light, other._made.light))
        self.assertGreater(len(seen), 0)
        self.assertEqual(seen[0].light.shape, (150, 200, 4))

    def test_constants_are_declared_as_on_the_command_line(self):
        text = "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <Level, 0, 0> } #debug Name"
        picture = whittle.render(text, width=2, height=2, Level=0.123456789, Name="a 'b' c")
        self.assertEqual([m.text for m in picture.messages if m.severity == "debug"], ["a 'b' c"])
        self.assertAlmostEqual(float(picture.linear[0, 0, 0]), 0.123457, places=7)

    def test_arrays_are_views(self):
        picture = whittle.render(BALL, width=32, height=24)
        for array in (picture.linear, picture.pixels, picture.transmit):
            self.assertFalse(array.flags.owndata)
            self.assertFalse(array.flags.writeable)
        self.assertEqual(picture.pixels.dtype, numpy.uint8)
        kept = picture.pixels
        del picture
        self.assertEqual(kept.shape, (24, 32, 3))
        self.assertGreater(int(kept.max()), 200)
        deep = whittle.render(BALL, width=8, height=6, options=["Bits_Per_Color=16"])
        self.assertEqual(deep.pixels.dtype, numpy.uint16)

    def test_light_is_linear_whatever_the_scene_assumes(self):
        text = "global_settings { assumed_gamma 2.2 } background { rgb 0.5 }"
        picture = whittle.render(text, width=2, height=2)
        self.assertAlmostEqual(float(picture.linear[0, 0, 0]), 0.5**2.2, places=5)

    def test_a_mistake_is_an_exception_with_its_place(self):
        with self.assertRaises(whittle.SceneError) as caught:
            whittle.render("sphere { 0, 1 }\nshpere { 0, 1 }")
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column), ("text", 2, 1))
        self.assertIn("did you mean 'sphere'", error.message)
        self.assertIn("shpere { 0, 1 }", str(error))
        with self.assertRaises(whittle.SceneError):
            whittle.render("no_such_scene.pov")
        with self.assertRaises(ValueError):
            whittle.render(BALL, options=["--no-such-option"])
        for wrong in (
            {"layers": "depht"},
            {"width": 0},
            {"width": 10**9, "height": 10**9},
            {"antialias": float("nan")},
            {"camera": "sphere { 0, 1 }"},
            {"options": ["--denoise"]},
            {"options": ["Shutter=0.5"]},
        ):
            with self.subTest(wrong=wrong), self.assertRaises(ValueError):
                whittle.render(BALL, **wrong)
        with self.assertRaises(whittle.SceneError):
            whittle.render(BALL, camera="camera { location")
        with self.assertRaises(OSError):
            whittle.render(BALL, width=8, height=6).save("/no/such/folder/x.png")

    def test_a_scene_is_read_again_only_where_it_has_to(self):
        counted = os.path.join(self.folder, "scene.pov")
        with open(counted, "w") as file:
            file.write(BALL + '#debug "read"')
        scene = whittle.Scene(counted)
        with open(counted, "w") as file:
            file.write("sphere {")  # whoever reads it again fails
        small = scene.render(width=32, height=24)
        scene.render(width=64, height=48, camera={"location": (0, 2, -6), "look_at": (0, 0, 0)}, clock=0.5)
        self.assertEqual((small.width, small.height), (32, 24))
        with self.assertRaises(whittle.SceneError):
            scene.render(width=32, height=24, Other=1)

    def test_clock_and_size_reach_the_text(self):
        scene = whittle.Scene("#version 3.7; global_settings { assumed_gamma 1 } background { rgb <clock, image_width / 100, 0> }")
        for clock, width in [(0, 10), (1, 10), (1, 50), (0.5, 50)]:
            light = scene.render(width=width, height=4, clock=clock).linear[0, 0]
            self.assertEqual([round(float(v), 6) for v in light], [clock, width / 100, 0])

    def test_another_camera_is_that_of_the_text(self):
        moved = BALL.replace("camera { location <0, 1, -4> look_at 0 }", "camera { location <2, 1, -4> look_at 0 }")
        ours = whittle.Scene(BALL).render(width=40, height=30, camera="camera { location <2, 1, -4> look_at 0 }")
        self.assertTrue(numpy.array_equal(ours.linear, whittle.render(moved, width=40, height=30).linear))

    def test_layers(self):
        picture = whittle.render(BALL, width=40, height=30, layers=["depth", "normal", "object"])
        self.assertEqual(picture.layers["normal"].shape, (30, 40, 3))
        self.assertEqual(picture.layers["depth"].shape, (30, 40))
        self.assertAlmostEqual(float(numpy.linalg.norm(picture.layers["normal"][15, 20])), 1.0, places=5)
        self.assertEqual(sorted({int(v) for v in numpy.unique(picture.layers["object"])}), [0, 2, 3])

    def test_other_threads_go_on(self):
        ticks = []
        ended = threading.Event()

        def tick():
            while not ended.wait(0.005):
                ticks.append(time.monotonic())

        ticking = threading.Thread(target=tick)
        ticking.start()
        picture = whittle.render(BALL, width=400, height=300, antialias=0.0, threads=1)
        ended.set()
        ticking.join()
        self.assertGreater(len(ticks), picture.seconds / 0.005 / 4)
        self.assertGreater(picture.seconds, 0.05)

    def test_two_pictures_at_once(self):
        alone = whittle.render(BALL, width=64, height=48)
        made = [None] * 4

        def make(i):
            made[i] = whittle.render(BALL, width=64, height=48)

        threads = [threading.Thread(target=make, args=(i,)) for i in range(len(made))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for one in made:
            self.assertTrue(numpy.array_equal(one.linear, alone.linear))

    def test_an_interrupt_ends_a_render_within_half_a_second(self):
        begun = []

        def interrupt():
            time.sleep(0.7)
            begun.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        for asked in ({}, {"options": ["--integrator=path", "--samples=10000"]}):
            thread = threading.Thread(target=interrupt)
            thread.start()
            with self.assertRaises(KeyboardInterrupt):
                whittle.render(LONG, width=1600, height=1200, antialias=0.01, **asked)
            self.assertLess(time.monotonic() - begun[-1], 0.5)
            thread.join()
        self.assertEqual(whittle.render(BALL, width=8, height=6).width, 8)  # and the next one is made

    def test_an_interrupt_ends_a_reading(self):
        def interrupt():
            time.sleep(0.3)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            whittle.render("#while (1) #end")
        thread.join()


unittest.main()
