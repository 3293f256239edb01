"""Changes a scene's text in a few places, which a random stream draws."""
import re

from . import additions

TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?|[A-Za-z_]\w*|\s+|.', re.S)
NUMBER = re.compile(r"\.?\d")
ALIKE = [words.split() for words in (
    " ".join(additions.PATTERNS), "ramp_wave triangle_wave sine_wave scallop_wave cubic_wave", "union merge intersection difference",
    "rotate translate scale", "ambient diffuse phong specular brilliance metallic reflection", "roughness phong_size", "rgb rgbf rgbt rgbft", "x y z",
    "checker hexagon brick", "sphere box", "linear_spline quadratic_spline cubic_spline bezier_spline", "linear_sweep conic_sweep",
    "color_map pigment_map", "absorption emission", "turbulence frequency phase octaves omega lambda", "spotlight cylinder shadowless parallel",
    "perspective orthographic fisheye ultra_wide_angle panoramic", "sin cos tan abs sqrt", "red green blue", "radius falloff tightness", "on off",
    "up right direction", "White Red Blue Yellow Green Gray50 Black Brown")]
FAMILY = {word: words for words in ALIKE for word in words}
PARTS = {"texture", "pigment", "normal", "finish", "interior", "media", "clipped_by", "bounded_by", "fog", "photons"}
SWAPPED = {*additions.SOLIDS, "texture", "pigment", "normal", "finish", "interior", "camera", "light_source", "color_map", "media", "density"}
LONGEST = 400  # tokens of a block that is taken away


def blocks(tokens):
    """(keyword, place of it, of the opening and of the closing brace) of all blocks."""
    found, opened, before = [], [], None
    for i, token in enumerate(tokens):
        if token.isspace() or token.startswith(("//", "/*")):
            continue
        if token == "{":
            opened.append((before, i))
        elif token == "}" and opened:
            word, begin = opened.pop()
            if word is not None:
                found.append((tokens[word], word, begin, i))
        before = i
    return found


def change_number(rng, tokens):
    places = [i for i, token in enumerate(tokens) if NUMBER.match(token)]
    if places:
        place = rng.pick(*places)
        value = float(tokens[place])
        tokens[place] = f" ({rng.pick(1.3 * value, 0.7 * value, 2 * value, 0.5 * value, -value, 0, 1, value + 1, 10 * value):.5g}) "


def change_word(rng, tokens):
    places = [i for i, token in enumerate(tokens) if token in FAMILY]
    if places:
        place = rng.pick(*places)
        tokens[place] = rng.pick(*FAMILY[tokens[place]])


def add_to_block(rng, tokens):
    found = [block for block in blocks(tokens) if block[0] in additions.TO_BLOCK]
    if found:
        kind = rng.pick(*sorted({block[0] for block in found}))
        end = rng.pick(*[block for block in found if block[0] == kind])[3]
        tokens.insert(end, f" {additions.TO_BLOCK[kind](rng)} ")


def take_block(rng, tokens):
    found = [block for block in blocks(tokens) if block[3] - block[2] < LONGEST and (block[0] in PARTS or block[0] in additions.SOLIDS)]
    if found:
        _, word, _, end = rng.pick(*found)
        del tokens[word:end + 1]


def copy_block(rng, tokens):
    """Writes one block in the place of another of its kind."""
    found = [block for block in blocks(tokens) if block[0] in SWAPPED]
    if found:
        one = rng.pick(*found)
        other = rng.pick(*[block for block in found if block[0] == one[0]])
        tokens[one[2]:one[3] + 1] = tokens[other[2]:other[3] + 1]


def add_to_scene(rng, tokens):
    text = f"\n{additions.to_scene(rng)}\n"
    tokens.insert(0 if rng.chance(0.5) else len(tokens), text)


CHANGES = [change_number] * 5 + [change_word] * 5 + [add_to_block] * 6 + [take_block, copy_block] + [add_to_scene] * 2


def changed(rng, text):
    """The text with two to nine changes."""
    for _ in range(rng.whole(2, 9)):
        tokens = TOKEN.findall(text)
        rng.pick(*CHANGES)(rng, tokens)
        text = "".join(tokens)
    return text
