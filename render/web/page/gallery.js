// The scenes of the folder, small. They are traced one after the other, while the gallery is open.
const gallery = byId("gallery");
let looking = 0;
async function lookAtFolder() {
  const mine = ++looking;
  const answer = await fetch("gallery");
  if (!answer.ok || mine !== looking) return;
  const told = await answer.json();
  state.gallery = {};
  const cards = told.scenes.map(name => {
    const card = element("button", undefined, "card"), small = document.createElement("canvas");
    card.type = "button";
    card.dataset.name = name;
    card.setAttribute("aria-current", name === told.shown);
    small.width = told.width;
    small.height = told.height;
    small.setAttribute("aria-hidden", "true");
    card.append(small, element("span", name));
    card.onclick = async () => {
      const opened = await post("open", { name });
      if (!opened.ok) return note(await opened.text());
      for (const each of gallery.children) each.setAttribute("aria-current", each === card);
    };
    return card;
  });
  gallery.replaceChildren(...cards);
  for (const card of cards) {
    const seen = await fetch("thumbnail?name=" + encodeURIComponent(card.dataset.name));
    if (mine !== looking || !byId("folder-scenes").open) return;
    const one = await seen.json();
    state.gallery[card.dataset.name] = one.why || "seen";
    if (one.why) {
      card.append(element("span", one.why, "dim"));
      continue;
    }
    const canvas = card.querySelector("canvas");
    canvas.getContext("2d").putImageData(pixelsOf(one.d, one.c, one.W, one.H), 0, 0);
  }
}
byId("folder-scenes").ontoggle = () => { if (byId("folder-scenes").open) lookAtFolder(); };
