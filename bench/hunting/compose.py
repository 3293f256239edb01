"""The classes of the hunt, and the scene of a class and a seed.

A class is a feature, two of them (`cuts+glass`) or a class of the differential made large (`wild:media`).
"""
import scenes
from rng import block, lines
from words import common, patterns

from hunting.around import AROUND
from hunting.large_shapes import LARGE
from hunting.looks import LOOKS
from hunting.programs import PROGRAMS
from hunting.shapes import SHAPES
from hunting.sizes import Rng, TooLarge

FORMS = SHAPES | LARGE
WILD = {f"wild:{name}": made for name, made in {**scenes.CLASSES, **scenes.NOISY}.items() if name not in ("commas", "versions", "places")}
FEATURES = [*FORMS, *LOOKS, *AROUND, *PROGRAMS]


def drawn(seed, only=None):
    """The class of a seed: that which is asked for, alone or beside another feature, or any."""
    r = Rng("hunt", seed)
    chance, wild, first, second = r.unit(), r.pick(*WILD), r.pick(*FEATURES), r.pick(*FEATURES)
    if only in WILD or only and "+" in only:
        return only
    if only:
        return only if chance < .4 or only == second else f"{only}+{second}"
    if chance < .15:
        return wild
    return first if chance < .35 or first == second else f"{first}+{second}"


def text(kind, seed):
    """The scene's text and the options that it is rendered with besides."""
    if kind in WILD:
        return f"// {kind} {seed}\n{wild(kind, seed)}\n", ""
    made, options = scene(Rng(kind, seed), kind.split("+"))
    return f"// {kind} {seed}\n{made}\n", options


def wild(kind, seed):
    """The differential's scene as loud as its text ends."""
    for loud in (Rng(kind, seed).pick(2, 4, 8, 16), 2, 1):
        r = Rng(kind, seed)
        r.loud = loud
        try:
            return WILD[kind].scene(r)
        except TooLarge:
            continue
    raise TooLarge


def scene(r, features):
    around = [AROUND[name](r) for name in features if name in AROUND]
    looks = [LOOKS[name](r) for name in features if name in LOOKS]
    plain = [block("texture", common.pigment(r), common.finish(r)) for _ in range(3)]
    target = " ".join(part["target"] for part in around if "target" in part)

    def look():
        return (r.pick(*looks)[1] if looks else r.pick(*plain)) + " " + target

    gathered = lambda key: [part[key] for part in around if key in part]
    settings = block("global_settings", "assumed_gamma 1", *gathered("settings"))
    parts = ["#version 3.7;", settings, f"#declare S = seed({r.whole(1, 99999)});", patterns.NOISE,
             (gathered("camera") or [common.camera(r)])[-1], common.background(r), *(gathered("light") or [common.light(r)])]
    parts += [declared for declared, _ in looks]
    parts += [PROGRAMS[name](r) for name in features if name in PROGRAMS]
    parts += gathered("text")
    forms = [FORMS[name](r, look) for name in features if name in FORMS]
    if not forms:  # something to see the rest on
        forms = [block(*common.solid(r, 1), look(), common.place(r, 1.2)) for _ in range(r.whole(2, 5))]
    stage = r.pick(common.floor(r), f"plane {{ y, -1.03 {look()} }}") if looks else common.floor(r, r.some(.3, common.finish(r)))
    return once(lines(*parts, *forms, stage)), " ".join(gathered("options"))


def once(text):
    """A function may be declared once: what includes bring or the scene has said is not said again."""
    first, *others = text.split(patterns.NOISE)
    return first + ("" if "functions" in text and ".inc" in text else patterns.NOISE) + "".join(others)
