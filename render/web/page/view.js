// The picture: blocks of passes, coarse to fine, drawn over each other; zoom, pan, what it is compared with.
const byId = id => document.getElementById(id);
const picture = byId("picture"), other = byId("other"), sheet = byId("sheet"), stage = byId("stage");
const paper = picture.getContext("2d", { willReadFrequently: true });
const small = document.createElement("canvas");
const view = { scale: 1, wished: 1, x: 0, y: 0, fitted: true, tool: "pan" };  // wished: the scale before it is made whole

function pixelsOf(text, channels, width, height) {
  const bytes = atob(text), image = new ImageData(width, height), to = image.data;
  for (let i = 0, k = 0; k < to.length; i += channels, k += 4) {
    to[k] = bytes.charCodeAt(i);
    to[k + 1] = bytes.charCodeAt(i + 1);
    to[k + 2] = bytes.charCodeAt(i + 2);
    to[k + 3] = channels === 4 ? bytes.charCodeAt(i + 3) : 255;
  }
  return image;
}

function drawBlock(block) {
  const image = pixelsOf(block.d, block.c, block.w, block.h);
  if (block.W === picture.width && block.H === picture.height) return paper.putImageData(image, block.x, block.y);
  small.width = block.w;
  small.height = block.h;
  small.getContext("2d").putImageData(image, 0, 0);
  const sx = picture.width / block.W, sy = picture.height / block.H;
  paper.imageSmoothingEnabled = false;
  paper.clearRect(block.x * sx, block.y * sy, block.w * sx, block.h * sy);
  paper.drawImage(small, block.x * sx, block.y * sy, block.w * sx, block.h * sy);
}

// Whole multiples show each pixel as a square of the screen's. Far in and next to one, that is the scale that is meant.
function snapped(scale, round = Math.round) {
  const device = scale * devicePixelRatio, whole = round(device);
  return whole >= 1 && (device > 4 || Math.abs(device / whole - 1) < 0.02) ? whole / devicePixelRatio : scale;
}
const isWhole = scale => Math.abs(scale * devicePixelRatio - Math.round(scale * devicePixelRatio)) < 1e-6;

function place() {
  if (view.fitted) {
    view.wished = Math.min(stage.clientWidth / picture.width, stage.clientHeight / picture.height) * 0.98;
    view.scale = snapped(view.wished, Math.floor);
    view.x = (stage.clientWidth - picture.width * view.scale) / 2;
    view.y = (stage.clientHeight - picture.height * view.scale) / 2;
  }
  // Between multiples squares would come in two sizes: smooth there.
  const exact = isWhole(view.scale), at = x => exact ? Math.round(x * devicePixelRatio) / devicePixelRatio : x;
  sheet.classList.toggle("exact", exact);
  sheet.style.transform = `translate(${at(view.x)}px, ${at(view.y)}px) scale(${view.scale})`;
  const edge = byId("edge").style;
  [edge.left, edge.top] = [at(view.x) + "px", at(view.y) + "px"];
  [edge.width, edge.height] = [picture.width * view.scale + "px", picture.height * view.scale + "px"];
}
new ResizeObserver(place).observe(stage);

function setSize(width, height) {
  if (picture.width === width && picture.height === height) return;
  for (const canvas of [picture, other]) {
    canvas.width = width;
    canvas.height = height;
  }
  sheet.style.width = width + "px";
  sheet.style.height = height + "px";
  document.body.style.setProperty("--shape", width / height);
  byId("pixel-x").max = width - 1;
  byId("pixel-y").max = height - 1;
  place();
}

function zoom(factor, x, y) {
  view.fitted = false;
  view.wished = Math.min(64, Math.max(0.05, view.wished * factor));
  const scale = snapped(view.wished);
  view.x = x - (x - view.x) * scale / view.scale;
  view.y = y - (y - view.y) * scale / view.scale;
  view.scale = scale;
  place();
}
function nearer(factor, x = stage.clientWidth / 2, y = stage.clientHeight / 2) {
  if (view.tool === "orbit") return dollyCamera(1 / factor);
  zoom(factor, x, y);
}
byId("in").onclick = () => nearer(1.25);
byId("out").onclick = () => nearer(1 / 1.25);
byId("fit").onclick = () => { view.fitted = true; place(); };
byId("one").onclick = () => { view.fitted = false; view.scale = view.wished = 1; view.x = view.y = 8; place(); };
for (const button of document.querySelectorAll("[data-tool]"))
  button.onclick = () => {
    view.tool = button.dataset.tool;
    for (const each of document.querySelectorAll("[data-tool]")) each.setAttribute("aria-pressed", each === button);
  };
document.querySelector("[data-tool=pan]").click();

// A press that does not move is a click on a pixel.
let press = null;
stage.onpointerdown = event => {
  press = { x: event.clientX, y: event.clientY, moved: false, view: { ...view }, orbit: { ...orbit }, shift: event.shiftKey };
  try { stage.setPointerCapture(event.pointerId); } catch { /* a pointer that is gone */ }
};
stage.onpointermove = event => {
  if (!press) return;
  const dx = event.clientX - press.x, dy = event.clientY - press.y;
  if (Math.abs(dx) + Math.abs(dy) > 3) press.moved = true;
  if (!press.moved) return;
  drag(press, dx, dy);
};
function drag(from, dx, dy) {
  if (view.tool === "orbit") return turnCamera(from, dx, dy);
  view.fitted = false;
  view.x = from.view.x + dx;
  view.y = from.view.y + dy;
  place();
}
stage.onpointerup = event => {
  const was = press;
  press = null;
  if (!was || was.moved) return;
  const box = stage.getBoundingClientRect();
  const x = Math.floor((event.clientX - box.left - view.x) / view.scale), y = Math.floor((event.clientY - box.top - view.y) / view.scale);
  if (x >= 0 && y >= 0 && x < picture.width && y < picture.height) pick(x, y);
};
stage.addEventListener("wheel", event => {
  event.preventDefault();
  const box = stage.getBoundingClientRect();
  nearer(Math.exp(-event.deltaY / 400), event.clientX - box.left, event.clientY - box.top);
}, { passive: false });

// What the mouse does, by keys (a pixel has its numbers in the panel).
const kStep = 40;
const arrows = { ArrowLeft: [-kStep, 0], ArrowRight: [kStep, 0], ArrowUp: [0, -kStep], ArrowDown: [0, kStep] };
const keys = { "+": "in", "=": "in", "-": "out", 0: "fit", 1: "one", " ": "play" };
stage.onkeydown = event => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const by = arrows[event.key], button = keys[event.key];
  if (!by && !button) return;
  event.preventDefault();
  if (by) drag({ view: { ...view }, orbit: { ...orbit }, shift: event.shiftKey }, ...by);
  else byId(button).click();
};

// What it is compared with: a canvas above it, cut at the wipe, or the difference of both.
const compared = { before: null, last: null, reference: null, povray: null };
function keepPicture() {
  const copy = document.createElement("canvas");
  copy.width = picture.width;
  copy.height = picture.height;
  copy.getContext("2d").drawImage(picture, 0, 0);
  return copy;
}
function drawComparison() {
  const top = other.getContext("2d"), kind = byId("compare").value, base = compared[kind];
  top.clearRect(0, 0, other.width, other.height);
  byId("compare-how").hidden = !kind;
  byId("wipe").parentNode.hidden = !kind || byId("compare-how").value !== "wipe";
  if (!kind) return void (byId("compare-note").textContent = "");
  if (!base) return void (byId("compare-note").textContent = kind === "before" ? "no earlier save seen" : "waiting");
  if (base.width !== other.width || base.height !== other.height)
    return void (byId("compare-note").textContent = `it has ${base.width}x${base.height} pixels`);
  if (byId("compare-how").value === "wipe") {
    const edge = Math.round(byId("wipe").value * other.width);
    if (edge > 0) top.drawImage(base, 0, 0, edge, other.height, 0, 0, edge, other.height);
    top.fillStyle = "#fff8";
    top.fillRect(edge, 0, 1, other.height);
    return void (byId("compare-note").textContent = `${names[kind]} is on the left`);
  }
  const a = paper.getImageData(0, 0, other.width, other.height);
  const b = base.getContext("2d").getImageData(0, 0, other.width, other.height);
  let beyond = 0, worst = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    let most = 0;
    for (let k = 0; k < 3; ++k) {
      const d = Math.abs(a.data[i + k] - b.data[i + k]);
      most = Math.max(most, d);
      a.data[i + k] = Math.min(255, 8 * d);
    }
    a.data[i + 3] = 255;
    worst = Math.max(worst, most);
    if (most > 3) ++beyond;
  }
  top.putImageData(a, 0, 0);
  byId("compare-note").textContent = `${beyond} pixels differ by more than 3, the worst by ${worst}, of 255`;
}
const names = { before: "the save before", reference: "the reference", povray: "POV-Ray" };
