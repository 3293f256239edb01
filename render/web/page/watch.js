// What the server tells.
const state = { generation: 0, firstAt: 0, doneAt: 0, donePass: -1, wrong: false };
const source = new EventSource("events");
const on = (name, act) => source.addEventListener(name, event => act(JSON.parse(event.data)));

on("scene", told => {
  document.getElementById("file").textContent = told.file;
  if (picture.width !== told.width || picture.height !== told.height) {
    picture.width = told.width;
    picture.height = told.height;
  }
});
on("block", block => {
  drawBlock(block);
  if (block.g !== state.generation) {
    state.generation = block.g;
    state.firstAt = performance.timeOrigin + performance.now();
  }
});
on("done", told => {
  state.doneGeneration = told.g;
  state.doneAt = performance.timeOrigin + performance.now();
  document.getElementById("times").textContent = told.times.map(([n, s]) => `${n} ${(1e3 * s).toFixed(1)} ms`).join(", ");
});
on("messages", told => {
  state.wrong = told.wrong;
  document.getElementById("messages").textContent = told.messages.map(m => m.text).join("\n");
});
