"""Pixels that differ, drawn by POV-Ray one at a time. What it shows of a pixel can depend on the pixels before it: the solid that
blocked a light last is asked first and without its box (docs/povray/03, 13.3). A pixel drawn alone has nothing before it."""
import concurrent.futures

import programs

ASKED = 100  # pixels, evenly spread over those that differ; each is a run of POV-Ray


def differing(ours, theirs):
    """(column, row) of each pixel that differs, row by row."""
    return [(x // 3, y) for y, (a, b) in enumerate(zip(ours, theirs)) for x in range(0, len(a), 3)
            if not programs.alike(a, b, x)]


def verdict(ours, povray, folder, name, size, theirs):
    """As programs.verdict, of two pictures that differ: (state, detail), and 'alone' where enough pixels agree that way."""
    off = differing(ours.rows, theirs.rows)
    step = -(-len(off) // ASKED)
    asked = off[::step]

    def still_off(place):
        x, y = place
        part = f"+SC{x + 1} +EC{x + 1} +SR{y + 1} +ER{y + 1}"
        alone = programs.render(f"{povray} {part}", folder, name, size, f"alone_{x}_{y}")
        differs = bool(alone.error) or not programs.alike(ours.rows[y], alone.rows[y], 3 * x)
        for left in folder.glob(f"{name}.alone_{x}_{y}.*"):
            left.unlink()
        return differs

    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        left = sum(pool.map(still_off, asked))
    share = 1 - len(off) * left / len(asked) / (size[0] * size[1])
    detail = f"{programs.agreement(ours.rows, theirs.rows):.4f}; of {len(asked)} such pixels {left} differ where drawn alone"
    return ("alone" if share >= programs.AGREE else "differ"), detail
