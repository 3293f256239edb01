#!/usr/bin/python3
"""A farm of many nodes, simulated over the plans of real jobs: efficiency against nodes, and what ends it.

usage: farm_simulation.py [PLAN.json NAME SCALE]...

A PLAN is what `whittle plan --json` prints; SCALE multiplies its seconds, for a job of the same shape in a larger picture. Without any the three
of docs/farm.md are simulated. A node runs one task at a time. Each task starts the renderer (START), reads its scene from the shared file
system and writes its picture there (one pipe of BANDWIDTH for all), is preempted with the chance PREEMPTED at a random place and goes on
elsewhere from its state, of which the last STATE seconds are lost; one node in SLOW_ONE_IN takes SLOW times as long. The engine hands out a task every
DISPATCH seconds. Efficiency is the work, on one node without any of this, over nodes times the time till the joined result is there.
"""
import heapq
import json
import random
import sys

START, BANDWIDTH, PREEMPTED, STATE, SLOW_ONE_IN, SLOW, DISPATCH = 0.5, 1e9, 0.05, 2.0, 50, 3.0, 0.005
NODES = (1, 10, 50, 100, 200, 500, 1000)
SEEDS = 5


def simulate(tasks, first, join, read, write, nodes, seed):
    """Seconds till all is done. `tasks`: seconds each; `read` and `write`: bytes of each."""
    rng = random.Random(seed)
    speed = [SLOW if i % SLOW_ONE_IN == SLOW_ONE_IN - 1 else 1.0 for i in range(nodes)]
    pipe = dispatch = 0.0

    def through_pipe(at, size):
        nonlocal pipe
        pipe = max(pipe, at) + size / BANDWIDTH
        return pipe
    begin = START + through_pipe(0.0, read) + first if first else 0.0
    left = list(tasks)[::-1]
    events = [(begin, 0, "free", node, 0.0) for node in range(nodes)]  # when, order, what, node, seconds that are left of its task
    idle, count, end = [], 0, begin

    def later(at, what, node, seconds):
        nonlocal count
        count += 1
        heapq.heappush(events, (at, count, what, node, seconds))

    def hand_out(at, node, seconds):
        nonlocal dispatch
        dispatch = max(dispatch, at) + DISPATCH
        later(dispatch + START, "read", node, seconds)
    while events:
        at, _, what, node, seconds = heapq.heappop(events)
        if what == "free":
            if left:
                hand_out(at, node, left.pop())
            else:
                idle.append(node)
        elif what == "read":
            ready = through_pipe(at, read)
            ran = rng.uniform(0.0, seconds) if rng.random() < PREEMPTED else seconds
            later(ready + ran * speed[node], "rendered" if ran == seconds else "preempted", node,
                  0.0 if ran == seconds else seconds - max(0.0, ran - STATE))
        elif what == "preempted":
            left.append(seconds)
            later(at, "free", node, 0.0)
            if idle:
                later(at, "free", idle.pop(), 0.0)
        else:
            end = max(end, through_pipe(at, write))
            later(pipe, "free", node, 0.0)
    return end + START + join


def table(name, plan, scale):
    tasks = [scale * t["seconds"] for t in plan["tasks"]]
    first = scale * plan["prepare"]["seconds"] if plan["prepare"] else 0.0
    pixels = plan["width"] * plan["height"] * scale
    write = 4.0 * pixels * (1.0 if plan["kind"] == "animation" else 4.0 / len(tasks)) * max(1.0, plan["frames"] / len(tasks))
    join = scale * plan["join"]["seconds"]
    work = sum(tasks) + first + join
    print(f"\n| {name}: {len(tasks)} tasks, {work / 3600:.1f} h | " + " | ".join(str(n) for n in NODES) + " |")
    print("|---|" + "---:|" * len(NODES))
    ends = [sum(simulate(tasks, first, join, 5e6, write, n, s) for s in range(SEEDS)) / SEEDS for n in NODES]
    print("| minutes | " + " | ".join(f"{e / 60:.1f}" for e in ends) + " |")
    print("| efficiency, % | " + " | ".join(f"{100 * work / (n * e):.0f}" for n, e in zip(NODES, ends)) + " |")
    # What ends it: the longest task on a slow node, what comes before and after, the pipe.
    print(f"| longest task {max(tasks):.0f} s, before {first:.0f} s, after {join:.1f} s, pipe {len(tasks) * (5e6 + write) / BANDWIDTH:.0f} s |")


def main():
    words = sys.argv[1:]
    for at in range(0, len(words), 3):
        with open(words[at], encoding="utf-8") as file:
            table(words[at + 1], json.load(file), float(words[at + 2]))


main()
