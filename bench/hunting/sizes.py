"""Sizes over magnitudes, and scenes of the differential made large."""
import rng


class TooLarge(Exception):
    """A text without end."""


class Rng(rng.Rng):
    """Draws text as the differential does; up to `loud` times as many of what it counts, now and then. What counts from 0
    is left: such numbers are indices as often."""
    loud = 1
    most = 100_000  # draws: trees whose depth was made large do not end

    def unit(self):
        self.most -= 1
        if self.most < 0:
            raise TooLarge
        return super().unit()

    def chance(self, probability):
        return self.unit() < probability

    def pick(self, *options):
        return options[int(self.unit() * len(options))]

    def whole(self, low, high):
        count = low + int(self.unit() * (high - low + 1))
        return count if self.loud == 1 or low < 1 or self.unit() > .3 else max(count, int(high * self.loud ** self.unit()))

    def amount(self, low, high):
        """A whole number, each magnitude of it as likely as another."""
        return int(round(low * (high / low) ** self.unit()))

    def size(self, low, high):
        """A number of that kind as text."""
        return f"{low * (high / low) ** self.unit():.3g}"


def loop(count, text, name="I"):
    """The text so often, in a loop of the scene's: what differs from turn to turn is drawn there."""
    return f"#for ({name}, 1, {count})\n{text}\n#end"


def drawn(low, high):
    """A number that a loop of the scene draws anew."""
    return f"({low:g} + {high - low:g}*rand(S))"


def spot(spread=2.2, low=-.9, high=1.5):
    """A place on the stage, drawn by the scene."""
    return f"<{drawn(-spread, spread)}, {drawn(low, high)}, {drawn(-spread, spread)}>"


def turned():
    return "rotate <360*rand(S), 360*rand(S), 0>"
