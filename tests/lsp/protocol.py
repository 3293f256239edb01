#!/usr/bin/python3
"""`whittle lsp` as a client sees it: each request once, results stated by hand.

usage: protocol.py WHITTLE
"""
import os
import shutil
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from client import Client, applied, places, span, uri  # noqa: E402

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -5*z look_at 0 }\nlight_source { 5*y-5*z, rgb 1 }\n"


def texts(diagnostics):
    return [one["message"] for one in diagnostics]


def labels(result):
    return {one["label"] for one in result["items"]}


def check_diagnostics(client):
    client.open("a.pov", HEAD + "sphere { 0, 1 pigment { colr 1 } }\nbox { 1, 2 foo }\n")
    found = client.diagnostics("a.pov", 1)
    assert texts(found) == ["'colr' is not declared; did you mean 'color'?", "'foo' is not declared; did you mean 'fog'?"], found
    assert found[0]["range"] == span(4, 24, 4, 28) and found[0]["severity"] == 1 and found[0]["source"] == "whittle", found
    assert found[1]["range"] == span(5, 11, 5, 14), found
    # Two changes in one message, the second of the text that the first made.
    version = client.change("a.pov", (4, 24, 4, 28, "rgb"), (5, 11, 5, 15, ""))
    found = client.diagnostics("a.pov", version)
    assert [(one["code"], one["range"]) for one in found] == [("no-pigment", span(5, 0, 5, 3))], found
    # A brace that is not closed: where it was opened.
    version = client.change("a.pov", HEAD + "union {\n  sphere { 0, 1\n    pigment { rgb 1 }\n  box { 1, 2 }\n}\n")
    found = client.diagnostics("a.pov", version)
    assert len(found) == 1 and "stands in line 6" in found[0]["message"], found
    assert found[0]["range"] == span(7, 2, 7, 5), found
    opened = found[0]["relatedInformation"]
    assert [(one["message"], one["location"]["range"]) for one in opened] == [("opened here", span(5, 9, 5, 10))], opened
    # In a macro: where it was called.
    version = client.change("a.pov", HEAD + "#macro Ball(R)\n  sphere { 0, R pigment { gren 1 } }\n#end\nBall(1)\n")
    found = client.diagnostics("a.pov", version)
    assert texts(found)[0].startswith("'gren' is not declared"), found
    called = found[0]["relatedInformation"][0]
    assert called["message"] == "in the expansion of macro Ball" and called["location"]["range"]["start"]["line"] == 7, called


def check_lint(client):
    client.open("lint.pov", HEAD + "#declare Unused = 1;\nsphere { 0, -1 pigment { rgb 1 } }\nsphere { 3, 1 }\n")
    found = {one["code"]: one for one in client.diagnostics("lint.pov", 1)}
    assert set(found) == {"unused-name", "negative-size", "no-pigment"}, found
    assert found["unused-name"]["range"] == span(4, 9, 4, 15) and found["unused-name"]["severity"] == 2, found
    assert found["no-pigment"]["range"]["start"] == {"line": 6, "character": 0}, found
    assert "[" not in found["no-pigment"]["message"], found


def check_overlay(client):
    """What the editor has lies over what is on disk, in include files too."""
    with open(client.path("part.inc"), "w") as out:
        out.write("#declare Part = sphere { 0, 1 pigment { rgb 1 } }\n")
    client.open("whole.pov", HEAD + '#include "part.inc"\nobject { Part }\n')
    assert client.diagnostics("whole.pov", 1) == []
    client.open("part.inc", "#declare Part = sphere { 0, 1 pigmnt { rgb 1 } }\n")  # not on disk
    found = client.diagnostics("part.inc", 1)
    assert len(found) == 1 and found[0]["range"] == span(0, 30, 0, 36), found
    assert found[0]["relatedInformation"][-1]["message"] == "included here", found
    leads = client.diagnostics("whole.pov")
    while not leads:
        leads = client.diagnostics("whole.pov")
    assert leads[0]["message"].startswith("leads to: ") and leads[0]["range"]["start"]["line"] == 4, leads
    # A brace that the include file leaves open is missed in the scene.
    client.change("part.inc", "#declare Part = sphere { 0, 1 pigment { rgb 1 }\n")
    while leads[0]["message"].startswith("leads to: "):
        leads = client.diagnostics("whole.pov")
    opened = leads[0]["relatedInformation"]
    assert leads[0]["range"] == span(5, 0, 5, 6) and places(one["location"] for one in opened) == ["part.inc:0:23"], leads
    client.change("part.inc", (0, 47, 0, 47, " }"))
    while leads:
        leads = client.diagnostics("whole.pov")
    client.tell("textDocument/didClose", client.about("part.inc"))
    # An include file that nothing open reads: its brackets alone.
    client.open("alone.inc", "#declare P = Elsewhere + sphere { 0, 1\n")
    assert texts(client.diagnostics("alone.inc", 1)) == ["this '{' has no partner"]


def check_completion(client):
    client.open("c.pov", HEAD + '#declare Radius = 2;\n#include "\nsphere { 0, 1\n  finish {  }\n  \n}\n#\n')
    ask = lambda line, character: client.result("textDocument/completion", client.at("c.pov", line, character))
    finish = labels(ask(7, 11))
    assert {"phong", "reflection", "ambient", "Radius"} <= finish and not {"sphere", "pigment", "rgb"} & finish, finish
    solid = labels(ask(8, 2))
    assert {"pigment", "texture", "translate", "Radius"} <= solid and not {"phong", "camera"} & solid, solid
    directives = labels(ask(10, 1))
    assert {"declare", "macro", "include"} <= directives and not {"sphere", "Radius"} & directives, directives
    os.makedirs(client.path("lib"), exist_ok=True)
    for name in ("gears.inc", "lib/bolts.inc", "notes.txt"):
        with open(client.path(name), "w"):
            pass
    files = ask(5, 10)["items"]
    by_name = {one["label"]: one for one in files}
    assert {"gears.inc", "lib"} <= set(by_name) and "notes.txt" not in by_name, by_name.keys()
    assert by_name["gears.inc"]["textEdit"] == {"range": span(5, 10, 5, 10), "newText": "gears.inc"}, by_name["gears.inc"]
    client.change("c.pov", (5, 10, 5, 10, "lib/b"))
    files = ask(5, 15)["items"]
    assert [(one["label"], one["textEdit"]["range"]) for one in files] == [("bolts.inc", span(5, 14, 5, 15))], files


def check_names(client):
    with open(client.path("names.inc"), "w") as out:
        out.write("#declare Wide = 3;\n#declare Tall = Wide * 2;\n")
    client.open("n.pov", HEAD + '#include "names.inc"\n#macro Ball(R, C)\n  #local S = R * Wide;\n  sphere { C, S pigment { rgb 1 } }\n#end\n'
                "Ball(Wide, 0)\nsphere { 0, Tall pigment { rgb 1 } }\n")
    assert client.diagnostics("n.pov", 1) == []
    hover = client.result("textDocument/hover", client.at("n.pov", 10, 13))
    assert hover["range"] == span(10, 12, 10, 16), hover
    for part in ("#declare Tall = Wide * 2;", "`6`", "line 2 of names.inc"):
        assert part in hover["contents"]["value"], hover
    keyword = client.result("textDocument/hover", client.at("n.pov", 10, 2))
    assert keyword["contents"]["value"].startswith("A ball: centre and radius."), keyword
    assert client.result("textDocument/hover", client.at("n.pov", 10, 9)) is None

    at = lambda method, line, character, **more: client.result("textDocument/" + method, client.at("n.pov", line, character, **more))
    assert places(at("definition", 10, 14)) == ["names.inc:1:9"]
    assert places(at("definition", 7, 14)) == ["n.pov:6:9"]
    assert places(at("definition", 9, 1)) == ["n.pov:5:7"]
    assert places(at("definition", 4, 14)) == ["names.inc:0:0"]
    assert at("definition", 10, 1) is None
    assert places(at("references", 9, 6, context={"includeDeclaration": True})) == [
        "n.pov:6:17", "n.pov:9:5", "names.inc:0:9", "names.inc:1:16"]
    assert places(at("references", 9, 6, context={"includeDeclaration": False})) == [
        "n.pov:6:17", "n.pov:9:5", "names.inc:1:16"]
    assert [one["range"] for one in at("documentHighlight", 6, 9)] == [span(6, 9, 6, 10), span(7, 14, 7, 15)]


def check_rename(client):
    """Of the texts of check_names()."""
    ask = lambda method, line, character, **more: client.ask("textDocument/" + method, client.at("n.pov", line, character, **more))
    assert ask("prepareRename", 7, 14)["result"] == {"range": span(7, 14, 7, 15), "placeholder": "S"}
    edits = ask("rename", 7, 14, newName="Size")["result"]["changes"]
    assert edits == {uri(client.path("n.pov")): [{"range": span(6, 9, 6, 10), "newText": "Size"},
                                                 {"range": span(7, 14, 7, 15), "newText": "Size"}]}, edits
    both = ask("rename", 10, 13, newName="High")["result"]["changes"]
    assert {os.path.basename(name): len(found) for name, found in both.items()} == {"n.pov": 1, "names.inc": 1}, both
    for line, character, name, reason in ((10, 2, None, "'sphere' is a reserved word"), (10, 9, None, "no name stands here")):
        assert ask("prepareRename", line, character)["error"]["message"] == reason
    for name, reason in (("sphere", "'sphere' is a reserved word"), ("2x", "'2x' is no name"), ("", "'' is no name"),
                         ("Wide", "'Wide' has a meaning already"), ("C", "'C' has a meaning already")):
        assert ask("rename", 7, 14, newName=name)["error"]["message"] == reason, (name, reason)
    # A name of a file that is not the workspace's.
    outside = tempfile.mkdtemp(prefix="whittle-outside-")
    with open(os.path.join(outside, "far.inc"), "w") as out:
        out.write("#declare Far = 1;\n")
    client.open("o.pov", f'#version 3.7;\n#include "{outside}/far.inc"\nsphere {{ 0, Far }}\n')
    refused = client.ask("textDocument/prepareRename", client.at("o.pov", 2, 13))["error"]["message"]
    assert "outside of the workspace" in refused, refused
    shutil.rmtree(outside)


def check_structure(client):
    client.open("s.pov", "#version 3.7;\n// one\n// two\n#declare A = 1;\n#macro M(X)\n  #local L = X;\n#end\nsphere {\n  0, 1\n}\n")
    found = client.result("textDocument/documentSymbol", client.about("s.pov"))
    assert [(one["name"], one["range"]["start"]["line"], one["range"]["end"]["line"]) for one in found] == [
        ("A", 3, 3), ("M", 4, 6), ("sphere", 7, 9)], found
    assert [one["name"] for one in found[1]["children"]] == ["L"] and found[0]["selectionRange"] == span(3, 9, 3, 10), found
    folds = client.result("textDocument/foldingRange", client.about("s.pov"))
    assert folds == [{"startLine": 4, "endLine": 5}, {"startLine": 7, "endLine": 8},
                     {"startLine": 1, "endLine": 2, "kind": "comment"}], folds


def check_colors(client):
    client.open("k.pov", HEAD + "sphere { 0, 1 pigment { rgb <1, 0.5, 0> } }\nbackground { srgb <0.25, 0, 1> }\n")
    found = client.result("textDocument/documentColor", client.about("k.pov"))
    assert [one["range"] for one in found] == [span(3, 24, 3, 29), span(4, 24, 4, 39), span(5, 13, 5, 30)], found
    assert abs(found[1]["color"]["green"] - 0.7354) < 1e-3 and found[1]["color"]["red"] == 1, found  # linear light on a screen
    assert found[2]["color"] == {"red": 0.25, "green": 0, "blue": 1, "alpha": 1}, found
    shown = client.result("textDocument/colorPresentation", client.about(
        "k.pov", range=span(4, 24, 4, 39), color={"red": 0, "green": 1, "blue": 0.7354, "alpha": 0.5}))
    assert shown == [{"label": "rgbt <0, 1, 0.5, 0.5>",
                      "textEdit": {"range": span(4, 24, 4, 39), "newText": "rgbt <0, 1, 0.5, 0.5>"}}], shown


def check_layout(client):
    text = "union{\nbox{0,1}\nsphere{0,1}\n}\n"
    client.open("f.pov", text)
    options = {"tabSize": 2, "insertSpaces": True}
    edits = client.result("textDocument/formatting", client.about("f.pov", options=options))
    assert applied(text, edits) == "union {\n  box { 0, 1 }\n  sphere { 0, 1 }\n}\n", edits
    edits = client.result("textDocument/rangeFormatting", client.about("f.pov", options=options, range=span(2, 0, 3, 0)))
    assert applied(text, edits) == "union{\nbox{0,1}\n  sphere { 0, 1 }\n}\n", edits
    edits = client.result("textDocument/formatting", client.about("f.pov", options={"tabSize": 4, "insertSpaces": False}))
    assert applied(text, edits) == "union {\n\tbox { 0, 1 }\n\tsphere { 0, 1 }\n}\n", edits
    client.open("g.pov", 'box { 0, 1 }\n#declare A = "open\n')
    refused = client.ask("textDocument/formatting", client.about("g.pov", options=options))["error"]
    assert refused["message"].startswith("line 2: "), refused


def check_encodings(program, folder):
    """A line with characters outside of ASCII: UTF-16 unless the client offers UTF-8."""
    line = '/* \u00e4\U0001F600 */ #declare A = 1; sphere { 0, A }\n'
    for encodings, name, column in ((None, "utf-16", line.index("A }") + 1), (["utf-8", "utf-16"], "utf-8", len(line[:line.index("A }")].encode()))):
        client = Client(program, folder=folder, encodings=encodings)
        assert client.capabilities["positionEncoding"] == name
        client.open("u.pov", line)
        found = client.result("textDocument/references", client.at("u.pov", 0, column))
        shift = {"utf-16": 1, "utf-8": 4}[name]
        assert [one["range"]["start"]["character"] for one in found] == [line.index("A =") + shift, column], (name, found)
        # An edit behind those characters lands where it should.
        client.change("u.pov", (0, column, 0, column + 1, "B"))
        hover = client.result("textDocument/documentHighlight", client.at("u.pov", 0, line.index("A =") + shift))
        assert len(hover) == 1, hover
        assert client.end() == 0


def check_endless(program, folder):
    """A scene that never ends blocks nothing: answers come at once, newer text is read at once, time and memory are bounded."""
    client = Client(program, ["--seconds=2", "--memory=300"], folder)
    client.open("loop.pov", HEAD + "#declare I = 1;\n#while (I > 0)\n  #declare I = I + 1;\n#end\n")
    begin = time.monotonic()
    assert client.result("textDocument/hover", client.at("loop.pov", 6, 12)) is not None
    version = client.change("loop.pov", (5, 0, 7, 4, ""))
    assert [one["code"] for one in client.diagnostics("loop.pov", version)] == ["unused-name"]
    version = client.change("loop.pov", HEAD + "#declare I = 1;\n#while (I > 0)\n  #declare I = I + 1;\n#end\n")
    found = client.diagnostics("loop.pov", version)
    assert [one["code"] for one in found] == ["endless-loop"] and found[0]["range"]["start"]["line"] in (5, 6, 7), found
    assert time.monotonic() - begin < 60
    version = client.change("loop.pov", HEAD + "#while (1)\n  sphere { 0, 1 pigment { rgb 1 } }\n#end\n")
    found = client.diagnostics("loop.pov", version)
    assert "endless-loop" in [one["code"] for one in found], found
    assert client.memory() < 1200, client.memory()
    # Another scene does not wait for it.
    client.change("loop.pov", HEAD + "#declare I = 1;\n#while (I > 0)\n  #declare I = I + 1;\n#end\n")
    client.open("other.pov", "sphere { 0, 1 pigmnt }\n")
    assert client.diagnostics("other.pov", 1)[0]["message"].startswith("'pigmnt'")
    assert client.end() == 0


def check_life(program, folder):
    """What the protocol says of its beginning and its end."""
    client = Client(program, folder=folder, initialize=False)
    assert client.ask("textDocument/hover", {})["error"]["code"] == -32002
    client.tell("textDocument/didOpen", {})  # is dropped
    assert "capabilities" in client.ask("initialize", {"capabilities": {}})["result"]
    assert client.ask("initialize", {"capabilities": {}})["error"]["code"] == -32600
    assert client.ask("no/such", {})["error"]["code"] == -32601
    client.tell("no/such", {})
    assert client.ask("textDocument/hover", {})["error"]["code"] == -32602
    assert client.ask("textDocument/hover", {"textDocument": {"uri": 5}, "position": 3})["error"]["code"] == -32602
    client.raw(b"Content-Length: 9\r\n\r\nno json !")
    assert client.answer(None)["error"]["code"] == -32700
    client.raw(b"Content-Length: 2\r\n\r\n[]")
    assert client.answer(None)["error"]["code"] == -32600
    client.raw(b"content-length:  46\r\nContent-Type: x\r\n\r\n" + b'{"jsonrpc":"2.0","id":"a","method":"no/such2"}')
    assert client.answer("a")["error"]["code"] == -32601
    assert client.ask("shutdown", None)["result"] is None
    assert client.ask("textDocument/hover", {})["error"]["code"] == -32600
    client.tell("exit", None)
    assert client.process.wait(20) == 0
    for leave in (lambda one: one.tell("exit", None), lambda one: one.process.stdin.close()):
        client = Client(program, folder=folder)
        leave(client)
        assert client.process.wait(20) == 1
    # A client that goes away while a scene is read.
    client = Client(program, folder=folder)
    client.open("loop.pov", "#while (1)\n#end\n")
    time.sleep(0.3)
    client.process.stdin.close()
    client.process.stdout.close()
    assert client.process.wait(20) == 1


def main():
    program = os.path.abspath(sys.argv[1])
    folder = tempfile.mkdtemp(prefix="whittle-lsp-")
    try:
        client = Client(program, folder=folder)
        for check in (check_diagnostics, check_lint, check_overlay, check_completion, check_names, check_rename, check_structure,
                      check_colors, check_layout):
            check(client)
            print(check.__name__[6:], "ok", flush=True)
        assert client.end() == 0
        for check in (check_encodings, check_endless, check_life):
            check(program, folder)
            print(check.__name__[6:], "ok", flush=True)
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
