// The extension for Visual Studio Code without the editor: stand-ins for `vscode` and its language client, the real server.
// usage: node extension.js WHITTLE FOLDER    (FOLDER is empty, and its XDG_RUNTIME_DIR)
"use strict";
const assert = require("assert");
const { spawn } = require("child_process");
const fs = require("fs");
const Module = require("module");
const path = require("path");

const [whittle, folder] = process.argv.slice(2);
const root = path.resolve(__dirname, "../../editors/vscode");
const scene = path.join(folder, "scene.pov");
fs.writeFileSync(scene, "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -3*z look_at 0 }\nshpere { 0, 1 }\n");

/// Frames and answers, no more: what the real client does is not under test.
class LanguageClient {
  constructor(id, name, server, options) {
    Object.assign(this, { server, options, number: 0, waiting: new Map(), bytes: Buffer.alloc(0), told: [] });
  }
  start() {
    this.process = spawn(this.server.command, this.server.args, { stdio: ["pipe", "pipe", "inherit"] });
    this.process.stdout.on("data", data => this.take(data));
    this.ended = new Promise(done => this.process.on("exit", done));
    return this.ask("initialize", { processId: process.pid, rootUri: "file://" + folder, capabilities: { window: { showDocument: { support: true } } } });
  }
  isRunning() { return true; }
  send(message) {
    const body = Buffer.from(JSON.stringify({ jsonrpc: "2.0", ...message }));
    this.process.stdin.write(`Content-Length: ${body.length}\r\n\r\n`);
    this.process.stdin.write(body);
  }
  ask(method, params) {
    this.send({ id: ++this.number, method, params });
    return new Promise(done => this.waiting.set(this.number, done));
  }
  async sendNotification(method, params) { this.send({ method, params }); this.sent = method; }
  async stop() { await this.ask("shutdown"); this.send({ method: "exit" }); assert.strictEqual(await this.ended, 0); }
  take(data) {
    this.bytes = Buffer.concat([this.bytes, data]);
    for (;;) {
      const end = this.bytes.indexOf("\r\n\r\n");
      if (end < 0) return;
      const length = +/content-length: (\d+)/i.exec(this.bytes.slice(0, end))[1];
      if (this.bytes.length < end + 4 + length) return;
      const message = JSON.parse(this.bytes.slice(end + 4, end + 4 + length));
      this.bytes = this.bytes.slice(end + 4 + length);
      if (message.method) this.told.push(message);
      else this.waiting.get(message.id)?.(message.result);
    }
  }
}

const listeners = {}, commands = {}, shown = [], clients = [];
const event = name => act => { listeners[name] = act; return { dispose() {} }; };
const values = { program: whittle, arguments: ["--no=unused-name"], watchArguments: ["+W64", "+H48"] };
const editor = { document: { languageId: "pov", fileName: scene, uri: { toString: () => "file://" + scene } }, selection: { active: { line: 3, character: 2 } } };
const stand = {
  vscode: {
    workspace: { getConfiguration: name => ({ get: key => (assert.strictEqual(name, "whittle"), values[key]) }), onDidChangeConfiguration: event("settings") },
    window: { activeTextEditor: editor, onDidChangeTextEditorSelection: event("selection"), onDidChangeActiveTextEditor: event("editor"),
              showErrorMessage: text => shown.push(text), showInformationMessage: text => shown.push(text) },
    commands: { registerCommand: (name, act) => { commands[name] = act; return { dispose() {} }; }, executeCommand: async (...words) => shown.push(words) },
    env: { uiKind: 1, asExternalUri: async uri => uri }, UIKind: { Desktop: 1, Web: 2 }, ViewColumn: { Beside: -2 }, Uri: { parse: text => text },
  },
  "vscode-languageclient/node": { LanguageClient: class extends LanguageClient { constructor(...all) { super(...all); clients.push(this); } }, TransportKind: { stdio: 0 } },
};
const load = Module._load;
Module._load = (name, ...more) => stand[name] || load(name, ...more);

async function until(what, test) {
  for (let i = 0; i < 400; ++i) {
    if (test()) return;
    await new Promise(done => setTimeout(done, 25));
  }
  throw new Error("not seen: " + what);
}

async function main() {
  const manifest = JSON.parse(fs.readFileSync(path.join(root, "package.json")));
  const extension = require(path.join(root, manifest.main));
  const context = { subscriptions: [] };
  await extension.activate(context);
  const declared = manifest.contributes.commands.map(c => c.command).sort();
  assert.deepStrictEqual(Object.keys(commands).sort(), declared);  // all that it shows, and no other
  for (const key of Object.keys(values)) assert.ok(manifest.contributes.configuration.properties["whittle." + key], key);
  for (const [, file] of JSON.stringify(manifest).matchAll(/"(\.\/[^"]+)"/g)) assert.ok(fs.existsSync(path.join(root, file)), file);

  const text = fs.readFileSync(scene, "utf8"), client = clients[0];
  assert.deepStrictEqual(client.options.documentSelector, [{ language: "pov" }]);
  client.send({ method: "textDocument/didOpen", params: { textDocument: { uri: "file://" + scene, languageId: "pov", version: 1, text } } });
  await until("a diagnostic", () => client.told.some(m => m.method === "textDocument/publishDiagnostics" && m.params.diagnostics.some(d => d.range.start.line === 3)));

  listeners.selection({ textEditor: editor });
  listeners.selection({ textEditor: editor });
  await until("the cursor's notification", () => client.sent === "whittle/cursor");
  listeners.selection({ textEditor: { ...editor, document: { ...editor.document, languageId: "plain" } } });  // no scene: no word of it

  await commands["whittle.watch"]();
  assert.strictEqual(shown[0][0], "simpleBrowser.api.open");
  assert.match(shown[0][1], /^http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\/$/);
  await commands["whittle.watch"]();
  assert.strictEqual(shown[1][1], shown[0][1]);  // one page a scene
  await commands["whittle.restart"]();
  assert.strictEqual(clients.length, 2);
  values.program = path.join(folder, "none");
  editor.document.fileName = "other.pov";
  await commands["whittle.watch"]();
  assert.match(shown[2], /^whittle watch: /);
  await extension.deactivate();
}
main().then(() => process.exit(0), error => { console.error(error); process.exit(1); });
