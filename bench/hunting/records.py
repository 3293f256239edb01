"""The hunt's log: a line of JSON a scene; a later line about the same scene adds to the earlier one."""
import collections
import json


class Log:
    def __init__(self, path):
        self.path, self.rows = path, {}
        if path.exists():
            for line in path.read_text().splitlines():
                self.take(json.loads(line))

    def take(self, row):
        self.rows.setdefault((row["class"], row["seed"]), {}).update(row)

    def add(self, row):
        self.take(row)
        with self.path.open("a") as file:
            file.write(json.dumps(row) + "\n")

    def known(self, kind, seed):
        return (kind, seed) in self.rows

    def ranked(self, memory=False):
        """Those that fail, then those that count, the worst first."""
        rows = self.rows.values()
        excess = lambda row: row["povray_mb"] - row["whittle_mb"]
        counted = sorted((row for row in rows if row["state"] == "counts"), key=excess if memory else lambda row: row["ratio"])
        return [row for row in rows if row["state"] == "fault"] + counted

    def summary(self):
        states = collections.Counter(row["state"] for row in self.rows.values())
        ratios = [row["ratio"] for row in self.rows.values() if row["state"] == "counts"]
        below = ", ".join(f"{sum(ratio < bar for ratio in ratios)} below {bar}" for bar in (0.5, 1, 2, 3.5))
        return f"{len(self.rows)} scenes: " + ", ".join(f"{count} {state}" for state, count in states.most_common()) + f"; {below}"


def line(row):
    """A row as text."""
    name = f"{row['class']} {row['seed']}"
    if row["state"] != "counts":
        return f"{name:<40} {row['state']}: {row.get('why', '')}"
    agree = "" if row["agree"] is None or row["agree"] > .95 else f"  agree {row['agree']}"
    return (f"{name:<40} {row['povray_s']:>8.2f} / {row['whittle_s']:>7.2f} s = {row['ratio']:>7.2f}  {row['povray_mb']:>7.0f} / {row['whittle_mb']:>6.0f} MB"
            f" {row['size']:<5} {'; '.join(row.get('top', []))}{agree}")
