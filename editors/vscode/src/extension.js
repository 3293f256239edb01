// Starts `whittle lsp` for scenes; all else is the language client's.
const vscode = require("vscode");
const { LanguageClient, TransportKind } = require("vscode-languageclient/node");

let client;

function start() {
  const settings = vscode.workspace.getConfiguration("whittle");
  const server = { command: settings.get("program"), args: ["lsp", ...settings.get("arguments")], transport: TransportKind.stdio };
  const options = { documentSelector: [{ language: "pov" }] };
  client = new LanguageClient("whittle", "Whittle", server, options);
  return client.start();
}

async function restart() {
  if (client) await client.stop();
  await start();
}

exports.activate = async (context) => {
  context.subscriptions.push(vscode.commands.registerCommand("whittle.restart", restart));
  context.subscriptions.push(
    vscode.workspace.onDidChangeConfiguration((event) => event.affectsConfiguration("whittle") && restart()));
  await start();
};

exports.deactivate = () => client && client.stop();
