"""Eight-bit RGB PNG files, as far as renders and contact sheets need them: no interlacing, no palette."""
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def read(path):
    """(width, height, rows): each row a bytearray of 3 * width samples. An alpha channel is dropped."""
    data = path.read_bytes()
    if data[:8] != SIGNATURE:
        raise ValueError(f"{path} is not a PNG file")
    at, packed, channels, width, height = 8, b"", 3, 0, 0
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", body)
            if depth != 8 or color not in (2, 6) or interlace:
                raise ValueError(f"{path} is not a plain eight-bit RGB picture")
            channels = 3 if color == 2 else 4
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    rows = list(unfiltered(zlib.decompress(packed), width * channels, channels))
    if len(rows) != height:
        raise ValueError(f"{path} is cut short")
    if channels == 4:
        rows = [bytearray(v for i, v in enumerate(row) if i % 4 != 3) for row in rows]
    return width, height, rows


def unfiltered(raw, stride, step):
    """The rows behind PNG's five filters (PNG specification, 9.2)."""
    above = bytearray(stride)
    for start in range(0, len(raw), stride + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        if kind == 1:
            for i in range(step, stride):
                row[i] = (row[i] + row[i - step]) & 255
        elif kind == 2:
            for i in range(stride):
                row[i] = (row[i] + above[i]) & 255
        elif kind == 3:
            for i in range(stride):
                row[i] = (row[i] + ((row[i - step] if i >= step else 0) + above[i]) // 2) & 255
        elif kind == 4:
            for i in range(stride):
                a, b, c = (row[i - step], above[i], above[i - step]) if i >= step else (0, above[i], 0)
                p = a + b - c
                near = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
                row[i] = (row[i] + near) & 255
        yield row
        above = row


def write(path, width, rows):
    """Rows of 3 * width samples, each stored as its difference from the pixel before."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    packed = bytearray()
    for row in rows:
        packed.append(1)
        packed += row[:3]
        packed += bytes((row[i] - row[i - 3]) & 255 for i in range(3, 3 * width))
    path.write_bytes(SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(bytes(packed), 9)) + chunk(b"IEND", b""))
