// Values, camera, cutting plane, comparison: what a page asks for. No request changes a file.
const post = (path, body) => fetch(path, { method: "POST", body: JSON.stringify(body) });

// One request at a time. The last wish of those that came meanwhile follows when a picture of this one is seen, or soon: each request ends
// the picture that is traced, so a slider in motion would show none.
const kSoon = 200;  // milliseconds
let sending = false, wished = null, requests = 0, awaited = null;
const asked = new Set(), firstRequest = Math.floor(performance.timeOrigin) * 1000;  // numbers of no other page
async function ask(change) {
  change.request = firstRequest + ++requests;
  asked.add(change.request);
  if (Object.keys(change).some(what => what !== "clock" && what !== "request")) forgetFrames();
  wished = { ...(wished || {}), ...change };
  if (sending) return;
  sending = true;
  while (wished) {
    const now = wished;
    wished = null;
    const seen = new Promise(done => { awaited = { request: now.request, done }; setTimeout(done, kSoon); });
    try { await post("set", now); } catch { break; }
    await seen;
  }
  sending = false;
}
const seenOf = scene => { if (awaited && scene.request === awaited.request) awaited.done(); };

const declared = {};
function slider(name, value, change, reset, about = value) {  // about: what its reach is chosen by
  const row = document.createElement("div");
  row.className = "value";
  row.dataset.name = name;
  const label = document.createElement("label"), range = document.createElement("input"), number = document.createElement("input");
  label.textContent = label.title = name;
  label.htmlFor = range.id = "value-" + name;
  number.ariaLabel = name + " as a number";
  range.type = "range";
  number.type = "number";
  range.step = number.step = "any";
  const reach = name === "clock" ? [Math.min(0, value), Math.max(1, value)] : about === 0 ? [-1, 1] : [Math.min(0, 2 * about), Math.max(0, 2 * about)];
  [range.min, range.max] = [Math.min(reach[0], value), Math.max(reach[1], value)];
  range.value = number.value = value;
  const set = to => {
    if (!Number.isFinite(to)) return;
    if (to < +range.min) range.min = to;
    if (to > +range.max) range.max = to;
    range.value = number.value = to;
    change(to);
  };
  range.oninput = () => set(+range.value);
  number.onchange = () => set(+number.value);
  const back = document.createElement("button");
  back.className = "sign";
  back.dataset.sign = "×";
  back.title = "as the scene has it";
  back.ariaLabel = name + " as the scene has it";
  back.onclick = reset;
  row.append(label, range, number, back);
  return row;
}

let shownValues = "";
function showControls(told) {
  byId("camera").textContent = told.camera;
  orbit = told.orbit;
  // Rows stay as long as their names do, and a value that is being moved or typed.
  const all = JSON.stringify(told.constants.map(c => c.name));
  if (all !== shownValues) {
    shownValues = all;
    const rows = [slider("clock", told.clock, clock => ask({ clock }), () => ask({ clock: null }))];
    for (const constant of told.constants) {
      if (constant.set) declared[constant.name] = constant.value;
      rows.push(slider(constant.name, constant.value, value => {
        declared[constant.name] = value;
        ask({ declared: { ...declared } });
      }, () => {
        delete declared[constant.name];
        ask({ declared: { ...declared } });
      }));
    }
    byId("values").replaceChildren(...rows);
    return;
  }
  const values = { clock: told.clock };
  for (const constant of told.constants) values[constant.name] = constant.value;
  for (const row of byId("values").children)
    if (!row.querySelector("input:focus")) for (const input of row.querySelectorAll("input")) input.value = values[row.dataset.name];
}

// Camera.
let orbit = { yaw: 0, pitch: 0, dolly: 1, right: 0, up: 0 };
function turnCamera(from, dx, dy) {
  const shown = view.scale * picture.width;
  orbit = { ...from.orbit };
  if (from.shift) {
    orbit.right -= dx / shown;
    orbit.up += dy / (view.scale * picture.height);
  } else {
    orbit.yaw += 180 * dx / shown;
    orbit.pitch = Math.max(-179, Math.min(179, orbit.pitch + 180 * dy / shown));
  }
  ask({ orbit });
}
function dollyCamera(factor) {
  orbit = { ...orbit, dolly: Math.min(1000, Math.max(0.001, orbit.dolly * factor)) };
  ask({ orbit });
}
byId("reset-camera").onclick = () => ask({ orbit: null });
byId("copy-camera").onclick = () => copy(byId("camera").textContent);

async function copy(text) {
  state.copied = text;
  note("copied " + text.split("\n")[0].replace(/\{$/, "").trim());
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = document.createElement("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
}

// Cutting plane.
function askCut() {
  const axis = byId("cut-axis").value;
  ask({ cut: axis ? { normal: axis.split(",").map(Number), offset: +byId("cut-offset").value } : null });
}
byId("cut-axis").onchange = askCut;
byId("cut-slider").oninput = () => { byId("cut-offset").value = byId("cut-slider").value; askCut(); };
byId("cut-offset").onchange = () => { byId("cut-slider").value = byId("cut-offset").value; askCut(); };

// Comparison.
byId("compare").onchange = async () => {
  const kind = byId("compare").value;
  byId("compare-note").textContent = "";
  if (kind === "reference" || kind === "povray") await post("compare", { with: kind });
  drawComparison();
};
byId("compare-how").onchange = byId("wipe").oninput = drawComparison;
