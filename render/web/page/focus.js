// The place of the text that is looked at, by an editor's cursor or a click: its pixels lit, its numbers with sliders.
const lit = byId("lit");
const setNumbers = {};  // by file and place

function drawLit() {
  const focus = state.focus, told = focus?.lit;
  lit.hidden = !told || focus.g !== state.generation || !byId("light-up").checked;
  if (lit.hidden) return;
  lit.width = told.w;
  lit.height = told.h;
  lit.style.width = told.w * told.step + "px";
  lit.style.height = told.h * told.step + "px";
  const mask = new Uint8Array(told.w * told.h);
  let at = 0, on = 0;
  for (const run of told.runs) {
    if (on) mask.fill(1, at, at + run);
    at += run;
    on = 1 - on;
  }
  // An edge of light and dark, which is seen on any picture; within, a touch of light.
  const image = new ImageData(told.w, told.h), inside = (x, y) => x >= 0 && y >= 0 && x < told.w && y < told.h && mask[y * told.w + x];
  for (let y = 0; y < told.h; ++y)
    for (let x = 0; x < told.w; ++x) {
      const i = y * told.w + x;
      if (!mask[i]) continue;
      const edge = !inside(x - 1, y) || !inside(x + 1, y) || !inside(x, y - 1) || !inside(x, y + 1);
      image.data.set(edge ? (x + y) % 4 < 2 ? [255, 255, 255, 255] : [0, 0, 0, 255] : [255, 255, 255, 40], 4 * i);
    }
  lit.getContext("2d").putImageData(image, 0, 0);
}

const askNumbers = () => ask({ numbers: Object.values(setNumbers) });
function numberRow(file, number) {
  const key = file + ":" + number.offset;
  if (number.set) setNumbers[key] = { file, offset: number.offset, value: number.value };
  return slider(`${number.line}:${number.column} ${number.word}`, number.value, value => {
    setNumbers[key] = { file, offset: number.offset, value };
    byId("write-numbers").disabled = false;
    askNumbers();
  }, () => {
    delete setNumbers[key];
    askNumbers();
  }, number.written);
}

let shownNumbers = "";
function showNumbers(told) {
  const where = byId("focus-place");
  where.replaceChildren(told.why || (told.line ? placed({ ...told, file: told.path }) : ""));
  const all = JSON.stringify([told.file, told.numbers.map(n => [n.offset, n.written])]);
  if (all !== shownNumbers) {
    shownNumbers = all;
    byId("numbers").replaceChildren(...told.numbers.map(number => numberRow(told.file, number)));
  } else {
    const rows = [...byId("numbers").children];
    told.numbers.forEach((number, i) => {
      if (!rows[i].querySelector("input:focus")) for (const input of rows[i].querySelectorAll("input")) input.value = number.value;
    });
  }
  byId("write-numbers").hidden = !told.numbers.length;
  byId("write-numbers").disabled = !told.numbers.some(n => n.set);
}
on("focus", told => {
  state.focus = told;
  byId("no-focus").hidden = true;
  showNumbers(told);
  drawLit();
});
on("controls", told => {  // what is set still; a value that the slider was moved to meanwhile is told by the next
  if (asked.has(state.next.request) && state.next.request < firstRequest + requests) return;
  for (const key of Object.keys(setNumbers)) delete setNumbers[key];
  for (const number of told.numbers) setNumbers[number.file + ":" + number.offset] = number;
});
on("scene", drawLit);
on("block", drawLitOnce);
let litOf = 0;
function drawLitOnce(block) {
  if (block.g === litOf) return;
  litOf = block.g;
  drawLit();
}
byId("light-up").onchange = drawLit;
byId("write-numbers").onclick = async () => {
  const answer = await post("write", { file: state.focus.file });
  if (!answer.ok) return note(await answer.text());
  const told = await answer.json();
  if (told.written) note("written into the editor's text");
  else copy(told.texts.join(" "));
};

// The statement that a pixel sees: editors show it; where none does, its place is there to copy.
async function showPlace(x, y) {
  const answer = await post("show", { x, y });
  state.shown = answer.ok ? await answer.json() : null;
  if (!answer.ok || !state.shown.place) return;
  const { file, line } = state.shown.place;
  note(`${nameOf(file)}:${line}` + (state.shown.shown ? " is shown in the editor" : ""));
}
