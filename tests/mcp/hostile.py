#!/usr/bin/python3
"""Bad input to `whittle mcp`: random, truncated and mangled messages. No crash, no hang; each request is answered once.

usage: hostile.py WHITTLE [--requests N] [--seed N]
"""
import json
import pathlib
import subprocess
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import bad_input  # noqa: E402

METHODS = ["initialize", "ping", "tools/list", "tools/call", "tools/call", "tools/call", "resources/list", "resources/read", "prompts/list",
           "notifications/initialized", "notifications/cancelled", "resources/templates/list", "logging/setLevel", "", "no/such"]
TOOLS = ["check", "render", "pixel", "info", "section", "mesh", "compare", "explain_keyword", "no", ""]
NAMES = ["scene", "file", "declare", "clock", "seconds", "width", "height", "x", "y", "axis", "value", "object", "format", "a", "b", "word", "block",
         "tolerance", "uri", "cursor", "name", "requestId"]

# Half a character would make the whole message none, whose request is not awaited.
TEXTS = [text for text in bad_input.TEXTS if text != "\ud800"] + ["sphere", "finish", "render-1.png", "whittle://guide"]


def value(rng):
    return bad_input.value(rng, NAMES, TEXTS)


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
        return bad_input.cut_short(rng, line), None
    if turn < 0.16:
        return bad_input.mangled(rng, line, 4, b'\0\x80{}[]",:\\-e\n'), None  # no digit: that could make another's id
    if turn < 0.18:
        return rng.choice([b"[" * 100000, b"{" * 5000, b'"' + b"a" * 200000 + b'"', b"\xff\xfe\x00", b"", b"\r", b"null", b"1e999"]), None
    return (line, asked) if json.loads(line) == made else (line, None)


def main():
    given, rng = bad_input.asked("hostile messages to whittle mcp", 10000)
    server = subprocess.Popen([given.whittle, "mcp", "--seconds=1"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
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
    for number in range(1000, 1000 + given.requests):
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
    print(f"{given.requests} messages, {lines} answers, {len(asked)} of them awaited")


if __name__ == "__main__":
    sys.exit(main())
