// The recording over time: behaviors, units, cycles and repetitions, the curve, the distance from the mean cycle.
const bandLeft = w => w < 600 ? 12 : 96, bandRight = 14;
const rowsOf = () => {
  const rows = [{ name: "Behavior", y: 26, h: 34 }, { name: "Units", y: 64, h: 20 }];
  let y = 88;
  if (found.cycles.length || found.repetitions.length) { rows.push({ name: found.cycles.length ? found.repetitions.length ? "Cycles, reps" : "Cycles" : "Repetitions", y, h: 20 }); y += 26; }
  if (motions.length) { rows.push({ name: "Events", y, h: 16 }); y += 22; } // else no posture can be marked
  if (curved.length) { rows.push({ name: "Curve", y, h: 74 }); y += 80; }
  if (found.cycles.length) { rows.push({ name: "Distance", y, h: 38 }); y += 44; }
  rows.push({ name: "", y: y + 4, h: 26 });
  return rows;
};
let curved = [], bandHeight = 0, bandRows = [];
const bandX = (frame, w) => bandLeft(w) + (frame - state.view[0]) / (state.view[1] - state.view[0]) * (w - bandLeft(w) - bandRight);
const bandFrame = (x, w) => state.view[0] + (x - bandLeft(w)) / (w - bandLeft(w) - bandRight) * (state.view[1] - state.view[0]);
const wholeX = (frame, w) => bandLeft(w) + frame / frames * (w - bandLeft(w) - bandRight);

function tip(text, x, y) {
  const box = byId("tip");
  box.hidden = !text;
  if (!text) return;
  box.textContent = text;
  box.style.left = Math.max(6, Math.min(x + 14, innerWidth - box.offsetWidth - 8)) + "px";
  box.style.top = (y + 18 + box.offsetHeight > innerHeight ? y - box.offsetHeight - 10 : y + 18) + "px";
}
const numberOf = text => [...text].reduce((n, letter) => n * 26 + letter.charCodeAt(0) - 64, 0) - 1;
const hueOf = segment => labelHue(segment.label ? numberOf(segment.label) : -1);
function segmentText(s) {
  if (s.kind === "rest") return s.reason || "rest"; // "nothing recorded"
  if (s.kind === "action") return s.label + " · once";
  return s.label + " · " + plural(s.count, s.kind === "cyclic" ? "cycle" : "repetition");
}
function unitText(u) {
  const s = found.segments[u.segment];
  return s.kind === "rest" && s.reason ? s.reason : u.kind;
}

// The smallest and largest value of each pixel, so that nothing is lost in a long recording.
function drawSeries(pen, series, column, scale, begin, end, x, y, look) {
  const a = Math.max(0, Math.floor((begin - scale.first) / scale.step)), b = Math.min(series.rows - 1, Math.ceil((end - scale.first) / scale.step));
  const per = Math.max(1, Math.floor((b - a) / 1400)), points = [];
  for (let r = a; r <= b; r += per) {
    let low = Infinity, high = -Infinity, missing = false;
    for (let k = r; k < Math.min(r + per, b + 1); ++k) { const value = series.at(k, column); if (Number.isNaN(value)) missing = true; else { low = Math.min(low, value); high = Math.max(high, value); } }
    const at = x(scale.first + r * scale.step);
    if (low > high || missing && per === 1) points.push(NaN, NaN);
    else if (per === 1) points.push(at, y(low));
    else points.push(at, y(low), at, y(high));
  }
  pen.line(points, per > 4 ? { ...look, alpha: 0.5 } : look); // where periods are narrower than pixels
}
function rangeOf(series, column) {
  let low = Infinity, high = -Infinity;
  for (let r = 0; r < series.rows; ++r) { const v = series.at(r, column); if (v < low) low = v; if (v > high) high = v; }
  return low < high ? [low, high] : [low - 1 || -1, low + 1 || 1];
}

function makeBand() {
  const curve = data.curve.values;
  const moving = found.segments.filter(s => s.kind !== "rest");
  curved = moving.filter(s => s.kind === "cyclic" && hasCurve(s));
  if (moving.length === 1 && hasCurve({ begin: 0, end: frames })) curved = [{ begin: 0, end: frames }];
  bandRows = rowsOf();
  byId("band-hint").textContent = "Drag or click to move in time. Double-click a bar to zoom to it. To zoom, pinch or press + and −; drag the strip at the bottom to move the time range." +
    (curved.length ? " Curve: the motion in one number" + (found.cycles.length ? ", from which units and cycles were cut." : ".") : "") + (found.cycles.length ? " Distance: how far each frame is from the mean cycle." : "");
  const lastRow = bandRows[bandRows.length - 1];
  bandHeight = lastRow.y + lastRow.h + 10;
  const curveRange = curved.length ? rangeOf(curve, 0) : null;
  const residualTop = found.cycles.length ? Math.max(0.2, Math.min(rangeOf(data.phase.values, 1)[1], 1.5)) : 1;
  const row = name => bandRows.find(r => r.name === name);
  const panel = new Panel("band", {
    title: "The recording", zooms: true, height: () => bandHeight, label: "The recording over time",
    base(pen, w) {
      const [a, b] = state.view, x = frame => bandX(frame, w), left = bandLeft(w), right = w - bandRight;
      const axis = timeTicks(a / fps, b / fps, (right - left) / 90);
      for (const s of axis.list) { pen.line([x(s * fps), 22, x(s * fps), lastRow.y - 6], { stroke: colors.grid }); pen.text(x(s * fps), 11, axis.text(s), { color: colors.soft, align: "center", size: 11 }); }
      if (left > 40) for (const r of bandRows) pen.text(left - 10, r.y + r.h / 2, r.name, { color: colors.soft, align: "right" });
      const boxes = (list, y, h, look) => pen.clip(left, y - 2, right - left, h + 4, () => {
        let merged = -1;
        list.forEach((item, i) => {
          const from = x(first(item)), to = x(last(item));
          if (to < left || from > right) return;
          if (to - from < 1 && Math.floor(from) === merged) return; // narrower than a pixel
          merged = Math.floor(from);
          const { hue, text, strong, faint } = look(item, i), inside = Math.max(1, to - from - 1.5);
          pen.rect(from + 0.5, y, inside, h, { fill: hue, alpha: faint ? colors.alpha * 0.55 : +colors.alpha, radius: 4 });
          if (strong) pen.rect(from + 0.5, y, inside, 4, { fill: hue, radius: 2 });
          const shown = fitted(pen, text, Math.min(to, right) - Math.max(from, left) - 10);
          if (shown) pen.text(Math.max(from, left) + 6, y + h / 2 + (strong ? 2 : 0), shown);
        });
      });
      boxes(found.segments, 26, 34, s => ({ hue: hueOf(s), text: segmentText(s), strong: true }));
      boxes(found.units, 64, 20, u => ({ hue: hueOfUnit(u.kind), text: unitText(u) }));
      const cycles = bandRows[2];
      if (found.cycles.length) boxes(found.cycles, cycles.y, cycles.h, (c, i) => ({ hue: hueOf(found.segments[c.segment]), text: String(i + 1), faint: i % 2 }));
      if (found.repetitions.length) boxes(found.repetitions, cycles.y, cycles.h, (r, i) => ({ hue: hueOf(found.segments[r.segment]), text: String(i + 1), faint: i % 2 }));
      if (curved.length) {
        const r = row("Curve"), y = v => r.y + r.h - 4 - (v - curveRange[0]) / (curveRange[1] - curveRange[0]) * (r.h - 8);
        pen.line([left, r.y + r.h, right, r.y + r.h], { stroke: colors.line });
        pen.clip(left, r.y, right - left, r.h, () => { for (const s of curved) drawSeries(pen, curve, 0, data.curve, Math.max(a, s.begin), Math.min(b, s.end - data.curve.step), x, y, { stroke: colors.accent, width: 1.6 }); });
      }
      if (found.cycles.length) {
        const r = row("Distance"), y = v => r.y + r.h - Math.min(1, v / residualTop) * (r.h - 4);
        pen.line([left, r.y + r.h, right, r.y + r.h], { stroke: colors.line });
        pen.clip(left, r.y, right - left, r.h, () => drawSeries(pen, data.phase.values, 1, { first: 0, step: data.phase.step }, a, b, x, y, { stroke: colors.soft, width: 1.2 }));
      }
      if (left <= 40) for (const r of bandRows.slice(2)) if (r.name) { // no room beside them
        pen.rect(left, r.y, pen.measure(r.name, 11) + 6, 15, { fill: colors.paper, alpha: 0.8, radius: 3 });
        pen.text(left + 3, r.y + 8, r.name, { color: colors.soft, size: 11 });
      }
      for (const s of found.segments) pen.rect(wholeX(first(s), w), lastRow.y, Math.max(0.7, wholeX(last(s), w) - wholeX(first(s), w) - 0.6), lastRow.h, { fill: hueOf(s), alpha: s.kind === "rest" ? 0.2 : 0.5, radius: 3 });
      pen.rect(wholeX(a, w), lastRow.y - 2, Math.max(6, wholeX(b, w) - wholeX(a, w)), lastRow.h + 4, { stroke: colors.ink, width: 1.8, radius: 5 });
    },
    over(pen, w) {
      const left = bandLeft(w), right = w - bandRight, events = row("Events");
      const at = bandX(state.frame, w);
      pen.clip(left - 6, 0, right - left + 12, bandHeight, () => {
        for (const mark of state.marks) for (const event of mark.found) {
          const x = bandX(event.frame, w), y = events.y + 8;
          pen.line([x - 5, y, x, y - 6, x + 5, y, x, y + 6, x - 5, y], event.marked ? { fill: colors.cursor, stroke: colors.cursor, width: 1.5 } : { stroke: colors.cursor, width: 1.5, fill: colors.paper });
        }
        if (at >= left - 1 && at <= right + 1) { pen.line([at, 20, at, lastRow.y - 6], { stroke: colors.cursor, width: 1.6 }); pen.circle(at, 20, 4, { fill: colors.cursor }); }
      });
      const whole = wholeX(state.frame, w);
      pen.line([whole, lastRow.y - 3, whole, lastRow.y + lastRow.h + 3], { stroke: colors.cursor, width: 1.6 });
    },
  });
  controlBand(panel, lastRow);
}

function bandText(x, y, w) {
  const frame = bandFrame(x, w), at = list => list[containing(list, frame)];
  const span = part => `${time(first(part))} to ${time(last(part))}, ${number((part.end_s - part.begin_s), 3)} s`;
  const sure = part => part.confidence === null || part.confidence === undefined ? "" : `\nconfidence ${percent(part.confidence, 0)}`;
  if (y >= 26 && y < 62) { const s = at(found.segments); return s && `${segmentText(s)}\n${span(s)}${sure(s)}${s.period_s ? `\ncycle time ${number(s.period_s)} s` : ""}${s.reason && s.kind !== "rest" ? "\n" + s.reason : ""}${s.carried_by.length ? "\nmoves: " + s.carried_by.slice(0, 5).join(", ") : ""}`; }
  if (y >= 64 && y < 86) { const u = at(found.units); return u && `${unitText(u)}\n${span(u)}`; }
  const parts = bandRows[2];
  if (y >= parts.y && y < parts.y + parts.h && parts.name !== "Events") {
    const c = containing(found.cycles, frame), r = containing(found.repetitions, frame), part = c >= 0 ? found.cycles[c] : found.repetitions[r];
    return part && `${cycleText(frame)}\n${span(part)}${part.likeness === null ? "" : `\nlikeness ${percent(part.likeness, 0)}`}${sure(part)}${part.travel ? `\nspeed ${number(part.travel.speed)}, path ${number(part.travel.path_length)}` : ""}`;
  }
  return "";
}

function controlBand(panel, lastRow) {
  const canvas = panel.canvas, pointers = new Map();
  let mode = "", grab = 0;
  canvas.setAttribute("role", "slider");
  canvas.setAttribute("aria-valuemin", "0");
  canvas.setAttribute("aria-valuemax", String(frames - 1));
  listeners.push(() => { canvas.setAttribute("aria-valuenow", String(Math.round(state.frame))); canvas.setAttribute("aria-valuetext", time(state.frame)); });
  canvas.style.touchAction = "pan-y";
  canvas.style.cursor = "crosshair";
  const at = event => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top, box.width]; };
  const whole = (x, w) => (x - bandLeft(w)) / (w - bandLeft(w) - bandRight) * frames;
  canvas.onpointerdown = event => {
    const [x, y, w] = at(event);
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, x);
    tip("");
    if (y > lastRow.y - 4) { mode = "window"; const frame = whole(x, w), [a, b] = state.view; grab = frame >= a && frame <= b ? frame - a : (b - a) / 2; zoomTo(frame - grab, frame - grab + b - a); }
    else { mode = "seek"; seek(bandFrame(x, w)); const s = found.segments[containing(found.segments, state.frame)]; if (s && s.label) { const index = motions.findIndex(m => letters(m.label) === s.label); if (index >= 0) select(index); } }
  };
  canvas.onpointermove = event => {
    const [x, y, w] = at(event);
    if (!pointers.has(event.pointerId)) return tip(bandText(x, y, w), event.clientX, event.clientY);
    if (pointers.size === 2) {
      const [[, other]] = [...pointers].filter(([id]) => id !== event.pointerId), was = Math.abs(pointers.get(event.pointerId) - other), is = Math.abs(x - other);
      if (is > 8) zoomBy(was / is, bandFrame((x + other) / 2, w));
    } else if (mode === "seek") seek(bandFrame(x, w));
    else { const [a, b] = state.view, frame = whole(x, w); zoomTo(frame - grab, frame - grab + b - a); }
    pointers.set(event.pointerId, x);
  };
  canvas.onpointerup = canvas.onpointercancel = event => { pointers.delete(event.pointerId); };
  canvas.onpointerleave = () => tip("");
  canvas.ondblclick = event => {
    const [x, y, w] = at(event), frame = bandFrame(x, w);
    const list = y < 62 ? found.segments : y < 86 ? found.units : containing(found.cycles, frame) >= 0 ? found.cycles : containing(found.repetitions, frame) >= 0 ? found.repetitions : found.segments;
    const item = list[containing(list, frame)];
    if (item) zoomTo(first(item), last(item));
  };
  canvas.addEventListener("wheel", event => {
    if (!event.ctrlKey && Math.abs(event.deltaX) <= Math.abs(event.deltaY)) return;
    event.preventDefault();
    const [x, , w] = at(event), [a, b] = state.view;
    if (event.ctrlKey) zoomBy(Math.exp(event.deltaY / 200), bandFrame(x, w)); else zoomTo(a + event.deltaX / w * (b - a), b + event.deltaX / w * (b - a));
  }, { passive: false });
  canvas.onkeydown = event => {
    seekByKey(event);
    const act = { "+": () => zoomBy(0.5), "=": () => zoomBy(0.5), "-": () => zoomBy(2), "0": () => zoomTo(0, frames) }[event.key];
    if (act) { event.preventDefault(); act(); }
  };
}
