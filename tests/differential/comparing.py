#!/usr/bin/env python3
"""What counts as the same text and the same picture, and pixels drawn alone: by a POV-Ray that is none."""
import pathlib
import tempfile
import unittest
from unittest import mock

import alone
import programs

SIZE = (40, 30)


def picture(*marked):
    """Rows of a grey picture; the marked places, (column, row), are white."""
    rows = [bytearray(b"\x80" * (3 * SIZE[0])) for _ in range(SIZE[1])]
    for x, y in marked:
        rows[y][3 * x:3 * x + 3] = b"\xff\xff\xff"
    return rows


def made(rows, error="", printed=""):
    return programs.Result(rows, error, printed)


class Texts(unittest.TestCase):
    @staticmethod
    def same(ours, theirs):
        return programs.same_text(made(None, printed=ours), made(None, printed=theirs))

    def test_white_space_is_not_compared(self):
        self.assertTrue(self.same("a long\nline", "a lo\nng line\n"))
        self.assertFalse(self.same("a line", "a lime"))

    def test_what_povray_cuts(self):
        line = "".join(str(i) for i in range(120))[:204]
        self.assertTrue(self.same(line, line[:156] + "..."))
        self.assertTrue(self.same("first " + line + " last", "first " + line[:156] + "... last"))
        self.assertFalse(self.same(line[:180], line[:156] + "..."), "24 characters are not cut")
        self.assertFalse(self.same("9" + line, line[:156] + "..."))
        self.assertFalse(self.same(line, line[:156]), "a text that ends early")

    def test_dots_that_both_print(self):
        self.assertTrue(self.same("wait... done", "wait...\ndone"))


class Pictures(unittest.TestCase):
    def test_a_pixel_may_be_off_by_the_tolerance(self):
        near, far = picture(), picture()
        near[5][30] += programs.TOLERANCE
        far[5][30] += programs.TOLERANCE + 1
        self.assertEqual(programs.agreement(picture(), near), 1.0)
        self.assertEqual(programs.agreement(picture(), far), 1 - 1 / (SIZE[0] * SIZE[1]))
        self.assertEqual(alone.differing(picture(), far), [(10, 5)])

    def test_errors_and_texts_come_first(self):
        self.assertEqual(programs.verdict(made(picture(), printed="a"), made(picture(), printed="b"))[0], "differ")
        self.assertEqual(programs.verdict(made(None, "no"), made(picture()))[0], "fault")
        self.assertEqual(programs.verdict(made(None, "no"), made(None, "no"))[0], "refused")


class DrawnAlone(unittest.TestCase):
    """Ours is grey; POV-Ray's whole picture has 20 white pixels more."""
    PLACES = [(2 * i, 3) for i in range(20)]

    def told(self, render):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(programs, "render", render):
            return alone.verdict(made(picture()), "povray", pathlib.Path(folder), "scene", SIZE, made(picture(*self.PLACES)))[0]

    def test_pixels_that_agree_alone(self):
        asked = []

        def render(program, *_):
            asked.append(program.split()[1:])
            return made(picture())

        self.assertEqual(self.told(render), "alone")
        self.assertCountEqual(asked, [[f"+SC{x + 1}", f"+EC{x + 1}", f"+SR{y + 1}", f"+ER{y + 1}"] for x, y in self.PLACES])

    def test_pixels_that_differ_alone(self):
        self.assertEqual(self.told(lambda *_: made(picture(*self.PLACES))), "differ")

    def test_few_may_differ_still(self):
        self.assertEqual(self.told(lambda *_: made(picture(*self.PLACES[:11]))), "alone")
        self.assertEqual(self.told(lambda *_: made(picture(*self.PLACES[:13]))), "differ")

    def test_a_run_that_fails_is_no_agreement(self):
        self.assertEqual(self.told(lambda *_: made(None, "killed by signal 9")), "differ")


if __name__ == "__main__":
    unittest.main()
