"""Small picture files of the kinds that scenes read, with palettes and alpha: what an `image_map` and its like make of them is asked by scenes/pictures.py."""
import struct
import zlib

import png

WIDTH, HEIGHT = 10, 7


def write_all(folder):
    """Every file, the same bytes on every machine."""
    (folder / "alpha.png").write_bytes(png_file(8, 6, [[v for x in range(WIDTH) for v in (*color(x, y), alpha(x, y))] for y in range(HEIGHT)]))
    (folder / "gray.png").write_bytes(png_file(8, 0, [[(23 * x + 37 * y) % 256 for x in range(WIDTH)] for y in range(HEIGHT)]))
    (folder / "gray_alpha.png").write_bytes(png_file(8, 4, [[v for x in range(WIDTH) for v in ((23 * x + 37 * y) % 256, alpha(x, y))] for y in range(HEIGHT)]))
    (folder / "deep.png").write_bytes(png_file(16, 0, [[v for x in range(WIDTH) for v in divmod((6131 * x + 4099 * y) % 65536, 256)] for y in range(HEIGHT)]))
    (folder / "palette.png").write_bytes(png_file(8, 3, [[index(x, y) for x in range(WIDTH)] for y in range(HEIGHT)], palette()))
    (folder / "palette_alpha.png").write_bytes(png_file(8, 3, [[index(x, y) for x in range(WIDTH)] for y in range(HEIGHT)], palette(), bytes(255 - 50 * i for i in range(4))))
    pixels = bytes(v for y in range(HEIGHT) for x in range(WIDTH) for v in color(x, y))
    (folder / "colors.ppm").write_bytes(f"P6\n{WIDTH} {HEIGHT}\n255\n".encode() + pixels)
    (folder / "grays.pgm").write_bytes(f"P5\n{WIDTH} {HEIGHT}\n255\n".encode() + bytes((29 * x + 41 * y) % 256 for y in range(HEIGHT) for x in range(WIDTH)))
    (folder / "colors.tga").write_bytes(targa(24))
    (folder / "alpha.tga").write_bytes(targa(32))
    (folder / "palette.gif").write_bytes(gif())


def color(x, y):
    return 25 * x, 36 * y, (41 * x * y + 60) % 256


def alpha(x, y):
    return (60 * x + 85 * y) % 256


def index(x, y):
    return (x * 3 + y * 5 + x * y) % 8


def palette():
    return bytes(v for i in range(8) for v in (36 * i, 255 - 30 * i, (97 * i) % 256))


def png_file(depth, kind, rows, colors=b"", clear=b""):
    chunk = lambda word, body: struct.pack(">I", len(body)) + word + body + struct.pack(">I", zlib.crc32(word + body))
    raw = b"".join(b"\0" + bytes(row) for row in rows)
    return png.SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, depth, kind, 0, 0, 0)) + (chunk(b"PLTE", colors) if colors else b"") \
        + (chunk(b"tRNS", clear) if clear else b"") + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")


def targa(bits):
    pixels = [(*reversed(color(x, y)), alpha(x, y))[:bits // 8] for y in range(HEIGHT) for x in range(WIDTH)]
    return struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, WIDTH, HEIGHT, bits, 0x20 | (8 if bits == 32 else 0)) + bytes(v for pixel in pixels for v in pixel)


def gif():
    """Codes of four bits: a clearing one before each few pixels keeps them so."""
    codes = []
    for at in range(WIDTH * HEIGHT):
        codes += ([8] if at % 5 == 0 else []) + [index(at % WIDTH, at // WIDTH)]
    codes.append(9)
    bits = sum(code << 4 * at for at, code in enumerate(codes))
    packed = bits.to_bytes((4 * len(codes) + 7) // 8, "little")
    return b"GIF89a" + struct.pack("<HHBBB", WIDTH, HEIGHT, 0xf2, 0, 0) + palette() + b"," + struct.pack("<HHHHB", 0, 0, WIDTH, HEIGHT, 0) + b"\x03" + bytes([len(packed)]) + packed + b"\0;"
