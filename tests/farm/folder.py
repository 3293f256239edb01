#!/usr/bin/python3
"""What `whittle plan`, `whittle farm` and `whittle join --movie` write.

usage: folder.py WHITTLE
"""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

import jobs
import openjd_schema

failed = []


def want(true, text):
    if not true:
        failed.append(text)
        print("FAILED:", text)


def chunks(data):
    at = 8
    while at < len(data):
        size = struct.unpack(">I", data[at:at + 4])[0]
        want(zlib.crc32(data[at + 4:at + 8 + size]) == struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0], "a chunk's sum")
        yield data[at + 4:at + 8], data[at + 8:at + 8 + size]
        at += size + 12


def plans(program, folder):
    job = jobs.Job(program, folder / "plans", still=False, size=(160, 120))
    told = subprocess.run([program, "plan", *job.words, "--tasks=5", "--json"], cwd=job.folder, capture_output=True, text=True, check=True)
    plan = json.loads(told.stdout)
    frames = []
    for task in plan["tasks"]:
        for piece in task["what"].split(","):
            first, _, last = piece.partition("-")
            frames += range(int(first), int(last or first) + 1)
        want(task["cores"] == 1 and task["mib"] > 1 and task["seconds"] > 0, f"numbers of {task}")
    want(frames == list(range(1, 13)), f"each frame once: {frames}")
    want(len(plan["tasks"]) == 5, "as many tasks as were asked for")
    want(abs(sum(t["seconds"] for t in plan["tasks"]) + plan["join"]["seconds"] - plan["sum_seconds"]) < 1e-6, "the sum")
    want(plan["critical_path_seconds"] < plan["sum_seconds"], "the critical path")
    # One frame that takes nearly all leaves the others their tasks.
    uneven = jobs.Job(program, folder / "uneven", still=False, size=(64, 48))
    uneven.write(jobs.ANIMATION.replace("5, 5 }", "#if (clock = 1) 65, 65 #else 1, 1 #end }"))
    told = subprocess.run([program, "plan", *uneven.words, "--tasks=12", "--json"], cwd=uneven.folder, capture_output=True, text=True, check=True)
    want(len(json.loads(told.stdout)["tasks"]) == 12, "twelve frames are twelve tasks, however uneven")
    # By what finished tasks took.
    done = job.folder / "done"
    done.mkdir()
    subprocess.run([program, *job.words, "--frames=1,6,12", "--quiet", "+WT1", f"--json={done}/1.json"], cwd=job.folder, check=True)
    plan = json.loads(subprocess.run([program, "plan", *job.words, "--json", "--from=done"], cwd=job.folder, capture_output=True,
                                     text=True, check=True).stdout)
    want(plan["measured_frames"] == 3, "three frames are known")
    took = sum(f["phases"]["trace_cpu_seconds"] for f in json.loads((done / "1.json").read_text())["frames"])
    want(0.5 < plan["sum_seconds"] / (4 * took) < 3, f"the sum goes by them: {plan['sum_seconds']} of 4 times {took}")
    want(plan["expected_error"] is not None, "three frames tell how even they are")
    # One tells nothing of the others.
    subprocess.run([program, *job.words, "--frames=6", "--quiet", "+WT1", f"--json={done}/1.json"], cwd=job.folder, check=True)
    told = subprocess.run([program, "plan", *job.words, "--from=done"], cwd=job.folder, capture_output=True, text=True, check=True)
    want("how far off is not known, told by 1 finished frame" in told.stdout, f"what one frame tells: {told.stdout}")


def folders(program, folder):
    for engine in ("slurm", "openjd", "make", "shell"):
        job = jobs.Job(program, folder / engine, still=engine == "shell", size=(96, 72))
        job.make_farm(engine)
        for script in job.farm.iterdir():
            if script.name in ("README", "plan.json", "tasks", "pieces", "template.json", "Makefile"):
                continue
            want(subprocess.run(["bash", "-n", str(script)], check=False).returncode == 0, f"{engine}: {script.name} is no script")
        want(len((job.farm / "README").read_text().splitlines()) == 5, f"{engine}: a README of five lines")
        if engine in ("make", "shell"):
            ended = job.script("submit")
            want(ended.returncode == 0, f"{engine}: {ended.stdout[-500:]}{ended.stderr[-500:]}")
            want(not jobs.differences(job.pictures(), job.plain()), f"{engine}: other bytes than one run")
        if engine == "openjd":
            template = json.loads((job.farm / "template.json").read_text())
            want(openjd_schema.faults(template) == [], f"the template: {openjd_schema.faults(template)}")
            for change in (lambda t: t.pop("steps"), lambda t: t["steps"][0].pop("script"), lambda t: t.update(name="{{Param.No}}"),
                           lambda t: t["steps"][1]["dependencies"].clear(), lambda t: t.update(other=1)):
                broken = json.loads((job.farm / "template.json").read_text())
                change(broken)
                want(openjd_schema.faults(broken), "a broken template is found")


def hosts(program, folder):
    """Over ssh: the command here is one of our own that notes the host and runs the words."""
    job = jobs.Job(program, folder / "hosts", still=False, size=(64, 48))
    job.make_farm("shell")
    bin = job.folder / "bin"
    bin.mkdir()
    notes = job.folder / "asked"
    notes.mkdir()
    (bin / "ssh").write_text(
        f'#!/bin/bash\n[[ $1 == -o ]] && shift 2\necho "$1" >"$(mktemp "{notes}/XXXXXX")"\n[[ $1 != away ]] || exit 255\nexec bash -c "$2"\n')
    (bin / "ssh").chmod(0o755)
    ended = job.script("submit", "ann", "ben", "away", env={**os.environ, "PATH": f"{bin}:{os.environ['PATH']}"})
    asked = sorted(note.read_text().strip() for note in notes.iterdir())
    want(len(asked) == 12 and {"ann", "ben"} <= set(asked), f"hosts: {asked}")
    lost = asked.count("away")
    want(ended.returncode == (75 if lost else 0) and ended.stderr.count("missing:") >= lost, f"what a host that is away had: {ended.stderr}")
    want(job.script("submit").returncode == 0, "handed in again, here")
    want(not jobs.differences(job.pictures(), job.plain()), "hosts: other bytes than one run")


def movies(program, folder):
    job = jobs.Job(program, folder / "film", still=False, size=(64, 48))
    subprocess.run([program, *job.words, "--quiet"], cwd=job.folder, check=True)
    frames = sorted(p.name for p in job.folder.glob("*.png"))

    def join(out, *more, **env):
        return subprocess.run([program, "join", "--movie", out, *frames, *more], cwd=job.folder, capture_output=True, text=True, check=False,
                              env={**os.environ, **env})
    want(join("film.apng").returncode == 0, "an APNG")
    kinds = list(chunks((job.folder / "film.apng").read_bytes()))
    rows = {name: b"".join(d for n, d in chunks((job.folder / name).read_bytes()) if n == b"IDAT") for name in frames}
    shown = [d for n, d in kinds if n == b"IDAT"] + [d[4:] for n, d in kinds if n == b"fdAT"]
    want(shown == [rows[name] for name in frames], "the APNG has the frames' own rows")
    numbers = [struct.unpack(">I", d[:4])[0] for n, d in kinds if n in (b"fcTL", b"fdAT")]
    want(numbers == list(range(len(numbers))), "numbers of its chunks")
    want(struct.unpack(">II", dict(kinds)[b"acTL"]) == (12, 0), "twelve frames without end")
    want(join("film.gif", "--fps=10").returncode == 0, "a GIF")
    gif = (job.folder / "film.gif").read_bytes()
    want(gif[:6] == b"GIF89a" and gif[-1:] == b";" and gif.count(b"\x21\xf9\x04") == 12 and b"NETSCAPE2.0" in gif, "the GIF's blocks")
    near = subprocess.run([program, "compare", "film.gif", frames[0], "--tolerance", "12", "--share", "0.9"], cwd=job.folder,
                          stdout=subprocess.DEVNULL, check=False)
    want(near.returncode == 0, "the GIF's first frame is near the picture")
    frames.append("gone.png")
    gone = join("film.gif")
    want(gone.returncode == 75 and "missing: gone.png" in gone.stderr, f"a missing frame: {gone.returncode} {gone.stderr}")
    frames.pop()
    (job.folder / "bin").mkdir()
    tool = job.folder / "bin" / "ffmpeg"
    tool.write_text("#!/bin/sh\nfor out; do :; done\nwc -c >\"$out\"\n")
    tool.chmod(0o755)
    path = f"{job.folder}/bin:/usr/bin:/bin"
    want(join("a film.mp4", PATH=path).returncode == 0, "a film by ffmpeg")
    want((job.folder / "a film.mp4").read_text().strip() == str(12 * 64 * 48 * 3), "ffmpeg gets every pixel")
    if not shutil.which("ffmpeg"):
        none = join("film.webm")
        want(none.returncode == 1 and "ffmpeg" in none.stderr, "without ffmpeg a word says so")


def full_disk(program, folder):
    place = folder / "small"
    place.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=300k", "tmpfs", str(place)], stderr=subprocess.DEVNULL, check=False).returncode:
        print("left out: needs the right to mount")
        return
    try:
        job = jobs.Job(program, place / "job", still=False, size=(200, 150))
        job.make_farm("make")
        (place / "filler").write_bytes(bytes(220 * 1024))
        job.script("sources_now")
        task = job.script("task", "1")
        want(task.returncode == 75, f"a full disk says 75: {task.returncode} {task.stderr}")
        subprocess.run(["mount", "-o", "remount,size=40m", str(place)], check=True)
        want(job.script("submit").returncode == 0, "with room it goes on")
        want(not jobs.differences(job.pictures(), job.plain()), "and has the bytes of one run")
    finally:
        subprocess.run(["umount", str(place)], check=False)


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory(prefix="farm") as name:
        for test in (plans, folders, hosts, movies, full_disk):
            test(program, pathlib.Path(name))
    sys.exit(1 if failed else 0)


main()
