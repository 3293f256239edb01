// Starts `whittle lsp` for scenes, tells it where the cursor is (for `whittle watch`), opens a scene's page; all else is the language client's.
const { spawn } = require("child_process");
const vscode = require("vscode");
const { LanguageClient, TransportKind } = require("vscode-languageclient/node");

const kCursorPause = 40; // milliseconds between two places of a cursor that moves
let client;
const watched = new Map(); // by scene: its page's process and address

const settings = () => vscode.workspace.getConfiguration("whittle");

function start() {
  const server = { command: settings().get("program"), args: ["lsp", ...settings().get("arguments")], transport: TransportKind.stdio };
  const options = { documentSelector: [{ language: "pov" }] };
  client = new LanguageClient("whittle", "Whittle", server, options);
  return client.start();
}

async function restart() {
  if (client) await client.stop();
  await start();
}

// The last place of those that come while one waits.
let waiting = null;
function tellCursor(editor) {
  if (!editor || editor.document.languageId !== "pov" || !client || !client.isRunning()) return;
  const first = !waiting;
  waiting = { textDocument: { uri: editor.document.uri.toString() }, position: { line: editor.selection.active.line, character: editor.selection.active.character } };
  if (!first) return;
  setTimeout(() => {
    const place = waiting;
    waiting = null;
    client.sendNotification("whittle/cursor", place).catch(() => {}); // a server that is being restarted
  }, kCursorPause);
}

// The page of a scene, beside its text: one process a scene, which ends with the window.
function pageOf(scene) {
  const known = watched.get(scene);
  if (known) return known.address;
  const process = spawn(settings().get("program"), ["watch", scene, ...settings().get("watchArguments")], { stdio: ["ignore", "pipe", "pipe"] });
  const address = new Promise((found, failed) => {
    let said = "", complaint = "";
    process.stdout.on("data", (data) => {
      said += data;
      if (said.includes("\n")) found(said.split("\n")[0]);
    });
    process.stderr.on("data", (data) => { complaint += data; });
    process.on("error", failed);
    process.on("exit", () => {
      watched.delete(scene);
      failed(new Error(complaint.trim() || "whittle watch has ended"));
    });
  });
  watched.set(scene, { process, address });
  return address;
}

async function showPicture() {
  const editor = vscode.window.activeTextEditor;
  if (!editor || editor.document.languageId !== "pov") return vscode.window.showInformationMessage("Open a scene first.");
  try {
    // From a desktop to another machine by its tunnel. In a browser (code-server) as it is, for a browser on that machine: the page's server lets
    // no request in that came to another name, so none through a proxy.
    const told = vscode.Uri.parse(await pageOf(editor.document.fileName));
    const address = vscode.env.uiKind === vscode.UIKind.Desktop ? await vscode.env.asExternalUri(told) : told;
    await vscode.commands.executeCommand("simpleBrowser.api.open", address, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true });
  } catch (error) {
    vscode.window.showErrorMessage(`whittle watch: ${error.message}`);
  }
}

exports.activate = async (context) => {
  context.subscriptions.push(
    vscode.commands.registerCommand("whittle.restart", restart),
    vscode.commands.registerCommand("whittle.watch", showPicture),
    vscode.workspace.onDidChangeConfiguration((event) => event.affectsConfiguration("whittle") && restart()),
    vscode.window.onDidChangeTextEditorSelection((event) => tellCursor(event.textEditor)),
    vscode.window.onDidChangeActiveTextEditor(tellCursor),
  );
  await start();
  tellCursor(vscode.window.activeTextEditor);
};

exports.deactivate = () => {
  for (const { process } of watched.values()) process.kill();
  return client && client.stop();
};
