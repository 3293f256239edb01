"""What solids tell in Python, against formulas and the command line's own answers."""

import json
import math
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
PARTS = """
#declare Ball = sphere { <0, 1, 0>, 2 pigment { rgb <1, 0.5, 0> } }
#declare Washer = difference { cylinder { 0, y, 2 } cylinder { -y, 2*y, 1 } translate 10*x }
object { Ball }
object { Washer }
light_source { <0, 99, 0>, 1 }
plane { y, -5 }
"""


class Solids(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.path = os.path.join(kept.name, "parts.pov")
        with open(self.path, "w") as file:
            file.write(PARTS)
        self.scene = whittle.Scene(self.path)

    def test_measures_are_those_of_the_command_line(self):
        said = subprocess.run([PROGRAM, "info", self.path, "--json", "--precision=0.005"], capture_output=True, text=True).stdout
        told = {one["object"]: one for one in map(json.loads, said.splitlines())}
        found = {one.name: one for one in self.scene.info(precision=0.005)}
        self.assertEqual(sorted(name for name, one in found.items() if not one.problem), sorted(told))
        for name, one in told.items():
            self.assertEqual(f"{found[name].volume:.12g}", f"{one['volume']:.12g}")
            self.assertEqual([f"{v:.12g}" for v in found[name].centre], [f"{v:.12g}" for v in one["centre"]])
        self.assertLess(abs(found["Washer"].volume - 3 * math.pi), found["Washer"].volume_error)
        [plane] = [one for one in found.values() if one.problem]
        self.assertIn("no end", plane.problem)

    def test_a_mesh_closes_and_lies_on_the_surface(self):
        [ball] = self.scene.mesh(0.02, object="Ball")
        self.assertEqual((ball.problem, ball.name), ("", "Ball"))
        self.assertEqual((ball.vertices.dtype, ball.faces.dtype), (numpy.float32, numpy.uint32))
        out = ball.vertices - numpy.array([0, 1, 0])
        off = numpy.abs(numpy.linalg.norm(out, axis=1) - 2)
        self.assertLess(off.max(), 0.02)
        self.assertLessEqual(ball.deviation, 0.02)
        edges = numpy.sort(ball.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        self.assertTrue((numpy.unique(edges, axis=0, return_counts=True)[1] == 2).all())
        self.assertGreater((ball.normals * out / 2).sum(axis=1).min(), 1 - 1e-6)  # exact, and so are its vertices
        a, b, c = (ball.vertices[ball.faces[:, i]].astype(float) for i in range(3))
        volume = (numpy.cross(a, b) * c).sum() / 6
        self.assertLess(abs(volume - 4 / 3 * math.pi * 8), 0.5)
        self.assertEqual(ball.colors.shape, ball.vertices.shape)
        self.assertAlmostEqual(float(ball.colors[0, 0]), 1.0)

    def test_sections(self):
        found = {one.name: one for one in self.scene.section("y", 0.25)}
        self.assertEqual(len(found["Washer"].loops), 2)
        self.assertAlmostEqual(found["Washer"].area, 3 * math.pi, delta=0.1)
        self.assertAlmostEqual(found["Ball"].area, math.pi * (4 - 0.75**2), delta=0.1)
        self.assertEqual(found["Ball"].loops[0].shape[1], 2)
        self.assertEqual(self.scene.section("y", 7, object="Ball")[0].loops, [])

    def test_spans_of_a_ball_are_those_of_its_formula(self):
        random = numpy.random.default_rng(7)
        origins = random.uniform(-4, 4, (5000, 3))
        directions = random.normal(size=(5000, 3))
        found = self.scene.spans(origins, directions, object="Ball")
        to = origins - [0, 1, 0]
        a = (directions**2).sum(axis=1)
        b = (to * directions).sum(axis=1)
        under = b**2 - a * ((to**2).sum(axis=1) - 4)
        meets = (under > 0) & (-b + numpy.sqrt(numpy.maximum(under, 0)) > 0)
        self.assertTrue(numpy.array_equal(numpy.diff(found.first), meets.astype(int)))
        root = numpy.sqrt(under[meets])
        expected = numpy.stack([(-b[meets] - root) / a[meets], (-b[meets] + root) / a[meets]], axis=1)
        self.assertLess(numpy.abs(found.ends - expected).max(), 1e-9)
        self.assertTrue(numpy.array_equal(found.ray, numpy.nonzero(meets)[0]))

    def test_spans_of_what_has_no_end(self):
        found = self.scene.spans([[30.0, 0, 0], [30.0, -7, 0], [30.0, 0, 0]], [[0, -2.0, 0], [0, 1.0, 0], [0, 1.0, 0]])
        self.assertEqual(found[0].tolist(), [[2.5, math.inf]])
        self.assertEqual(found[1][0, 1], 2.0)
        self.assertLessEqual(found[1][0, 0], 0.0)
        self.assertEqual(len(found[2]), 0)

    def test_a_million_rays_in_one_call(self):
        random = numpy.random.default_rng(1)
        origins = numpy.concatenate([random.uniform(-3, 13, (1_000_000, 1)), numpy.full((1_000_000, 1), 9.0),
                                     random.uniform(-3, 3, (1_000_000, 1))], axis=1)
        directions = numpy.broadcast_to([0.0, -1.0, 0.0], origins.shape)
        start = time.monotonic()
        found = self.scene.spans(origins, directions)
        seconds = time.monotonic() - start
        print(f"{len(found) / seconds / 1e6:.2f} million rays a second, {len(found.ends)} spans")
        self.assertEqual(len(found), 1_000_000)
        inside = numpy.abs(numpy.hypot(origins[:, 0] - 10, origins[:, 2]) - 1.5) < 0.5 - 1e-6
        washer = found.names.index("Washer")
        self.assertEqual(int((found.object == washer).sum()), int(inside.sum()))

    def test_an_interrupt_ends_long_questions(self):
        many = numpy.tile([[0.0, 9.0, 0.0]], (3_000_000, 1))  # tiles ask 200 rings for 300,000 in 0.3 s
        down = numpy.broadcast_to([0.0, -1.0, 0.0], many.shape)
        rings = whittle.Scene("union {" + "".join(f"torus {{ {i / 40 + 0.1}, 0.1 }}" for i in range(200)) + "}")
        for ask in (
            lambda: self.scene.mesh(1e-5, object="Washer"),
            lambda: self.scene.info(precision=1e-9),
            lambda: rings.spans(many, down),
        ):
            sent = []

            def interrupt():
                sent.append(time.monotonic())
                os.kill(os.getpid(), signal.SIGINT)

            threading.Timer(0.4, interrupt).start()
            with self.assertRaises(KeyboardInterrupt):
                ask()
            self.assertLess(time.monotonic() - sent[0], 0.5)

    def test_what_cannot_be_is_said(self):
        with self.assertRaisesRegex(ValueError, "Ball"):
            self.scene.mesh(object="Bell")
        with self.assertRaises(ValueError):
            self.scene.spans([[0, 0, 0]], [[0, 0, 0]])
        with self.assertRaises(ValueError):
            self.scene.spans([0, 0, 0], [0, 0, 1])
        with self.assertRaises(ValueError):
            self.scene.mesh(-1)
        with self.assertRaises(ValueError):
            self.scene.section("w", 0)

    def test_comparisons_are_those_of_the_command_line(self):
        folder = os.path.dirname(self.path)
        a, b = os.path.join(folder, "a.png"), os.path.join(folder, "b.png")
        text = PARTS + "camera { location <5, 6, -14> look_at <5, 0, 0> }"
        first, second = whittle.render(text, width=64, height=48), whittle.render(text, width=64, height=48, antialias=0.1)
        first.save(a)
        second.save(b)
        said = subprocess.run([PROGRAM, "compare", a, b, "--flip"], capture_output=True, text=True).stdout
        for found in (whittle.compare(first, second, flip=True), whittle.compare(a, b, flip=True)):
            self.assertIn(f"{100 * found.agreeing:.4f} %", said)
            self.assertIn(f"{found.rmse:.4f} of 255", said)
            self.assertIn(f"{found.psnr:.2f} dB", said)
            self.assertIn(f"{found.ssim:.6f}", said)
            self.assertIn(f"{found.flip:.6f}", said)
            self.assertIn(f"({found.worst[0]}, {found.worst[1]})", said)
        with self.assertRaises(OSError):
            whittle.compare(first, whittle.render(text, width=32, height=48))


unittest.main()
