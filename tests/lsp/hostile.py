#!/usr/bin/python3
"""Bad input to `whittle lsp`: random and truncated requests, wrong headers, texts that are no scenes. No crash, no hang, memory bounded.

usage: hostile.py WHITTLE [--requests N] [--seed N]
"""
import json
import os
import pathlib
import shutil
import sys
import tempfile
import time

from client import Client, uri

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import bad_input  # noqa: E402

METHODS = ["textDocument/" + name for name in (
    "completion hover definition references documentHighlight prepareRename rename documentSymbol foldingRange documentColor "
    "colorPresentation formatting rangeFormatting didOpen didChange didClose didSave semanticTokens/full").split()] + [
        "workspace/symbol", "$/cancelRequest", "initialized", "workspace/didChangeWatchedFiles", "", "no/such"]
WORDS = ("sphere { } box < > ( ) [ ] , ; # declare local macro if ifdef while for switch case else end include \"a.inc\" \" /* */ // function "
         "array rgb rgbft 1 0.5 1e999 -7 A B M R texture pigment finish union difference camera = + - * / ? : . \n \r\n \u00e4 \U0001F600 "
         "mesh triangle mesh2 vertex_vectors #version 3.7; #macro M(A,B) #end #while(1) isosurface \x00 \t").split(" ")
MEMORY = 700  # MB


def scene(rng):
    return " ".join(rng.choice(WORDS) for _ in range(rng.randrange(0, 120)))


def number(rng):
    return rng.choice(bad_input.NUMBERS)


def value(rng):
    return bad_input.value(rng, ["uri", "text", "position", "line", "character", "range", "start", "end", "textDocument", "options", "color", "newName", "q"])


def place(rng):
    if rng.random() < 0.1:
        return value(rng)
    small = lambda: rng.randrange(0, 30) if rng.random() < 0.9 else number(rng)
    return {"line": small(), "character": small()}


def parameters(rng, names):
    """Mostly what the requests take, each part now and then something else."""
    part = lambda made: value(rng) if rng.random() < 0.02 else made
    span = lambda: part({"start": place(rng), "end": place(rng)})
    name = names[rng.randrange(3)] if rng.random() < 0.85 else rng.choice(names)
    changes = [part({"range": span(), "text": scene(rng)[:60]}) if rng.random() < 0.8 else {"text": scene(rng)}
               for _ in range(rng.randrange(4))]
    made = {"textDocument": part({"uri": name, "version": number(rng), "text": part(scene(rng)), "languageId": "pov"}),
            "position": part(place(rng)), "range": span(), "contentChanges": part(changes), "options": part({"tabSize": number(rng)}),
            "newName": part(rng.choice(["N", "sphere", "", "A", "9"])), "context": part({"includeDeclaration": number(rng)}),
            "color": part({"red": 0.5, "green": number(rng), "blue": 1, "alpha": 0.5})}
    return part(made)


def framed(body):
    return b"Content-Length: %d\r\n\r\n" % len(body) + body


def request(rng, names, number_of):
    """Bytes of one request: in order, truncated, mangled or none at all."""
    method = rng.choice(METHODS) if rng.random() < 0.7 else rng.choice(["textDocument/didOpen", "textDocument/didChange"])
    message = {"jsonrpc": "2.0", "method": method, "params": parameters(rng, names)}
    if rng.random() < (0.1 if "/did" in method or "init" in method else 0.95):
        message["id"] = number_of if rng.random() < 0.9 else value(rng)
    if rng.random() < 0.05:
        message = value(rng)
    body = json.dumps(message).encode()
    kind = rng.random()
    if kind < 0.75:
        return framed(body)
    if kind < 0.80:  # the body is cut short, its length says so
        return framed(bad_input.cut_short(rng, body))
    if kind < 0.84:  # more is promised than comes
        return b"Content-Length: %d\r\n\r\n" % (len(body) + rng.randrange(1, 200)) + body
    if kind < 0.87:  # less is promised
        return b"Content-Length: %d\r\n\r\n" % rng.randrange(len(body) + 1) + body
    if kind < 0.91:  # bytes of it are others
        return framed(bad_input.mangled(rng, body, 8))
    if kind < 0.94:
        return rng.choice([b"Content-Length: ", b"Content-Length: -5\r\n\r\n", b"Content-Length: 99999999999999999999\r\n\r\n",
                           b"Content-Length:\r\n\r\n", b"Content-Length: 7", b"\r\n\r\n", b"Content-Length: 0x10\r\n\r\n{}",
                           b"Content-Type: a\r\n\r\n{}", b"Content-Length: 2000000000\r\n\r\n"])
    if kind < 0.97:
        return bytes(rng.randrange(256) for _ in range(rng.randrange(300)))
    return framed(b"[" * rng.randrange(1, 20000) if rng.random() < 0.5 else b'{"a":' * rng.randrange(1, 5000))


def settle(client, seen):
    """An answer to a request in order, whatever half message came before it. Counts what came until then."""
    client.raw(b"\n" * 8192)  # what a length too great still waits for, and more than a header may have
    client.number += 1
    for attempt in range(3):
        client.send({"jsonrpc": "2.0", "id": f"settle{client.number}", "method": "textDocument/documentSymbol",
                     "params": {"textDocument": {"uri": "file:///none"}}})
    deadline = time.monotonic() + 120
    while (message := client.read(deadline)).get("id") != f"settle{client.number}":
        kind = message.get("method", "result").split("/")[-1]
        kind = str(message["error"]["code"]) if "error" in message else kind
        seen[kind] = seen.get(kind, 0) + 1
    assert "error" in message, message


def main():
    options, rng = bad_input.asked("hostile requests to whittle lsp", 10000, 22)
    folder, mail = tempfile.mkdtemp(prefix="whittle-lsp-hostile-"), tempfile.mkdtemp(prefix="whittle-mail-")
    os.environ["XDG_RUNTIME_DIR"] = mail
    try:
        client = Client(options.whittle, ["--seconds=1", "--memory=300"], folder, initialize=False)
        client.result("initialize", {"rootUri": uri(folder), "capabilities": {
            "window": {"showDocument": {"support": True}}, "workspace": {"applyEdit": True}}})
        names = [uri(os.path.join(folder, name)) for name in ("a.pov", "b.pov", "a.inc")] + ["untitled:x", "", "file://", "file:///%00", "%"]
        seen = {}
        for count in range(1, options.requests + 1):
            client.raw(request(rng, names, count))
            if count % 50 == 0:
                bad_input.datagrams(rng, os.path.join(mail, "whittle"), 20, [os.path.join(folder, "a.pov"), "/etc/passwd", "b.pov"])
                settle(client, seen)
        # What came was understood, for the most part: answers, refusals and diagnostics.
        for what in ("result", "publishDiagnostics", "showDocument", "-32601", "-32602", "-32700", "-32803"):
            assert seen.get(what, 0) > options.requests // 200, seen
        assert seen["result"] + seen["publishDiagnostics"] > options.requests // 4, seen
        # A message that is longer than any may be: it is passed over in pieces.
        client.raw(b"Content-Length: %d\r\n\r\n" % (100 << 20))
        for _ in range(100):
            client.raw(b"x" * (1 << 20))
        settle(client, seen)
        memory = client.memory()
        # It still is a language server.
        client.open("fine.pov", "#version 3.7;\nsphere { 0, 1 pigmnt }\n")
        assert client.diagnostics("fine.pov", 1)[0]["message"].startswith("'pigmnt'")
        assert client.end() == 0
        assert os.listdir(folder) == [] and os.listdir(mail) == ["whittle"] and os.listdir(os.path.join(mail, "whittle")) == []
        assert memory < MEMORY, f"{memory} MB"
        print(f"{options.requests} requests, {memory} MB at most; {seen}")
    finally:
        shutil.rmtree(folder)
        shutil.rmtree(mail)


if __name__ == "__main__":
    main()
