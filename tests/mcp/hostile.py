#!/usr/bin/python3
"""Bad input to `whittle mcp`: random, truncated and mangled messages. No crash, no hang; each request is answered once.

usage: hostile.py WHITTLE [--messages N] [--seed N]
"""
import argparse
import json
import os
import random
import subprocess
import sys
import threading

METHODS = ["initialize", "ping", "tools/list", "tools/call", "tools/call", "tools/call", "resources/list", "resources/read", "prompts/list",
           "notifications/initialized", "notifications/cancelled", "resources/templates/list", "logging/setLevel", "", "no/such"]
TOOLS = ["check", "render", "pixel", "info", "section", "mesh", "compare", "explain_keyword", "no", ""]
NAMES = ["scene", "file", "declare", "clock", "seconds", "width", "height", "x", "y", "axis", "value", "object", "format", "a", "b", "word", "block",
         "tolerance", "uri", "cursor", "name", "requestId"]


def value(rng, depth=0):
    kind = rng.randrange(9 if depth < 4 else 6)
    if kind < 3:
        return rng.choice([0, 1, 2, -1, 2**31, 2**63, 1e300, 0.5, None, True, False])
    if kind < 6:
        return rng.choice(["", "x", "\0", "../x", "/etc/passwd", "a" * 3000, "sphere", "finish", "render-1.png", "\u00e4\U0001F600", "whittle://guide"])
    if kind == 6:
        return [value(rng, depth + 1) for _ in range(rng.randrange(4))]
    return {rng.choice(NAMES): value(rng, depth + 1) for _ in range(rng.randrange(5))}


def message(rng, number, slow):
    """Bytes of a line, and the id that an answer has to have; None: any, or none."""
    method = rng.choice(METHODS)
    parameters = value(rng) if rng.random() < 0.3 else {rng.choice(NAMES): value(rng) for _ in range(rng.randrange(4))}
    if method == "tools/call":
        arguments = {rng.choice(NAMES): value(rng) for _ in range(rng.randrange(4))}
        if not slow:  # without a scene no tool begins a process
            arguments.pop("scene", None)
        parameters = {"name": rng.choice(TOOLS), "arguments": arguments if rng.random() < 0.9 else value(rng)}
    made = {"jsonrpc": "2.0", "method": method, "params": parameters}
    if not method.startswith("notifications/") or rng.random() < 0.2:
        made["id"] = number
    if rng.random() < 0.1:
        made.pop(rng.choice(list(made)))
    if rng.random() < 0.03:
        made["id"] = value(rng)
    line = json.dumps(value(rng) if rng.random() < 0.05 else made).encode()
    asked = made.get("id") if isinstance(made, dict) and made.get("id") == number and isinstance(made.get("method"), str) else None
    turn = rng.random()
    if turn < 0.08:
        return line[:rng.randrange(len(line) + 1)], None
    if turn < 0.16:
        cut = bytearray(line)
        for _ in range(rng.randrange(1, 4)):
            cut[rng.randrange(len(cut))] = rng.choice(b'\0\x80{}[]",:\\9e\n')
        return bytes(cut), None
    if turn < 0.18:
        return rng.choice([b"[" * 100000, b"{" * 5000, b'"' + b"a" * 200000 + b'"', b"\xff\xfe\x00", b"", b"\r", b"null", b"1e999"]), None
    return (line, asked) if json.loads(line) == made else (line, None)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("whittle")
    arguments.add_argument("--messages", type=int, default=10000)
    arguments.add_argument("--seed", type=int, default=1)
    given = arguments.parse_args()
    rng = random.Random(given.seed)
    server = subprocess.Popen([os.path.abspath(given.whittle), "mcp", "--seconds=1"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    answered, lines = {}, 0

    def listen():
        nonlocal lines
        for line in server.stdout:
            lines += 1
            answer = json.loads(line)
            assert answer["jsonrpc"] == "2.0" and ("result" in answer) != ("error" in answer), answer
            if "error" in answer:
                assert isinstance(answer["error"]["code"], int) and answer["error"]["message"], answer
            key = json.dumps(answer["id"])
            answered[key] = answered.get(key, 0) + 1
    listener = threading.Thread(target=listen)
    listener.start()
    asked = []
    for number in range(1000, 1000 + given.messages):
        line, wanted = message(rng, number, slow=number % 500 == 0)
        server.stdin.write(line + b"\n")
        if wanted is not None:
            asked.append(wanted)
    server.stdin.write(b'{"jsonrpc": "2.0", "id": "last", "method": "ping"}\n')
    server.stdin.close()
    listener.join(100)
    assert not listener.is_alive(), "the server hangs"
    assert server.wait(10) == 0, server.returncode
    missing = [number for number in asked if answered.get(json.dumps(number)) != 1]
    assert not missing and answered.get('"last"') == 1, (len(missing), missing[:5])
    print(f"{given.messages} messages, {lines} answers, {len(asked)} of them awaited")


if __name__ == "__main__":
    sys.exit(main())
