#!/usr/bin/python3
"""Random deaths: whichever task dies when, a farm ends in the bytes of one plain run.

usage: storm.py WHITTLE [--seeds N] [--first SEED]

Each seed draws a job (12 frames, or a still in 16 parts with radiosity and photons) and what befalls it: tasks that are killed, ended by a
signal or started twice at once, parts that are cut short, a scene that is edited in the middle. The job runs through `make -j2` and is
handed in again until it is done, as one would. The exit status is 1 if a seed ends in other bytes; a table tells of all.
"""
import argparse
import random
import signal
import subprocess
import sys
import tempfile
import time

import jobs

MOST_TRIES = 8


def befall(job, rng, counts, edited):
    """One mishap to what runs now. Returns whether there was anything that it could befall, and a process that it began."""
    what = rng.choice(["kill", "kill", "kill", "signal", "twice", "truncate", "edit"])
    running = job.renderers()
    if what in ("kill", "signal") and running:
        if jobs.end(rng.choice(sorted(running.values())), signal.SIGKILL if what == "kill" else signal.SIGTERM):
            counts["deaths"] += 1
            return True, None
    elif what == "twice" and running:
        counts["twice"] += 1
        return True, subprocess.Popen(["bash", str(job.farm / "task"), str(rng.choice(sorted(running)))],
                                      stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    elif what == "truncate":
        parts = sorted(job.folder.glob("*.whittle-part"))
        if parts:
            part = rng.choice(parts)
            part.write_bytes(part.read_bytes()[:rng.randrange(1, part.stat().st_size)])
            counts["truncated"] += 1
            return True, None
    elif what == "edit" and not edited:
        job.write(job.text.replace("0.2", "0.25"))
        counts["edits"] += 1
        return True, None
    return False, None


def weather(program, seed):
    rng = random.Random(seed)
    counts = dict.fromkeys(("tries", "deaths", "twice", "truncated", "edits"), 0)
    with tempfile.TemporaryDirectory(prefix="storm") as folder:
        job = jobs.Job(program, folder, still=seed % 2 == 1, size=(240, 180))
        job.make_farm("make")
        mishaps, others = rng.randrange(3, 8), []
        for _ in range(MOST_TRIES):
            counts["tries"] += 1
            told = job.text
            running = subprocess.Popen(["bash", str(job.farm / "submit"), "-j2"], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            while running.poll() is None:
                time.sleep(rng.uniform(0.02, 0.2))
                if mishaps > 0:
                    befell, other = befall(job, rng, counts, counts["edits"] > 0)
                    mishaps -= befell
                    others += [other] if other else []
            late = any(other.poll() is None for other in others)  # and may write what it read before an edit
            for other in others:
                other.wait()
            if running.returncode == 0 and told == job.text and not late:
                break
        wanted = job.plain()
        wrong = jobs.differences(job.pictures(), wanted)
        if running.returncode != 0:
            wrong.append(f"not done after {MOST_TRIES} tries: {job.script('join').stderr.strip()}")
    print(f"{seed:4}  {'still' if seed % 2 else 'frames':6}  {counts['tries']:5}  {counts['deaths']:6}  {counts['twice']:5}  "
          f"{counts['truncated']:9}  {counts['edits']:5}  {'equal' if not wrong else '; '.join(wrong)}", flush=True)
    return not wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--first", type=int, default=0)
    given = parser.parse_args()
    print("seed  job     tries  deaths  twice  truncated  edits  bytes")
    good = [weather(given.program, seed) for seed in range(given.first, given.first + given.seeds)]
    sys.exit(0 if all(good) else 1)


main()
