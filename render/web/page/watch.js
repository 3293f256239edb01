// What the server tells.
const state = { generation: 0, firstAt: 0, doneAt: 0, doneGeneration: 0, wrong: false, copied: "", picked: null };
const source = new EventSource("events");
const on = (name, act) => source.addEventListener(name, event => act(JSON.parse(event.data)));
const lamp = kind => { byId("lamp").className = kind; };
const now = () => performance.timeOrigin + performance.now();
source.onerror = () => lamp("lost");

on("scene", told => {
  byId("file").textContent = told.file;
  document.title = told.file.split("/").pop() + " - whittle";
  if (told.cause === "save" && compared.last && state.doneGeneration) compared.before = compared.last;
  state.next = told;
});
on("block", block => {
  if (block.g !== state.generation) {
    if (state.next) setSize(state.next.width, state.next.height);
    state.generation = block.g;
    state.firstAt = now();
    lamp("busy");
  }
  drawBlock(block);
  state.pass = block.p;
});
on("progress", told => {
  byId("pass").textContent = told.pass;
  byId("progress").value = told.share;
  byId("left").textContent = told.left < 0 ? "" : told.left < 60 ? `${told.left.toFixed(1)} s left` : `${Math.round(told.left / 60)} min left`;
});
on("done", told => {
  state.doneGeneration = told.g;
  state.doneAt = now();
  if (!state.wrong) lamp("done");
  compared.last = keepPicture();
  byId("pass").textContent = `${told.total.toFixed(told.total < 10 ? 2 : 0)} s`;
  byId("left").textContent = "";
  byId("progress").value = 1;
  byId("times").replaceChildren(...told.times.map(([name, seconds]) => {
    const row = element("tr");
    row.append(element("td", name), element("td", `${(1e3 * seconds).toFixed(1)} ms`));
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
  const text = place.file + (place.line ? `:${place.line}:${place.column}` : "");
  const shown = placeOf(text);
  shown.onclick = () => copy(place.file + (place.line ? `:${place.line}` : ""));
  return shown;
}
on("messages", told => {
  state.wrong = told.wrong;
  if (told.wrong) lamp("wrong");
  byId("messages").replaceChildren(...told.messages.map(message => {
    const box = element("div", undefined, "message " + message.severity), head = element("div");
    head.append(placed(message.place), " ", element("b", message.severity), ": " + message.text);
    box.append(head);
    if (message.quote !== undefined) box.append(element("pre", message.quote + "\n" + message.indent + "^"));
    for (const related of message.related) {
      const line = element("div", undefined, "dim");
      line.append(placed(related.place), " " + related.text);
      box.append(line);
    }
    return box;
  }));
});
