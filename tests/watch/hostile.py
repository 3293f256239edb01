"""Bad input to the server of `whittle watch`: random and truncated requests, clients that go away, two clients, a scene that never
ends. No crash, no leak, memory bounded, no file changed.

usage: hostile.py WHITTLE [--requests N] [--seed N]
"""
import json
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import bad_input  # noqa: E402

SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 } light_source { <5, 8, -6> rgb 1 }
sphere { 0, 1 pigment { rgb <%s> } }
"""
PAGES = 8  # the server's limit
NAMES = ["x", "y", "name", "file", "numbers", "offset", "value", "clock", "declared", "orbit", "cut", "request", "with"]


class Server:
    def __init__(self, program):
        self.folder = tempfile.mkdtemp(prefix="whittle-hostile-")
        self.scene = os.path.join(self.folder, "scene.pov")
        self.save(SCENE % "1, 0, 0")
        self.mail = tempfile.mkdtemp(prefix="whittle-mail-")
        # One arena for all threads: each would fill one of its own by and by, which is no leak.
        alone = {"XDG_RUNTIME_DIR": self.mail, "MALLOC_ARENA_MAX": "1"}
        self.process = subprocess.Popen([program, "watch", self.scene, "+W80", "+H60"], cwd=self.folder, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True, env={**os.environ, **alone})
        self.address = self.process.stdout.readline().strip()
        self.port = int(self.address.split(":")[2].split("/")[0])
        self.token = self.address.split("/")[3]

    def save(self, text):
        with open(self.scene, "w") as out:
            out.write(text)

    def descriptors(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def connect(self, seconds=10):
        return socket.create_connection(("127.0.0.1", self.port), seconds)

    def get(self, path, host=None, **more):
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}/{path}", **more)
        if host:
            request.add_header("Host", host)
        try:
            with urllib.request.urlopen(request, timeout=20) as answer:
                return answer.status, answer.read()
        except urllib.error.HTTPError as error:
            return error.code, error.read()

    def close(self):
        self.process.terminate()
        status = self.process.wait(20)
        errors = self.process.stderr.read()
        left = os.listdir(self.folder)
        mail = os.listdir(os.path.join(self.mail, "whittle"))
        shutil.rmtree(self.folder)
        shutil.rmtree(self.mail)
        assert not mail, mail
        assert status == 2, f"status {status}: {errors}"
        assert left == ["scene.pov"], left


class Page:
    """A client that reads events."""

    def __init__(self, server):
        self.socket = server.connect()
        self.socket.sendall(f"GET /{server.token}/events HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\n".encode())
        self.data = b""

    def until(self, word, seconds=20):
        deadline = time.monotonic() + seconds
        while word not in self.data:
            self.socket.settimeout(max(0.01, deadline - time.monotonic()))
            block = self.socket.recv(65536)
            if not block:
                raise AssertionError("the stream ended")
            self.data += block
        self.data = self.data[self.data.index(word) + len(word):]


def words(server, rng):
    """A request as a browser makes one, then spoilt."""
    paths = ["", "events", "pixel?x=3&y=4", "pixel?x=-1&y=99999999999", "pixel?x=1&y=2&z=3", "set", "compare", "../../etc/passwd",
             "show", "write", "open", "gallery", "thumbnail?name=scene.pov", "thumbnail?name=../scene.pov", "thumbnail?x", "%2e%2e/%00", "pixel?" + "x=1&" * 200, "a" * rng.choice([10, 3000, 9000])]
    bodies = ["{}", '{"clock":0.5}', '{"clock":1e999}', '{"declared":{"A":1}}', '{"orbit":{"yaw":"x"}}', '{"orbit":{"dolly":-1e300,"yaw":1e300}}',
              '{"cut":{"normal":[0,0,0]}}', '{"cut":{"normal":[1,2,3],"offset":0.1}}', '{"cut":null,"orbit":null}', "[" * 5000, '{"with":"reference"}',
              '{"with":3}', "\xff\xfe", '{"clock":', ""]
    method = rng.choice(["GET", "GET", "POST", "POST", "HEAD", "PUT", "DELETE", "OPTIONS", "TRACE", "\x00", "GE T"])
    token = rng.choice([server.token] * 4 + ["", server.token[:-1], "0" * 32])
    made = [{"x": 40, "y": 30}, {"x": bad_input.value(rng, NAMES), "y": 3}, {"name": "scene.pov"}, {"file": server.scene}, bad_input.value(rng, NAMES),
            {"numbers": [{"file": server.scene, "offset": rng.randrange(200), "value": bad_input.value(rng, NAMES)}]}]
    body = rng.choice(bodies + [json.dumps(one) for one in made]).encode("latin-1")
    length = rng.choice([len(body), len(body), len(body), len(body) + 50, 0, -5, 10 ** 12, "x"])
    if method != "POST" and rng.random() < 0.7:
        body, length = b"", 0
    host = rng.choice([f"127.0.0.1:{server.port}"] * 4 + [f"localhost:{server.port}", "evil.example", ""])
    extra = rng.choice(["", "", "", "Transfer-Encoding: chunked\r\n", "Range: bytes=5-1\r\n", "Range: bytes=0-99999999\r\n",
                        "Expect: 100-continue\r\n", "X: " + "y" * 9000 + "\r\n", "Connection: close\r\n",
                        "Content-Type: multipart/form-data; boundary=b\r\n", "Content-Encoding: gzip\r\n"])
    data = (f"{method} /{token}/{rng.choice(paths)} HTTP/1.1\r\nHost: {host}\r\nContent-Length: {length}\r\n{extra}\r\n").encode("latin-1") + body
    how = rng.random()
    if how < 0.3:
        data = bad_input.cut_short(rng, data)
    elif how < 0.6:
        data = bad_input.mangled(rng, data, 12)
    elif how < 0.65:
        data = rng.randbytes(rng.randrange(2000))
    return data


def attack(server, rng, count):
    """Returns how many were answered: a server that hangs up on all of them would prove nothing."""
    answered = 0
    for k in range(count):
        try:
            with server.connect() as client:
                client.sendall(words(server, rng))
                if rng.random() < 0.3:
                    continue  # gone before the answer
                # Not shut down on our side: the server hangs up on that without reading what was sent.
                client.settimeout(0.02)
                answered += client.recv(rng.choice([12, 100, 65536])).startswith(b"HTTP/1.1")
        except (ConnectionError, socket.timeout):
            pass
        if k % 500 == 0:
            assert server.process.poll() is None, "the program ended"
    return answered


def main():
    arguments, rng = bad_input.asked("hostile requests to whittle watch", 500)
    server = Server(arguments.whittle)
    try:
        t, port = server.token, server.port
        assert server.get(f"{t}/")[0] == 200
        for path in ("", "x", t, t[:-1] + "/", "0" * 32 + "/", f"{t}/scene.pov", f"{t}/../{t}/nothing"):
            assert server.get(path)[0] == 404, path
        assert server.get(f"{t}/", host="evil.example")[0] == 404
        assert server.get(f"{t}/", host=f"localhost:{port}")[0] == 200
        assert server.get(f"{t}/set", data=b"no json", method="POST")[0] == 400
        assert server.get(f"{t}/pixel?x=80&y=0")[0] == 400

        # Two clients see the same; a third that goes away harms none.
        one, two, three = Page(server), Page(server), Page(server)
        for page in (one, two):
            page.until(b"event: done")
        three.socket.close()
        server.save(SCENE % "0, 1, 0")
        for page in (one, two):
            page.until(b"event: done")
        # More pages than there are places: told so, and there is one when another has gone.
        more = [Page(server) for _ in range(PAGES + 2)]
        time.sleep(0.3)
        assert server.get(f"{t}/events", method="GET")[0] == 503
        for page in more:
            page.socket.close()

        attack(server, rng, min(500, arguments.requests))  # whatever is set up once is there now
        for k in range(20):
            server.save(SCENE % f"0, 0, {k / 20}")
            time.sleep(0.05)
        time.sleep(3)
        before, opened = bad_input.held(server.process, "VmRSS"), server.descriptors()
        started = time.monotonic()
        answered = attack(server, rng, arguments.requests)
        bad_input.datagrams(rng, os.path.join(server.mail, "whittle"), arguments.requests, [server.scene, "/etc/passwd", "scene.pov"])
        took = time.monotonic() - started
        for k in range(100):
            server.save(SCENE % f"0, {k / 100}, 0")
            time.sleep(0.01)
        time.sleep(4)  # connections that were left open are dropped
        after, open_now = bad_input.held(server.process, "VmRSS"), server.descriptors()
        assert answered > 0.2 * arguments.requests, answered
        print(f"{arguments.requests} requests in {took:.1f} s, {answered} answered: memory {before} kB before, {after} kB after; "
              f"descriptors {opened} before, {open_now} after")
        assert after < before + 20000, "memory grew"
        assert open_now <= opened + 2, "descriptors are left open"

        # A scene that never ends is cancelled by a save; one that takes all levels of a loop too.
        page = Page(server)
        page.until(b"event: done")
        for text in ("#while (1) #end", "#declare A = 0; #while (1) #declare A = A + 1; #end",
                     "#macro M(N) #while (N > 0) #declare B = N; #end #end M(1)"):
            server.save(text)
            time.sleep(0.3)
            asked = time.monotonic()
            server.save(SCENE % "1, 1, 0")
            page.until(b"event: done")
            assert time.monotonic() - asked < 5, text
        answer = json.loads(server.get(f"{t}/pixel?x=40&y=30")[1])
        assert "sphere" in answer["text"], answer
        assert server.process.poll() is None
    finally:
        server.close()
    print("passed")


if __name__ == "__main__":
    sys.exit(main())
