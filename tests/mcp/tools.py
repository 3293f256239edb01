#!/usr/bin/python3
"""Each tool of `whittle mcp`, its walls and its limits.

usage: tools.py WHITTLE
"""
import base64
import json
import os
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from client import Client  # noqa: E402

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 45 }
light_source { <-5, 5, -5>, 1 }
#declare Ball = sphere { 0, 1 pigment { rgb <1, 0.5, 0> } }
object { Ball }
"""
ENDLESS = "#version 3.7;\n#while (1)\n#declare A = 1;\n#end\n"
LARGE = "#version 3.7;\n#declare A = array[1000000];\n#declare I = 0;\n#while (1)\n sphere { I, 1 }\n #declare I = I + 1;\n#end\n"


def refused(client, code, method, parameters=None):
    try:
        client.ask(method, parameters)
    except ValueError as error:
        assert error.args[0] == code, error
        return error.args[1]
    raise AssertionError(("not refused", method, parameters))


def check_protocol(client):
    assert client.server["protocolVersion"] == "2025-06-18" and client.server["serverInfo"]["name"] == "whittle"
    assert set(client.server["capabilities"]) == {"tools", "resources"}
    assert client.ask("ping") == {}
    tools = {tool["name"]: tool for tool in client.ask("tools/list")["tools"]}
    assert set(tools) == {"check", "render", "pixel", "info", "section", "mesh", "compare", "explain_keyword"}
    assert all(tool["inputSchema"]["type"] == "object" and tool["description"] for tool in tools.values())
    resources = [one["uri"] for one in client.ask("resources/list")["resources"]]
    for uri in resources:
        assert len(client.ask("resources/read", {"uri": uri})["contents"][0]["text"]) > 500, uri
    assert client.ask("resources/templates/list") == {"resourceTemplates": []}
    refused(client, -32002, "resources/read", {"uri": "whittle://no"})
    refused(client, -32602, "resources/read")
    refused(client, -32601, "prompts/list")
    refused(client, -32600, "initialize", {"protocolVersion": "2025-06-18"})
    refused(client, -32602, "tools/call", {"name": "no"})
    refused(client, -32602, "tools/call", {"name": "check", "arguments": []})
    refused(client, -32602, "tools/call", {"name": "check", "arguments": {}})
    refused(client, -32602, "tools/call", {"name": "check", "arguments": {"scene": "", "file": "a.pov"}})
    refused(client, -32602, "tools/call", {"name": "check", "arguments": {"scene": "", "no": 1}})
    refused(client, -32602, "tools/call", {"name": "pixel", "arguments": {"scene": ""}})
    client.send({"id": 7})
    assert json.loads(client.process.stdout.readline())["error"]["code"] == -32600
    client.process.stdin.write(b"{\n\n[]\n")
    client.process.stdin.flush()
    assert [json.loads(client.process.stdout.readline())["error"]["code"] for _ in range(2)] == [-32700, -32600]


def check_tools(client, folder):
    result, text = client.call("check", scene=SCENE)
    assert result["structuredContent"] == {"readable": True, "messages": []} and not result["isError"], result
    result, text = client.call("check", scene=SCENE.replace("object { Ball", "object { Balll"))
    message = result["structuredContent"]["messages"][0]
    assert (message["severity"], message["file"], message["line"], message["column"]) == ("error", "scene.pov", 6, 10), message
    assert message["suggestion"] == "Ball" and "scene.pov:6:10: error" in text
    pictures = []
    for scene in (SCENE, SCENE.replace("0.5, 0>", "0.6, 0>")):
        result, text = client.call("render", scene=scene, width=64, height=48)
        image = result["content"][0]
        assert image["mimeType"] == "image/png" and base64.b64decode(image["data"]).startswith(b"\x89PNG"), result
        pictures.append(text.split("\n")[0])
    result, text = client.call("compare", a=pictures[0], b=pictures[1])
    assert "differ" in text and "flip" in text, text
    result, text = client.call("compare", a=pictures[0], b=pictures[0])
    assert "equal" in text and not result["isError"], text
    result, text = client.call("render", scene="sphere {", width=64, height=48)
    assert result["isError"] and "scene.pov:1:" in text, text
    result, text = client.call("pixel", scene=SCENE, x=32, y=24, width=64, height=48)
    assert "diffuse" in text and "scene.pov:6" in text, text
    result, text = client.call("info", scene=SCENE, object="Ball")
    assert abs(json.loads(text.split("\n")[0])["volume"] - 4.18879) < 2e-3, text
    result, text = client.call("section", scene=SCENE, axis="y", value=0.5)
    assert result["content"][1]["resource"]["text"].lstrip().startswith("<"), result
    assert abs(json.loads(text.split("\n")[0])["area"] - 2.356) < 0.05, text
    result, text = client.call("mesh", scene=SCENE, tolerance=0.1, format="obj")
    assert b"\nf " in base64.b64decode(result["content"][1]["resource"]["blob"]), text
    result, text = client.call("mesh", scene=SCENE, tolerance=0.1, format="glb")
    assert base64.b64decode(result["content"][1]["resource"]["blob"]).startswith(b"glTF"), text
    result, text = client.call("explain_keyword", word="reflection", block="finish")
    assert "may stand" in text and "finish" in text, text
    assert client.call("explain_keyword", word="no_such_word")[0]["isError"]
    with open(folder + "/s.pov", "w", encoding="utf-8") as file:
        file.write('#include "part.inc"\n' + SCENE)
    with open(folder + "/part.inc", "w", encoding="utf-8") as file:
        file.write("#declare Part = 1;\n")
    assert client.call("check", file="s.pov")[0]["structuredContent"]["readable"]
    assert not client.call("render", file="s.pov", width=8, height=8)[0]["isError"]
    result, text = client.call("check", scene="#if (N < 3) #error \"few\" #end #debug T", declare={"N": 2.5, "T": "a b"})
    assert "few" in text, text


def check_walls(client, folder):
    with open(os.path.dirname(folder) + "/secret.inc", "w", encoding="utf-8") as file:
        file.write('#declare Secret = "hidden";\n')
    for name in (os.path.dirname(folder) + "/secret.inc", "../secret.inc"):
        for tool in ("check", "render", "info"):
            result, text = client.call(tool, scene=f'#include "{name}"\n' + SCENE)
            assert result["isError"] or not result["structuredContent"]["readable"], (tool, result)
    refused(client, -32602, "tools/call", {"name": "check", "arguments": {"file": "../x.pov"}})
    refused(client, -32602, "tools/call", {"name": "check", "arguments": {"file": "/etc/passwd"}})
    refused(client, -32602, "tools/call", {"name": "compare", "arguments": {"a": "/etc/passwd", "b": "render-1.png"}})
    refused(client, -32602, "tools/call", {"name": "render", "arguments": {"scene": SCENE, "width": 100000, "height": 100000}})
    refused(client, -32602, "tools/call", {"name": "render", "arguments": {"scene": SCENE, "declare": {"A": "x\"\nOutput_File_Name=x"}}})
    before = sorted(os.listdir(folder))
    for path in ("out.txt", folder + "/out.txt", "../out.txt"):
        for tool in ("check", "render", "info", "mesh"):
            coarse = {"mesh": {"tolerance": 0.5}, "info": {"precision": 0.1}}.get(tool, {})
            client.call(tool, scene=f'#fopen F "{path}" write #write (F, "x") #fclose F\n' + SCENE, **coarse)
    assert sorted(os.listdir(folder)) == before and not os.path.exists(os.path.dirname(folder) + "/out.txt")
    for tool in ("check", "render", "info"):
        start = time.monotonic()
        result, text = client.call(tool, scene=ENDLESS, seconds=0.5)
        assert time.monotonic() - start < 4 and ("endless-loop" in text or "stopped" in text), (tool, text)
    result, text = client.call("info", scene=LARGE)
    assert result["isError"] and "memory" in text or "stopped" in text, text
    # What was begun and is not wanted any more is ended, and the server answers meanwhile.
    client.send({"id": "slow", "method": "tools/call", "params": {"name": "info", "arguments": {"scene": ENDLESS}}})
    time.sleep(0.3)
    assert client.ask("ping") == {}
    start = time.monotonic()
    client.tell("notifications/cancelled", requestId="slow")
    assert client.ask("tools/list")["tools"] and time.monotonic() - start < 3


WHITTLE = os.path.abspath(sys.argv[1])
with tempfile.TemporaryDirectory() as place:
    inside = place + "/folder"
    os.makedirs(inside)
    server = Client(WHITTLE, "mcp", "--seconds=6", "--memory=300", folder=inside)
    check_protocol(server)
    check_tools(server, inside)
    check_walls(server, inside)
    assert server.close() == 0
print("each tool answers, within its walls")
