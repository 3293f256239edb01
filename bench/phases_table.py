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


COLUMNS = [("scene", "scene", "s"), ("threads", "threads", "d"), ("povray_trace_s", "POV-Ray s", ".3f"),
           ("whittle_trace_s", "ours s", ".3f"), ("ratio", "ratio", ".2f"), ("agree", "agree", ".4f"),
           ("povray_parse_s", "parse, POV-Ray s", ".3f"), ("whittle_parse_s", "ours s", ".3f")]


def markdown(rows):
    lines = ["| " + " | ".join(title for _, title, _ in COLUMNS) + " | |",
             "|---|" + "---:|" * (len(COLUMNS) - 1) + "---|"]
    for row in rows:
        lines.append("| " + " | ".join(format(row[key], form) for key, _, form in COLUMNS) + f" | {remark(row)} |")
    return "\n".join(lines)


def plain(rows):
    width = max((len(row["scene"]) for row in rows), default=5)
    lines = [f"{'scene':<{width}} {'threads':>7} {'POV-Ray s':>10} {'ours s':>9} {'ratio':>8} {'agree':>7}"]
    for row in rows:
        times = f"{row['povray_trace_s']:>10.3f} {row['whittle_trace_s']:>9.3f} {row['ratio']:>8.2f}"
        line = f"{row['scene']:<{width}} {row['threads']:>7} {times} {row['agree']:>7.4f}  {remark(row)}"
        lines.append(line.rstrip())
    return "\n".join(lines)


def summary(rows):
    """What all rows together tell, {title: number or text}; the worst row is the first."""
    if not rows:
        return {}
    ratios = [row["ratio"] for row in rows]
    povray, whittle = (sum(row[f"{who}_trace_s"] for row in rows) for who in ("povray", "whittle"))
    parse = [sum(row[f"{who}_parse_s"] for row in rows) for who in ("povray", "whittle")]
    longest = max(rows, key=lambda row: row["whittle_trace_s"])
    return {"pairs": len(rows),
            "geometric mean": round(statistics.geometric_mean(ratios), 2),
            "total ratio": round(povray / whittle, 2),
            "POV-Ray trace s": round(povray, 1),
            "ours trace s": round(whittle, 1),
            "total ratio of parsing": round(parse[0] / max(parse[1], 1e-4), 2),
            "least ratio": f"{rows[0]['ratio']} ({rows[0]['scene']})",
            "our longest": f"{longest['whittle_trace_s']:.3f} s ({longest['scene']})"}
