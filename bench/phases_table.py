"""What bench/phases.py tells: the rows of its table as text and as markdown, and what they come to."""
import statistics

MATCH = 0.99  # share of the pixels within 3/255


def remark(row):
    """What a reader must know beside the numbers of a row."""
    parts = [f"POV-Ray with itself {row['own_agree']:.4f}"] if row["agree"] < MATCH and row["own_agree"] else []
    if row.get("explained"):
        parts.append("differs as docs/parity.md tells")
    if not row["matches"]:
        parts.append("WRONG PICTURE")
    if row["left_out"]:
        parts.append(f"ours without {', '.join(row['left_out'])}")
    return "; ".join(parts)


def columns(phase):
    """(key, title, format) of what the markdown shows: the phase that counts, and the reading before it or what it is made of."""
    beside = {"trace": [("parse_s", "parse", ".3f")], "total": [("parse_s", "parse", ".3f"), ("trace_s", "trace", ".3f"), ("mb", "memory", ".0f")]}[phase]
    pairs = [(f"{who}_{key}", f"{title}, POV-Ray {unit}" if who == "povray" else f"ours {unit}", form)
             for key, title, form in beside for unit in ("MB" if key == "mb" else "s",) for who in ("povray", "whittle")]
    return [("scene", "scene", "s"), ("threads", "threads", "d"), (f"povray_{phase}_s", "POV-Ray s", ".3f"),
            (f"whittle_{phase}_s", "ours s", ".3f"), ("ratio", "ratio", ".2f"), ("agree", "agree", ".4f"), *pairs]


def markdown(rows, phase):
    shown = columns(phase)
    lines = ["| " + " | ".join(title for _, title, _ in shown) + " | |", "|---|" + "---:|" * (len(shown) - 1) + "---|"]
    for row in rows:
        lines.append("| " + " | ".join(format(row[key], form) for key, _, form in shown) + f" | {remark(row)} |")
    return "\n".join(lines)


def plain(rows, phase):
    width = max((len(row["scene"]) for row in rows), default=5)
    memory = f" {'POV-Ray MB':>10} {'ours MB':>8}" if phase == "total" else ""
    lines = [f"{'scene':<{width}} {'threads':>7} {'POV-Ray s':>10} {'ours s':>9} {'ratio':>8} {'agree':>7}{memory}"]
    for row in rows:
        times = f"{row[f'povray_{phase}_s']:>10.3f} {row[f'whittle_{phase}_s']:>9.3f} {row['ratio']:>8.2f}"
        peaks = f" {row['povray_mb']:>10.0f} {row['whittle_mb']:>8.0f}" if memory else ""
        line = f"{row['scene']:<{width}} {row['threads']:>7} {times} {row['agree']:>7.4f}{peaks}  {remark(row)}"
        lines.append(line.rstrip())
    return "\n".join(lines)


def summary(rows, phase):
    """What all rows together tell, {title: number or text}; the worst row is the first."""
    if not rows:
        return {}
    ratios = [row["ratio"] for row in rows]
    povray, whittle = (sum(row[f"{who}_{phase}_s"] for row in rows) for who in ("povray", "whittle"))
    parse = [sum(row[f"{who}_parse_s"] for row in rows) for who in ("povray", "whittle")]
    longest = max(rows, key=lambda row: row[f"whittle_{phase}_s"])
    memory = max(rows, key=lambda row: row["whittle_mb"] - row["povray_mb"])
    return {"pairs": len(rows),
            "geometric mean": round(statistics.geometric_mean(ratios), 2),
            "tenth of the scenes below": round(sorted(ratios)[len(ratios) // 10], 2),
            "total ratio": round(povray / whittle, 2),
            f"POV-Ray {phase} s": round(povray, 1),
            f"ours {phase} s": round(whittle, 1),
            "total ratio of parsing": round(parse[0] / max(parse[1], 1e-4), 2),
            "least ratio": f"{rows[0]['ratio']} ({rows[0]['scene']})",
            "our longest": f"{longest[f'whittle_{phase}_s']:.3f} s ({longest['scene']})",
            "most memory above POV-Ray's": f"{memory['whittle_mb'] - memory['povray_mb']:.0f} MB ({memory['scene']})"}
