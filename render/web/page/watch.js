// What the server tells.
const state = { generation: 0, firstAt: 0, doneAt: 0, doneGeneration: 0, text: null, scenes: {}, wrong: false, lost: false, messages: null, copied: "", picked: null };
const source = new EventSource("events");
const on = (name, act) => source.addEventListener(name, event => act(JSON.parse(event.data)));
const words = { reading: "reading", busy: "tracing", done: "done in", wrong: "error", lost: "no answer" };
const now = () => performance.timeOrigin + performance.now();
const nameOf = path => path.split("/").pop();
function lamp(kind) {
  byId("lamp").className = kind;
  byId("word").textContent = words[kind];
  if (kind === "busy" || kind === "done") return;
  byId("pass").textContent = byId("left").textContent = "";
}
source.onerror = () => { state.lost = true; lamp("lost"); mark(); };
source.onopen = () => { state.lost = false; shown.g = 0; mark(); };  // all blocks come again

on("text", told => {
  state.text = told;
  byId("file").textContent = nameOf(told.file);
  byId("folder").textContent = told.file.slice(0, -nameOf(told.file).length);
  byId("file").parentNode.title = told.file;
  document.title = nameOf(told.file) + " - whittle";
  lamp("reading");
  mark();
});
on("scene", told => {
  if (compared.last && compared.last.text !== told.text) compared.before = compared.last;
  state.next = told;
  state.scenes = { [told.g]: told, [state.generation]: state.scenes[state.generation] };
});
on("block", block => {
  if (block.g !== state.generation) {
    const scene = state.scenes[block.g];
    if (scene) setSize(scene.width, scene.height);
    state.generation = block.g;
    state.firstAt = now();
    lamp("busy");
  }
  if (!isOver(state.scenes[block.g])) drawBlock(block);
  state.pass = block.p;
  covered(block);
});
on("progress", told => {
  byId("pass").textContent = told.pass;
  byId("progress").value = told.share;
  byId("left").textContent = told.left < 0 ? "" : told.left < 60 ? `${told.left.toFixed(1)} s left` : `${Math.round(told.left / 60)} min left`;
});
on("done", told => {
  if (told.g !== state.generation) return;  // of a picture before the one whose blocks a page that opens now is told
  state.doneGeneration = told.g;
  state.doneAt = now();
  isShown(told.g);
  if (!state.wrong) lamp("done");
  compared.last = keepPicture();
  compared.last.text = state.scenes[told.g].text;
  byId("pass").textContent = `${told.total.toFixed(told.total < 10 ? 2 : 0)} s`;
  byId("left").textContent = "";
  byId("progress").value = 1;
  byId("times").replaceChildren(...told.times.map(([name, seconds]) => {
    const row = element("tr"), head = element("th", name);
    head.scope = "row";
    row.append(head, element("td", `${(1e3 * seconds).toFixed(1)} ms`));
    return row;
  }));
  drawComparison();
});
on("controls", showControls);
on("compared", told => {
  if (told.why) return void (byId("compare-note").textContent = told.why);
  const made = document.createElement("canvas");
  made.width = told.W;
  made.height = told.H;
  made.getContext("2d").putImageData(pixelsOf(told.d, told.c, told.W, told.H), 0, 0);
  compared[told.with] = made;
  drawComparison();
});

function placed(place) {
  if (!place) return "";
  return placeOf(place.file + (place.line ? `:${place.line}:${place.column}` : ""), place.file + (place.line ? `:${place.line}` : ""));
}
function messageBox(message) {
  const box = element("div", undefined, "message " + message.severity), head = element("div");
  head.append(placed(message.place), " ", element("b", message.severity), ": " + message.text);
  box.append(head);
  if (message.quote !== undefined) box.append(wide("the line", message.quote + "\n" + message.indent + "^"));
  for (const related of message.related) {
    const line = element("div", undefined, "dim");
    line.append(placed(related.place), " " + related.text);
    box.append(line);
  }
  return box;
}
on("messages", told => {
  state.wrong = told.wrong;
  state.messages = told;
  if (told.wrong) lamp("wrong");
  byId("messages").replaceChildren(...told.messages.map(messageBox));
  mark();
});
drawComparison();
