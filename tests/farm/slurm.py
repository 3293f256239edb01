#!/usr/bin/python3
"""A real Slurm of this host runs jobs of `whittle farm --for=slurm`: tasks are killed, requeued, cancelled and handed in again.

usage: slurm.py WHITTLE [NAME...]

NAMEs are those of TESTS. Slurm is started and ended here, on the loopback device, in a folder of its own. Exit status: 0 all is well, 1 it is
not, 77 there is no Slurm or the right to start it.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import jobs

HERE = pathlib.Path(__file__).resolve().parent
LONGEST = 240.0  # seconds that a job may take


def slurm(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout.strip()


def submit(job):
    ended = job.script("submit")
    if ended.returncode != 0:
        raise RuntimeError(f"submit: {ended.stdout}{ended.stderr}")
    return ended.stdout.split()


def waiting(numbers):
    """States of what is not done: lines of `job state reason`; jobs that wait for one that failed never begin."""
    lines = slurm("squeue", "-h", "-r", "-j", ",".join(numbers), "-o", "%i %T %r").splitlines()
    return [line for line in lines if "DependencyNeverSatisfied" not in line]


def wait(numbers, look=lambda: None):
    end = time.monotonic() + LONGEST
    while waiting(numbers):
        if time.monotonic() > end:
            raise RuntimeError("the job does not end: " + "; ".join(waiting(numbers)))
        look()
        time.sleep(0.1)
    for number in numbers:  # what can never begin
        subprocess.run(["scancel", number], stderr=subprocess.DEVNULL, check=False)


def once(job, act):
    """Calls `act` with a task and its process when the first is seen."""
    done = []

    def look():
        running = job.renderers()
        if running and not done:
            task = sorted(running)[0]
            done.append(task)
            act(task, running[task])
    return look


def until_done(job, numbers, tries=4):
    wait(numbers)
    for _ in range(tries):
        if job.script("join").returncode == 0:
            return
        wait(submit(job))
    raise RuntimeError("not done: " + job.script("join").stderr)


def check(job):
    wrong = jobs.differences(job.pictures(), job.plain())
    if wrong:
        raise RuntimeError("; ".join(wrong))


def started(program, folder, still):
    job = jobs.Job(program, folder, still)
    job.make_farm("slurm")
    return job, submit(job)


def plain_job(program, folder, still):
    job, numbers = started(program, folder, still)
    wait(numbers)
    log = job.farm / "log" / "join"
    if not log.exists():
        raise RuntimeError("the joining did not begin: " + "".join(p.read_text() for p in (job.farm / "log").iterdir()))
    check(job)


def animation(program, folder):
    plain_job(program, folder, False)


def still(program, folder):
    plain_job(program, folder, True)


def killed(program, folder):
    job, numbers = started(program, folder, False)
    wait(numbers, once(job, lambda task, process: jobs.end(process)))
    until_done(job, numbers)
    check(job)


def requeued(program, folder):
    job, numbers = started(program, folder, False)
    array = numbers[-2]
    wait(numbers, once(job, lambda task, process: subprocess.run(["scontrol", "requeue", f"{array}_{task}"], check=False)))
    until_done(job, numbers)
    check(job)


def cancelled(program, folder):
    job, numbers = started(program, folder, True)
    seconds = []

    def cancel(task, process):
        begin = time.monotonic()
        subprocess.run(["scancel", *numbers], check=False)
        while pathlib.Path(f"/proc/{process}").exists() and time.monotonic() < begin + 20:
            time.sleep(0.01)
        seconds.append(time.monotonic() - begin)
    wait(numbers, once(job, cancel))
    missing = job.script("join")
    if missing.returncode not in (0, 75):
        raise RuntimeError(f"join says {missing.returncode}: {missing.stderr}")
    if missing.returncode == 75 and "missing" not in missing.stderr:
        raise RuntimeError("join does not say what is missing: " + missing.stderr)
    print(f"    ended {seconds[0]:.2f} s after scancel" if seconds else "    it was done before")
    until_done(job, submit(job))
    check(job)


def edited(program, folder):
    job, numbers = started(program, folder, True)
    wait(numbers, once(job, lambda task, process: job.write(job.text.replace("0.9", "0.8"))))
    until_done(job, submit(job))
    check(job)


TESTS = {"animation": animation, "still": still, "killed": killed, "requeued": requeued, "cancelled": cancelled, "edited": edited}


def main():
    program, names = sys.argv[1], sys.argv[2:] or list(TESTS)
    if os.geteuid() != 0 or not shutil.which("slurmctld") or not (shutil.which("munged") or pathlib.Path("/usr/sbin/munged").exists()):
        print("skipped: needs root, slurm-wlm and munge")
        sys.exit(77)
    failed = 0
    with tempfile.TemporaryDirectory(prefix="slurm") as folder:
        place = pathlib.Path(folder) / "slurm"
        start = subprocess.run(["bash", "-c", f"source '{HERE}/slurm_here.sh'; slurm_start '{place}' 2"], check=False)
        os.environ["SLURM_CONF"] = str(place / "slurm.conf")
        try:
            if start.returncode != 0:
                print("skipped: Slurm does not come up here")
                sys.exit(77)
            for name in names:
                begin = time.monotonic()
                try:
                    TESTS[name](program, str(pathlib.Path(folder) / name))
                    print(f"{name}: as one run, {time.monotonic() - begin:.0f} s", flush=True)
                except (RuntimeError, subprocess.CalledProcessError) as why:
                    failed += 1
                    print(f"{name}: FAILED: {why}", flush=True)
        finally:
            subprocess.run(["bash", "-c", f"source '{HERE}/slurm_here.sh'; slurm_stop '{place}'"], check=False)
            time.sleep(0.5)
    sys.exit(1 if failed else 0)


signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
main()
