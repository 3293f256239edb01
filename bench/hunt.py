#!/usr/bin/python3
"""Looks for scenes that Whittle renders slowly in comparison with POV-Ray.

usage: bench/hunt.py [--seeds A-B] [--only CLASS] [--resume] [--log FILE]     tries the scenes of seeds A to B and ranks the log
       bench/hunt.py --rank [--memory] [--worst 20] [--profile]               ranks what the log has, by ratio or by memory
       bench/hunt.py --print CLASS SEED                                       prints the scene's text, and its options, if any, on stderr
       bench/hunt.py --classes                                                the names that --only takes; two of them are joined by +

A seed draws one or two features of the language and a scene that is heavy with them. What counts is the processor seconds of the
whole run at 320x240 on one thread, of scenes that POV-Ray renders in 0.1 s or more and in less than --limit. A picture of 160x120
comes first: where Whittle is --enough times as fast there, the large one is left out (--full renders all of them). A scene that
Whittle alone refuses or does not finish is a find, too. --profile asks perf for the three longest functions of the worst scenes.
See README.md.
"""
import argparse
import pathlib
import sys
import tempfile

import speed
from hunting import compose, measure, records


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="0-99")
    parser.add_argument("--only", metavar="CLASS", help="scenes of this class, alone and beside others")
    parser.add_argument("--resume", action="store_true", help="leave out what the log has")
    parser.add_argument("--log", type=pathlib.Path, default=speed.HERE.parent / "build/hunt.jsonl")
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path(tempfile.gettempdir()) / "whittle-hunt", help="where scenes and pictures are written")
    parser.add_argument("--keep", action="store_true", help="keep them")
    parser.add_argument("--limit", type=float, default=40, help="most processor seconds for a run (40)")
    parser.add_argument("--enough", type=float, default=6, help="ratio of small pictures at which no large one is made (6)")
    parser.add_argument("--haste", type=float, metavar="RATIO", help="ask POV-Ray only of scenes that may be below this ratio")
    parser.add_argument("--full", action="store_true", help="make all large ones")
    parser.add_argument("--rank", action="store_true", help="measure nothing")
    parser.add_argument("--memory", action="store_true", help="rank by what Whittle's peak memory is above POV-Ray's")
    parser.add_argument("--worst", type=int, default=20, metavar="N", help="how many are listed and profiled (20)")
    parser.add_argument("--profile", action="store_true", help="the three longest functions of the worst, by perf")
    parser.add_argument("--print", nargs=2, metavar=("CLASS", "SEED"), help="a scene's text")
    parser.add_argument("--classes", action="store_true", help="the names of the classes")
    parser.add_argument("--whittle", default=str(speed.HERE.parent / "build/release/whittle"))
    parser.add_argument("--povray", default="povray")
    options = parser.parse_args()
    known = {*compose.FEATURES, *compose.WILD}
    for kind in (options.only, options.print and options.print[0]):
        if kind and not set(kind.split("+")) <= known:
            parser.error(f"no such class: {kind}; --classes lists them")
    speed.programs_from_here(options)
    return options


def hunt(options, log):
    """Measures seed after seed; each is in the log at once, so that a hunt may be stopped anywhere."""
    first, _, last = options.seeds.partition("-")
    measure.prepare(options.folder)
    for seed in range(int(first), int(last or first) + 1):
        kind = compose.drawn(seed, options.only)
        if options.resume and log.known(kind, seed):
            continue
        log.add(measure.measured(options, options.folder, kind, seed))
        print(records.line(log.rows[kind, seed]), flush=True)


def main():
    options = arguments()
    if options.print:
        text, more = compose.text(options.print[0], int(options.print[1]))
        print(text, end="")
        print(more, end="\n" if more else "", file=sys.stderr)
        return 0
    if options.classes:
        print("\n".join([*compose.FEATURES, *compose.WILD]))
        return 0
    options.log.parent.mkdir(parents=True, exist_ok=True)
    log = records.Log(options.log)
    if not options.rank:
        hunt(options, log)
    worst = log.ranked(options.memory)[:options.worst]
    if options.profile:
        measure.prepare(options.folder)
        for row in worst:
            if "top" not in row and row["state"] == "counts":
                log.add({"class": row["class"], "seed": row["seed"], "top": measure.profile(options, options.folder, row["class"], row["seed"])})
    print(log.summary())
    print("\n".join(map(records.line, worst)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
