"""A client of a language server: frames messages, waits for answers and diagnostics."""
import json
import os
import select
import subprocess
import time


class Gone(Exception):
    """The server ended, or does not answer."""


class Client:
    def __init__(self, program, arguments=(), folder=None, initialize=True, encodings=None):
        self.process = subprocess.Popen([program, "lsp", *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, cwd=folder)
        self.folder = folder
        self.bytes = b""
        self.number = 0
        self.told = []  # notifications that were not waited for yet
        self.versions = {}
        if initialize:
            general = {"general": {"positionEncodings": encodings}} if encodings else {}
            self.capabilities = self.ask("initialize", {
                "processId": os.getpid(), "capabilities": general,
                "rootUri": uri(folder) if folder else None})["result"]["capabilities"]
            self.tell("initialized", {})

    def raw(self, data):
        try:
            self.process.stdin.write(data)
            self.process.stdin.flush()
        except BrokenPipeError:
            raise Gone("the server closed its input")

    def send(self, message):
        body = json.dumps(message).encode()
        self.raw(b"Content-Length: %d\r\n\r\n" % len(body) + body)

    def tell(self, method, parameters):
        self.send({"jsonrpc": "2.0", "method": method, "params": parameters})

    def ask(self, method, parameters, seconds=60):
        """The whole answer, with `result` or `error`."""
        self.number += 1
        self.send({"jsonrpc": "2.0", "id": self.number, "method": method, "params": parameters})
        return self.answer(self.number, seconds)

    def result(self, method, parameters):
        answer = self.ask(method, parameters)
        assert "result" in answer, answer
        return answer["result"]

    def answer(self, number, seconds=60):
        deadline = time.monotonic() + seconds
        while True:
            message = self.read(deadline)
            if "method" in message:
                self.told.append(message)
            elif message.get("id") == number:
                return message

    def read(self, deadline):
        while True:
            header, split, rest = self.bytes.partition(b"\r\n\r\n")
            if split:
                length = int(header.split(b":")[1])
                if len(rest) >= length:
                    self.bytes = rest[length:]
                    return json.loads(rest[:length])
            ready, _, _ = select.select([self.process.stdout], [], [], max(0, deadline - time.monotonic()))
            if not ready:
                raise Gone("no answer in time")
            block = os.read(self.process.stdout.fileno(), 1 << 16)
            if not block:
                raise Gone(f"the server ended: {self.process.wait(10)} {self.process.stderr.read().decode()}")
            self.bytes += block

    def diagnostics(self, name, version=None, seconds=60):
        """The next that are told of a text, of that version if one is given."""
        deadline = time.monotonic() + seconds
        wanted = uri(self.path(name))
        while True:
            for at, message in enumerate(self.told):
                if message.get("method") != "textDocument/publishDiagnostics":
                    continue
                parameters = message["params"]
                if parameters["uri"] == wanted and version in (None, parameters.get("version")):
                    del self.told[:at + 1]
                    return parameters["diagnostics"]
            self.told.append(self.read(deadline))

    def path(self, name):
        return os.path.join(self.folder or "/nowhere", name)

    def open(self, name, text):
        self.versions[name] = 1
        self.tell("textDocument/didOpen", {"textDocument": {"uri": uri(self.path(name)), "languageId": "pov", "version": 1, "text": text}})

    def change(self, name, *changes):
        """Each a whole text, or (first line, character, last line, character, text)."""
        self.versions[name] += 1
        made = [{"text": one} if isinstance(one, str) else {"range": span(*one[:4]), "text": one[4]} for one in changes]
        self.tell("textDocument/didChange", {
            "textDocument": {"uri": uri(self.path(name)), "version": self.versions[name]}, "contentChanges": made})
        return self.versions[name]

    def at(self, name, line, character, **more):
        return {"textDocument": {"uri": uri(self.path(name))}, "position": {"line": line, "character": character}, **more}

    def about(self, name, **more):
        return {"textDocument": {"uri": uri(self.path(name))}, **more}

    def memory(self):
        """Greatest that the server ever had, in MB."""
        with open(f"/proc/{self.process.pid}/status") as file:
            return int(next(line for line in file if line.startswith("VmHWM")).split()[1]) // 1024

    def end(self):
        """Its exit status after an orderly end."""
        assert self.ask("shutdown", None)["result"] is None
        self.tell("exit", None)
        return self.process.wait(20)


def uri(path):
    return "file://" + path


def span(line, character, last_line, last_character):
    return {"start": {"line": line, "character": character}, "end": {"line": last_line, "character": last_character}}


def places(locations):
    """name:line:character of each, short for comparisons."""
    return [f'{os.path.basename(one["uri"])}:{one["range"]["start"]["line"]}:{one["range"]["start"]["character"]}'
            for one in locations]


def applied(text, edits):
    """A text with edits of the protocol (ASCII)."""
    starts = [0]
    for line in text.split("\n"):
        starts.append(starts[-1] + len(line) + 1)
    offset = lambda place: min(starts[min(place["line"], len(starts) - 1)] + place["character"], len(text))
    for edit in sorted(edits, key=lambda one: offset(one["range"]["start"]), reverse=True):
        text = text[:offset(edit["range"]["start"])] + edit["newText"] + text[offset(edit["range"]["end"]):]
    return text
