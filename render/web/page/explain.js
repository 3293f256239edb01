// What a pixel is made of.
async function pick(x, y) {
  showPlace(x, y);
  const cross = byId("cross");
  cross.style.display = "block";
  cross.style.left = x + "px";
  cross.style.top = y + "px";
  [byId("pixel-x").value, byId("pixel-y").value] = [x, y];
  byId("pixel").closest("details").open = true;
  byId("pixel").textContent = `${x}, ${y}: asking`;
  const answer = await fetch(`pixel?x=${x}&y=${y}`);
  state.picked = answer.ok ? await answer.json() : null;
  if (!answer.ok) return void (byId("pixel").textContent = await answer.text());
  byId("pixel").replaceChildren(told(state.picked));
  byId("asked-pixel").scrollIntoView({ block: "nearest" });
}
byId("asked-pixel").onsubmit = event => {
  event.preventDefault();
  pick(+byId("pixel-x").value, +byId("pixel-y").value);
};
const element = (tag, text, kind) => {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  if (kind) made.className = kind;
  return made;
};
// Lines that are not broken: they are scrolled, by keys too.
function wide(label, text) {
  const made = element("pre", text, "wide");
  made.tabIndex = 0;
  made.role = "group";
  made.ariaLabel = label;
  return made;
}
function told(pixel) {
  const all = element("div"), swatch = element("span", "", "swatch");
  swatch.style.background = `rgb(${pixel.shown.join(",")})`;
  const head = element("p");
  head.role = "status";
  head.append(swatch, `${pixel.x}, ${pixel.y}: ${pixel.shown.join(" ")} of 255`);
  const text = wide("what it is made of");
  // Places in the text can be clicked on.
  for (const part of pixel.text.split(/(\S+:\d+:\d+)/)) text.append(/^\S+:\d+:\d+$/.test(part) ? placeOf(part, part) : part);
  all.append(head, text);
  return all;
}
// A place that a click copies; files beside the scene or below it are shown without its folder.
function placeOf(text, copied) {
  const folder = byId("folder").textContent;
  const place = element("button", text.startsWith(folder) ? text.slice(folder.length) : text, "place");
  place.type = "button";
  place.title = "copies " + copied;
  place.onclick = () => copy(copied);
  return place;
}
