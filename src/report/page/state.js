// What the page shows: every panel draws from this state, and changes it through these functions.
const state = { frame: 0, playing: false, speed: 1, view: [0, frames], label: 0, set: 0, part: -1, zero: 0, marks: [] };

function seek(frame) { state.frame = Math.max(0, Math.min(frame, frames - 1)); show(1); }
// Arrow keys, on every panel that a click moves in time.
function seekByKey(event) {
  const far = event.shiftKey ? fps : 1;
  const act = { ArrowLeft: () => seek(Math.round(state.frame) - far), ArrowRight: () => seek(Math.round(state.frame) + far), Home: () => seek(0), End: () => seek(frames - 1) }[event.key];
  if (act) { event.preventDefault(); act(); }
}
function zoomTo(begin, end) {
  const least = Math.min(frames, Math.max(8, fps * 0.25));
  const length = Math.max(least, Math.min(end - begin, frames));
  const middle = (begin + end) / 2;
  const from = Math.max(0, Math.min(middle - length / 2, frames - length));
  state.view = [from, from + length];
  show(2);
}
function zoomBy(factor, about = state.frame) {
  const [a, b] = state.view, at = about < a || about > b ? (a + b) / 2 : about;
  zoomTo(at - (at - a) * factor, at + (b - at) * factor);
}
function select(label) { if (label >= 0 && label !== state.label) { state.label = label; state.part = -1; state.zero = 0; show(); } }

let before = 0;
function tick(now) {
  if (!state.playing) return;
  const within = document.getElementById("within").checked;
  const [a, b] = within ? [state.view[0], Math.min(state.view[1], frames - 1)] : [0, frames - 1];
  let frame = state.frame + Math.min(now - before, 100) / 1000 * fps * state.speed;
  before = now;
  if (frame >= b || frame < a - 1) frame = a;
  seek(frame);
  requestAnimationFrame(tick);
}
function play(on = !state.playing) {
  state.playing = on;
  document.getElementById("play").textContent = on ? "Pause" : "Play";
  if (on) { before = performance.now(); requestAnimationFrame(tick); }
}
