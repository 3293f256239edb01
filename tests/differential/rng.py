"""Random pieces of scene text, the same for a seed on every machine and in every version of Python."""
import random


class Rng:
    """Draws from the one method of `random` whose stream Python promises to keep for a seed."""

    def __init__(self, kind, seed):
        self._random = random.Random(f"{kind} {seed}").random

    def unit(self):
        """[0, 1)."""
        return self._random()

    def chance(self, probability):
        return self._random() < probability

    def whole(self, low, high):
        """An integer, both ends included."""
        return low + int(self._random() * (high - low + 1))

    def pick(self, *options):
        return options[int(self._random() * len(options))]

    def made(self, *makers):
        """What one of the makers gives: unlike with pick, the others are not called."""
        return self.pick(*makers)()

    def some(self, probability, text):
        """`text` or nothing."""
        return text if self._random() < probability else ""

    def real(self, low, high):
        """A number of three decimals: what is written into the text is what is meant."""
        return round(low + self._random() * (high - low), 3)

    def num(self, low, high):
        return f"{self.real(low, high):g}"

    def vec(self, low, high):
        return f"<{self.num(low, high)}, {self.num(low, high)}, {self.num(low, high)}>"

    def box(self, x, y, z):
        """A vector with a range (low, high) for each coordinate."""
        return f"<{self.num(*x)}, {self.num(*y)}, {self.num(*z)}>"

    def color(self, low=0.0, high=1.0):
        return f"rgb {self.vec(low, high)}"

    def shuffled(self, items):
        """The items in another order."""
        items = list(items)
        for last in range(len(items) - 1, 0, -1):
            other = self.whole(0, last)
            items[last], items[other] = items[other], items[last]
        return items

    def few(self, low, high, items):
        """Between `low` and `high` of the items, in a random order."""
        return self.shuffled(items)[:self.whole(low, high)]


def lines(*parts):
    """The parts that are not empty, a line each."""
    return "\n".join(part for part in parts if part)


def block(word, *parts):
    """`word { parts }`, a line for each part that is not empty."""
    inside = "\n".join("  " + line for line in lines(*parts).split("\n"))
    return f"{word} {{\n{inside}\n}}"
