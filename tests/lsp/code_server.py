"""The extension for Visual Studio Code in the editor itself: code-server, which is Visual Studio Code behind a web server, driven in headless
Chromium. Colours, diagnostics, hover, and with `whittle watch` both ways: a click on the picture shows the line, the cursor lights up the picture.

usage: code_server.py WHITTLE [--shots FOLDER]     exit status 0: passed, 77: no code-server or no browser

WHITTLE_CODE_SERVER names code-server's entry (out/node/entry.js), WHITTLE_VSIX the packed extension; nothing is fetched. How to get them:
editors/vscode/README.md.
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

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "watch"))
import browser  # noqa: E402
from watched import NO_BROWSER, asked  # noqa: E402

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.4 } }
sphere { <-1.2, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.2, 0.1> } }
box { <0.4, 0, -0.5>, <1.6, 1.2, 0.5> pigment { rgb <0.1, 0.2, 0.9> } }
"""


class CodeServer:
    def __init__(self, entry, vsix, whittle, folder):
        self.folder = folder
        data, extensions = folder / "data", folder / "extensions"
        (data / "User").mkdir(parents=True)
        (data / "User/settings.json").write_text(json.dumps({
            "whittle.program": whittle, "whittle.watchArguments": ["+W320", "+H240"], "workbench.startupEditor": "none",
            "security.workspace.trust.enabled": False, "window.restoreWindows": "none", "telemetry.telemetryLevel": "off"}))
        words = ["node", entry, "--user-data-dir", str(data), "--extensions-dir", str(extensions)]
        subprocess.run([*words, "--install-extension", vsix], check=True, stdout=subprocess.DEVNULL, timeout=120)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.process = subprocess.Popen([*words, "--auth", "none", "--bind-addr", f"127.0.0.1:{self.port}", "--disable-telemetry",
                                         "--disable-update-check", "--disable-workspace-trust"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        start_new_session=True)
        for _ in range(200):
            try:
                socket.create_connection(("127.0.0.1", self.port), 1).close()
                return
            except OSError:
                time.sleep(0.1)
        raise TimeoutError("code-server does not listen")

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()


def command(page, title):
    """By the palette."""
    page.call("Input.dispatchKeyEvent", type="keyDown", key="F1", code="F1", windowsVirtualKeyCode=112)
    page.call("Input.dispatchKeyEvent", type="keyUp", key="F1", code="F1", windowsVirtualKeyCode=112)
    page.wait("document.querySelector('.quick-input-widget input')?.offsetParent !== null")
    page.call("Input.insertText", text=title)
    page.wait(f"[...document.querySelectorAll('.quick-input-list .monaco-list-row')].some(r => r.ariaLabel?.includes({json.dumps(title)}))")
    page.key("Enter")


def main():
    arguments = asked()
    entry, vsix = os.environ.get("WHITTLE_CODE_SERVER"), os.environ.get("WHITTLE_VSIX")
    if arguments is None or not entry or not vsix or not shutil.which("node"):
        print("no browser, code-server or packed extension: not tested")
        return NO_BROWSER
    folder = pathlib.Path(tempfile.mkdtemp(prefix="whittle-code-"))
    os.environ["XDG_RUNTIME_DIR"] = str(folder)
    work = folder / "work"
    work.mkdir()
    (work / "scene.pov").write_text(SCENE)
    (work / "wrong.pov").write_text(SCENE.replace("sphere {", "shpere {"))
    server = CodeServer(entry, vsix, os.path.abspath(arguments.whittle), folder)
    try:
        with browser.Browser(1400, 900) as page:
            shot = lambda name: arguments.shots and page.screenshot(f"{arguments.shots}/code_{name}.png")  # noqa: E731

            def open_file(name):
                payload = json.dumps([["openFile", f"vscode-remote://127.0.0.1:{server.port}{work}/{name}"]])
                page.open(f"http://127.0.0.1:{server.port}/?folder={work}&payload={payload}")
                page.wait("document.querySelector('.monaco-editor .view-line')?.innerText.includes('#version')", 90)

            print("diagnostics and colours")
            open_file("wrong.pov")
            page.wait("document.querySelector('.squiggly-error') !== null", 60)
            colours = page.ask("new Set([...document.querySelectorAll('.view-line span span')].map(s => getComputedStyle(s).color)).size")
            assert colours > 3, colours
            shot("wrong")

            print("the page beside the text")
            open_file("scene.pov")
            time.sleep(2)
            command(page, "Whittle: show the picture")
            page.wait("[...document.querySelectorAll('.tab')].some(t => /Simple Browser/.test(t.innerText + t.ariaLabel))", 60)
            time.sleep(3)
            shot("page")
            check_both_ways(page, server, work, folder, shot)
            assert not page.ask("document.querySelector('.squiggly-error') !== null")
    finally:
        server.close()
        for _ in range(20):
            shutil.rmtree(folder, ignore_errors=True)
            if not folder.exists():
                break
            time.sleep(0.2)
    return 0


def check_both_ways(page, server, work, folder, shot):
    """Messages between both go by a folder of sockets: another end listens here and speaks, as a page would."""
    print("the cursor is told, a place is shown")
    mail = folder / "whittle"
    ear = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    ear.bind(str(mail / "watch-0"))
    ear.settimeout(20)
    page.ask("document.querySelector('.monaco-editor textarea, .monaco-editor .native-edit-context').focus()")
    page.key("ArrowDown")
    told = json.loads(ear.recv(65536))["cursor"]
    assert told["file"] == str(work / "scene.pov"), told
    language_server = next(name for name in os.listdir(mail) if name.startswith("lsp-"))
    ear.sendto(json.dumps({"show": {"file": told["file"], "line": 6, "column": 1}}).encode(), str(mail / language_server))
    while "shown" not in (answer := json.loads(ear.recv(65536))):
        pass
    assert answer["shown"]["line"] == 6
    page.wait("[...document.querySelectorAll('.statusbar-item')].some(i => /Ln 6, Col/.test(i.innerText))")
    at = SCENE.index("sphere")
    while (told := json.loads(ear.recv(65536)).get("cursor", {})).get("offset") not in range(at, at + 7):
        pass
    ear.close()
    os.unlink(mail / "watch-0")
    shot("shown")


if __name__ == "__main__":
    sys.exit(main())
