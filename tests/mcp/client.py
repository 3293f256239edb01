"""A client of the Model Context Protocol: starts a server, asks, and waits for the answer."""
import json
import subprocess


class Client:
    def __init__(self, *command, folder=None):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=folder)
        self.number = 0
        self.server = self.ask("initialize", {"protocolVersion": "2025-06-18", "capabilities": {},
                                              "clientInfo": {"name": "client.py", "version": "1"}})
        self.tell("notifications/initialized")

    def send(self, message):
        self.process.stdin.write(json.dumps({"jsonrpc": "2.0", **message}).encode() + b"\n")
        self.process.stdin.flush()

    def tell(self, method, **parameters):
        self.send({"method": method, "params": parameters})

    def ask(self, method, parameters=None):
        self.number += 1
        self.send({"id": self.number, "method": method, "params": parameters or {}})
        answer = json.loads(self.process.stdout.readline())
        assert answer["id"] == self.number, answer
        if "error" in answer:
            raise ValueError(answer["error"]["code"], answer["error"]["message"])
        return answer["result"]

    def call(self, tool, **arguments):
        """The result of a tool, and its texts as one."""
        result = self.ask("tools/call", {"name": tool, "arguments": arguments})
        return result, "\n".join(part["text"] for part in result["content"] if part["type"] == "text")

    def close(self):
        self.process.stdin.close()
        self.process.stdout.read()
        return self.process.wait(10)
