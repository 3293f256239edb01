// The clock as a film: frames are traced as they are first wanted, and kept while nothing but the clock changes.
const kMostKept = 5e8;  // bytes
const film = { count: 24, first: 0, last: 1, kept: new Map(), at: 0, playing: false, valid: 0, over: 0, quiet: new Set(), waiting: null, told: "" };
const clockOf = i => film.first + (film.count > 1 ? (film.last - film.first) * i / (film.count - 1) : 0);

function forgetFrames() {
  film.valid = firstRequest + requests;
  film.over = 0;
  film.quiet.clear();
  film.kept.clear();
  tellFilm();
}
// A kept frame was drawn over what was asked for before it, and what is asked for its sake has its pixels.
const isOver = scene => asked.has(scene?.request) && (scene.request <= film.over || film.quiet.has(scene.request));
// What a pixel is asked about is the frame that is seen.
function askForKept() {
  if (!film.kept.has(film.at)) return;  // it is asked for already
  ask({ clock: clockOf(film.at) });
  film.quiet.add(firstRequest + requests);
}
function tellFilm() {
  const frame = byId("frame");
  frame.max = film.count;
  frame.value = film.at + 1;
  byId("film-note").textContent = `frame ${film.at + 1} of ${film.count}, clock ${+clockOf(film.at).toFixed(4)}; ${film.kept.size} kept`;
  byId("play").textContent = film.playing ? "pause" : "play";
  byId("play").setAttribute("aria-pressed", film.playing);
}

on("controls", told => {
  const frames = told.frames || { count: 24, first: 0, last: 1 }, all = JSON.stringify(frames);
  if (all === film.told) return;
  film.told = all;
  Object.assign(film, frames);
  byId("frame-count").value = film.count;
  forgetFrames();
});
on("text", forgetFrames);
on("done", told => {
  const scene = state.scenes[told.g];
  if (!scene || told.g !== state.generation) return;
  if (scene.request && !asked.has(scene.request)) return forgetFrames();  // another page changed something
  if (scene.request && scene.request < film.valid || isOver(scene)) return;  // of what was before
  for (let i = 0; i < film.count; ++i) {
    if (Math.abs(clockOf(i) - scene.clock) > 1e-6 * Math.max(1, Math.abs(scene.clock))) continue;  // single precision there
    if ((film.kept.size + 1) * 4 * scene.width * scene.height <= kMostKept) film.kept.set(i, keepPicture());
    if (film.waiting?.frame === i) film.waiting.done(true);
    else if (!film.waiting && !film.playing) film.at = i;  // the clock was set elsewhere
  }
  tellFilm();
});
on("messages", told => { if (told.wrong) stopFilm(); });

function stopFilm() {
  if (film.playing) askForKept();
  film.playing = false;
  film.waiting?.done(false);
  tellFilm();
}
/// True: the frame is seen.
function showFrame(i) {
  film.waiting?.done(false);
  film.at = i;
  const kept = film.kept.get(i);
  if (kept && kept.width === picture.width && kept.height === picture.height) {
    paper.drawImage(kept, 0, 0);
    film.over = firstRequest + requests;
    tellFilm();
    return Promise.resolve(true);
  }
  film.kept.delete(i);
  tellFilm();
  return new Promise(done => {
    film.waiting = { frame: i, done: seen => { film.waiting = null; done(seen); } };
    ask({ clock: clockOf(i) });
  });
}
async function play() {
  film.playing = true;
  while (film.playing) {
    const due = now() + 1e3 / Math.max(1, Math.min(120, +byId("frame-rate").value || 24));
    if (!await showFrame(film.at) && film.playing) return stopFilm();
    await new Promise(done => setTimeout(done, Math.max(0, due - now())));
    if (film.playing && film.at + 1 === film.count && !byId("loop").checked) return stopFilm();
    if (film.playing) film.at = (film.at + 1) % film.count;
  }
}
byId("play").onclick = () => {
  if (film.playing) return stopFilm();
  if (film.at + 1 >= film.count) film.at = 0;
  play();
};
byId("frame").oninput = () => {
  if (film.playing) stopFilm();
  showFrame(+byId("frame").value - 1);
};
byId("frame").onchange = askForKept;
byId("frame-count").onchange = () => {
  const count = Math.round(+byId("frame-count").value);
  if (!(count >= 2 && count <= 10000)) return void (byId("frame-count").value = film.count);
  film.count = count;
  film.at = Math.min(film.at, count - 1);
  forgetFrames();
};
