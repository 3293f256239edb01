#!/usr/bin/python3
"""Writes the pictures that images.txt was measured with (spec 4, 12.9), beside this file."""
import os

from PIL import Image

WIDTH, HEIGHT = 5, 4
HERE = os.path.dirname(os.path.abspath(__file__))


def color(c, r):
    return ((53 * c + 97 * r + 17) % 256, (29 * c + 151 * r + 80) % 256, (111 * c + 7 * r + 200) % 256)


def save(mode, name, pixel, palette=None):
    picture = Image.new(mode, (WIDTH, HEIGHT))
    if palette:
        picture.putpalette(palette)
    for r in range(HEIGHT):
        for c in range(WIDTH):
            picture.putpixel((c, r), pixel(c, r))
    picture.save(os.path.join(HERE, name))


save("RGB", "vrgb.png", color)
save("RGBA", "vrgba.png", lambda c, r: color(c, r) + ((190 * c + 45 * r + 60) % 256,))
save("P", "vpal.png", lambda c, r: (3 * c + 5 * r) % 7,
     [level for k in range(7) for level in (40 * k + 10, 250 - 35 * k, 90 * k % 256)])
