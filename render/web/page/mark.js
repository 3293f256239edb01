// Whether the picture is of the text as it stands: if not, its edge and its age say so; if there is none, the field does.
const shown = { scene: null, g: 0, areas: [] };  // the scene that all pixels are of; the generation that comes, its pixels by pass
const kPatience = 250;                          // milliseconds that a picture may be older without a word
const clock = at => new Date(at).toTimeString().slice(0, 8);

// A block that came. A picture is of its scene when a pass of it has come whole: until then pixels of the one before are left.
function covered(block) {
  if (block.g !== shown.g) [shown.g, shown.areas] = [block.g, []];
  shown.areas[block.p] = (shown.areas[block.p] || 0) + block.w * block.h;
  if (shown.areas[block.p] === block.W * block.H) isShown(block.g);
}
function isShown(g) {
  if (!state.scenes[g] || shown.scene?.g === g) return;
  shown.scene = state.scenes[g];
  seenOf(shown.scene);
  mark();
}

function standing() {
  const text = state.text || { g: 0 }, wrong = state.wrong && state.messages.g >= text.g;
  if (state.lost) return ["wrong", "whittle watch does not answer"];
  if (wrong) return ["wrong", "the text has an error"];
  if (!shown.scene || shown.scene.g < text.g) return ["busy", "the new text is under way"];
  return ["", ""];
}

let patience = 0;
function mark() {
  clearTimeout(patience);
  patience = 0;
  const [kind] = standing();
  if (kind === "busy" && byId("edge").hidden) patience = setTimeout(showMark, kPatience);
  else showMark();
}
function showMark() {
  const [kind, why] = standing();
  byId("edge").hidden = !kind || !shown.scene;
  byId("edge").className = kind;
  const age = byId("edge").hidden ? "" : `of ${clock(shown.scene.text)}: ${why}`;
  if (byId("age").textContent !== age) byId("age").textContent = age;
  if (shown.scene && state.text) picture.ariaLabel = "picture of " + nameOf(state.text.file);
  byId("empty").replaceChildren(...(shown.scene ? [] : nothing(kind, why)));
  document.body.classList.toggle("bare", !shown.scene && kind === "wrong");
}

// What stands in the field before the first picture. With an error it is all that there is: the panel would be empty.
function nothing(kind, why) {
  if (kind !== "wrong" || state.lost) return [element("h2", state.lost ? why : state.text ? `Reading ${nameOf(state.text.file)}` : "Waiting")];
  return [element("h2", "No picture yet: " + why), ...state.messages.messages.map(messageBox)];
}

let noted = 0;
function note(text) {
  clearTimeout(noted);
  byId("note").textContent = text;
  noted = setTimeout(() => { byId("note").textContent = ""; }, 2500);
}
