"""Scenes that POV-Ray does not render the same twice: means of tiles, judged by how far it is from itself."""
import math

import programs

SIZE, TILE = (80, 60), 10
RUNS = ("", "+BS8", "+BS16", "+BS48")  # block sizes change which samples POV-Ray finds first
FACTOR, FLOOR = 1.5, 0.5               # of its own distance, and in steps of 1/255


def tile_means(rows):
    """Means of tiles over each channel, tile after tile."""
    means = []
    for top in range(0, SIZE[1], TILE):
        for left in range(0, SIZE[0], TILE):
            for channel in range(3):
                values = [rows[y][3 * x + channel] for y in range(top, top + TILE) for x in range(left, left + TILE)]
                means.append(sum(values) / len(values))
    return means


def distance(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a))


def verdict(options, folder, name):
    """As programs.verdict, of our picture and several of POV-Ray's."""
    ours = programs.render(options.whittle, folder, name, SIZE, "whittle")
    theirs = [programs.render(f"{options.povray} {switch}", folder, name, SIZE, f"povray{i}") for i, switch in enumerate(RUNS)]
    failed = [one for one in [ours, *theirs] if one.error]
    if failed:
        return programs.verdict(ours, theirs[0])
    means = [tile_means(one.rows) for one in theirs]
    own = []
    for i, one in enumerate(means):  # each run from the mean of the others
        others = [m for k, m in enumerate(means) if k != i]
        own.append(distance(one, [sum(v) / len(v) for v in zip(*others)]))
    noise = math.sqrt(sum(d * d for d in own) / len(own))
    mean = [sum(v) / len(v) for v in zip(*means)]
    mine = tile_means(ours.rows)
    away = distance(mine, mean)
    bias = sum(a - b for a, b in zip(mine, mean)) / len(mean)
    detail = f"tiles {away:.2f} away, POV-Ray {noise:.2f} from itself, bias {bias:+.2f}"
    agrees = away <= FACTOR * noise + FLOOR
    if agrees and not options.keep:
        for left in folder.glob(f"{name}.*"):
            left.unlink()
    return ("agree" if agrees else "differ"), detail
