// The loop, the overlaid cycles, and postures side by side.
const motionShown = () => motions[state.label];
const hereInMotion = () => { const s = found.segments[containing(found.segments, state.frame)]; return Boolean(motionShown() && s && s.label === letters(motionShown().label)); };
const looped = () => found.segments.filter(s => s.kind === "cyclic" && hasCurve(s));
// A smooth line through points [x, y, ...]: cubic (Catmull and Rom), for drawing only.
function smooth(points, parts) {
  if (parts < 2 || points.length < 8) return points;
  const result = [], last = points.length / 2 - 1, at = (i, a) => points[2 * Math.max(0, Math.min(i, last)) + a];
  for (let i = 0; i < last; ++i)
    for (let k = 0; k < parts; ++k)
      for (const a of [0, 1]) {
        const t = k / parts, [p, q, r, s] = [i - 1, i, i + 1, i + 2].map(j => at(j, a));
        result.push(q + 0.5 * t * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * (q - r) + s - p))));
      }
  result.push(at(last, 0), at(last, 1));
  return result;
}

// The segment whose loop is shown: the one at the cursor, or else the longest of the selected motion.
function loopSegment() {
  const cyclic = looped();
  const here = cyclic.find(s => state.frame >= s.begin && state.frame < s.end);
  if (here) return here;
  const own = cyclic.filter(s => motionShown() && s.label === letters(motionShown().label));
  return (own.length ? own : cyclic).sort((a, b) => b.end - b.begin - a.end + a.begin)[0];
}
// An arrowhead as in the library's figures.
function drawArrow(pen, at, towards) {
  const angle = Math.atan2(towards[1] - at[1], towards[0] - at[0]), cos = Math.cos(angle), sin = Math.sin(angle);
  pen.line([[6, 0], [-5, 5], [-2.5, 0], [-5, -5], [6, 0]].flatMap(([x, y]) => [at[0] + x * cos - y * sin, at[1] + x * sin + y * cos]), { fill: colors.ink });
}
function makeLoop() {
  const series = data.curve.values, step = data.curve.step, from = data.curve.first;
  const row = frame => (frame - from) / step;
  // The cycle that shows the direction: the representative one, or else the first.
  const shownTurn = s => [found.representative_cycle, ...found.cycles].find(cycle => cycle && cycle.begin >= s.begin && cycle.end <= s.end && !Number.isNaN(series.between(row((cycle.begin + cycle.end) / 2), 1)));
  // At most so many turns are drawn, evenly spaced, because all would be a solid ring. An empty list means all.
  const most = 40;
  const turnsDrawn = s => {
    if (s.count <= most) return [];
    const all = found.cycles.filter(cycle => cycle.begin >= s.begin && cycle.end <= s.end);
    return all.length <= most ? [] : Array.from({ length: most }, (_, i) => all[Math.floor(i * all.length / most)]);
  };
  let drawn = null, project = null;
  if (!looped().length) { document.querySelector(".view .two").style.gridTemplateColumns = "minmax(0, 1fr)"; byId("loop").remove(); return; }
  const panel = new Panel("loop", {
    title: "Loop", more: found.cycles.length > 1 ? "a turn is a cycle; its width includes drift" : "", height: w => printing ? 315 : Math.min(470, innerWidth < 760 ? w * 0.7 : Math.max(w, byId("viewer").firstChild.clientHeight - 37)), label: "The motion as a loop: each turn is one cycle. Click it to go to that time.",
    base(pen, w, h) {
      const s = loopSegment();
      drawn = s;
      const rows = [];
      let low = [Infinity, Infinity], high = [-Infinity, -Infinity], starts = Infinity;
      for (let r = Math.max(0, Math.ceil((s.begin - from) / step)); r < series.rows && from + r * step < s.end; ++r) {
        if (!Number.isNaN(series.at(r, 1))) starts = Math.min(starts, r);
        rows.push(r);
        for (const c of [0, 1]) { const v = series.at(r, 1 + c); if (v < low[c]) low[c] = v; if (v > high[c]) high[c] = v; }
      }
      const pad = 28, scale = [0, 1].map(c => ([w, h - 24][c] - 2 * pad) / (high[c] - low[c] || 1));
      project = r => [w / 2 + (series.between(r, 1) - (low[0] + high[0]) / 2) * scale[0], (h - 24) / 2 - (series.between(r, 2) - (low[1] + high[1]) / 2) * scale[1]];
      const cycles = turnsDrawn(s), turns = cycles.length || Math.max(1, s.count), look = { stroke: hueOf(s), width: 1.6, alpha: Math.max(0.12, Math.min(0.75, 4 / turns)) };
      const drawRows = (begin, end, parts) => { const points = []; for (let r = begin; r <= end; ++r) points.push(...project(r)); pen.line(smooth(points, parts), look); };
      for (const cycle of cycles) drawRows(Math.max(rows[0], Math.floor(row(first(cycle)))), Math.min(rows[rows.length - 1], Math.ceil(row(last(cycle)))), 3);
      if (!cycles.length) drawRows(rows[0], rows[rows.length - 1], rows.length < 4000 ? 5 : 1);
      // Start and direction.
      if (rows.length > 4) {
        const a = project(starts), turn = shownTurn(s), from = turn ? row(first(turn)) : rows[0], to = turn ? row(last(turn)) : rows[rows.length - 1];
        for (const share of [1 / 6, 3 / 6, 5 / 6]) drawArrow(pen, project(from + share * (to - from)), project(Math.min(from + share * (to - from) + 0.6, series.rows - 1)));
        pen.rect(a[0] - 4, a[1] - 4, 8, 8, { fill: colors.ink, stroke: colors.paper, width: 1 });
      }
      if (w > 300) {
        pen.rect(14, h - 18, 8, 8, { fill: colors.ink });
        pen.text(27, h - 14, "start", { color: colors.soft });
        drawArrow(pen, [72, h - 14], [73, h - 14]);
        pen.text(82, h - 14, "direction", { color: colors.soft });
      }
      pen.text(w - 14, h - 14, `${s.label} from ${time(s.begin)} · ${cycles.length ? `${cycles.length} of ` : ""}${plural(s.count, "turn")}`, { color: colors.soft, align: "right" });
    },
    over(pen, w, h) {
      const s = loopSegment();
      if (s !== drawn) { panel.stale = 3; setTimeout(() => panel.draw(3)); return; }
      if (!project || state.frame < s.begin || state.frame >= s.end) return;
      const cycle = found.cycles[containing(found.cycles, state.frame)];
      if (cycle) { const points = []; for (let r = Math.max(0, Math.ceil(row(first(cycle)))); r <= Math.min(series.rows - 1, row(last(cycle))); ++r) points.push(...project(r)); pen.line(smooth(points, 5), { stroke: colors.ink, width: 2.4 }); }
      const p = project(Math.max(0, Math.min(series.rows - 1, row(state.frame))));
      pen.circle(p[0], p[1], 6.5, { fill: colors.cursor, stroke: colors.paper, width: 2 });
    },
  });
  panel.canvas.onkeydown = seekByKey;
  panel.canvas.onclick = event => {
    const box = panel.canvas.getBoundingClientRect(), s = drawn;
    let best = NaN, least = 40;
    for (let r = Math.max(0, Math.ceil((s.begin - from) / step)); r < series.rows && from + r * step < s.end; ++r) { const p = project(r), d = Math.hypot(p[0] - event.clientX + box.left, p[1] - event.clientY + box.top) + Math.abs(from + r * step - state.frame) / frames; if (d < least) { least = d; best = from + r * step; } }
    if (!Number.isNaN(best)) seek(best);
  };
}

const setShown = () => { const motion = motionShown(); return motion && motion.sets[Math.min(state.set, motion.sets.length - 1)]; };
const columnsOf = (set, part) => set.columns.map((column, index) => ({ ...column, index })).filter(column => column.part === part);
// The part whose curves are shown: the selected one if it has any, or else the one that moves most.
function partShown() {
  const set = setShown();
  if (!set) return -1;
  if (state.part >= 0 && columnsOf(set, state.part).length) return state.part;
  const segment = found.segments.filter(s => s.label === letters(motionShown().label)).sort((a, b) => b.end - b.begin - a.end + a.begin)[0];
  const names = segment ? segment.carried_by : [];
  const parts = names.map(name => body.parts.findIndex(part => part.name === name)).filter(part => part >= 0 && columnsOf(set, part).length);
  const paired = parts.find(part => body.parts[part].partner >= 0);
  if (paired !== undefined) return paired;
  return parts.length ? parts[0] : set.columns.length ? set.columns[0].part : -1;
}
// What is shown together: a row for each coordinate, with the left and the right part beside each other.
function plotsShown() {
  const set = setShown(), part = partShown();
  if (!set || part < 0) return [];
  const own = columnsOf(set, part), partner = body.parts[part] ? body.parts[part].partner : -1;
  if (own.length === 1 && !own[0].axis && partner < 0) { // a matrix: this column and others
    return [part, ...chosenColumns(6)].filter((p, i, all) => all.indexOf(p) === i).slice(0, 6).map(p => columnsOf(set, p)).filter(c => c.length).map(c => [c[0]]);
  }
  const left = partner >= 0 && body.parts[part].side === 1 ? partner : part, right = left === part ? partner : part;
  return columnsOf(set, left).map(column => [column, partner >= 0 ? columnsOf(set, right).find(other => other.axis === column.axis) : undefined].filter(Boolean));
}
const shift = () => state.zero > 0 && state.marks[state.zero - 1] ? state.marks[state.zero - 1].phase : 0;

function sidesCurves(column) {
  const sides = motionShown().sides;
  if (!sides || !sides.pairs.length || setShown().name === "angle") return null;
  const index = sides.pairs.findIndex(pair => pair.left === column.name && pair.axis === column.axis);
  return index < 0 ? null : { index, pair: sides.pairs[index], left: sides.left_curves, right: sides.right_curves };
}

// The curve from another phase on; what came before that phase follows at the end.
function rotated(values, phase) {
  if (!phase) return values;
  const n = values.length - 1, result = [];
  for (let i = 0; i <= n; ++i) {
    const at = (i / n + phase) % 1 * n, k = Math.floor(at), t = at - k;
    result.push(values[k] + t * (values[Math.min(k + 1, n)] - values[k]));
  }
  return result;
}
function cyclesRange(set, columns) {
  let low = Infinity, high = -Infinity;
  for (const { index } of columns) {
    for (let r = 0; r < set.mean.rows; ++r) { const m = set.mean.at(r, index), s = set.sd.at(r, index) || 0; if (m - s < low) low = m - s; if (m + s > high) high = m + s; }
    for (let r = 0; r < set.each.rows; ++r) { const v = set.each.at(r, index); if (v < low) low = v; if (v > high) high = v; }
  }
  if (!(low < high)) return Number.isFinite(low) ? [low - 1, low + 1] : [0, 1];
  const pad = (high - low) * 0.06;
  return [low - pad, high + pad];
}

let plotBoxes = [];
function layOut(w) {
  const rows = plotsShown(), columns = Math.max(1, ...rows.map(row => row.length)), together = rows.some(row => row.length === 2 && sidesCurves(row[0]));
  const shown = columns + (together ? 1 : 0), narrow = w < 600 && shown > 2;
  const across = narrow ? 2 : Math.max(shown, rows.length > 1 && shown === 1 && w > 600 ? Math.min(3, rows.length) : 1);
  const left = 58, gap = shown === 1 || together && !narrow ? 64 : 22, width = (w - left - 16 - gap * (across - 1)) / across, height = printing ? 76 : Math.max(86, Math.min(160, width * 0.52));
  return { rows, columns, together, shown, across, left, gap, width, height, space: printing ? 38 : 46, lines: shown === 1 ? Math.ceil(rows.length / across) : rows.length * (narrow ? 2 : 1), narrow };
}
function makeCycles() {
  if (!motions.some(motion => motion.sets.length)) { byId("s-cycles").hidden = true; return; }
  const panel = new Panel("cycles", {
    title: "Cycles", height: w => { const l = layOut(w); return 36 + l.lines * (l.height + l.space); }, label: "Curves of all cycles on 0 to 100 percent, with mean and standard deviation. Click to go to that phase.",
    base(pen, w, h) {
      const set = setShown(), l = layOut(w);
      plotBoxes = [];
      if (!set) return pen.text(16, 24, motionShown() ? motionShown().reason : "", { color: colors.soft });
      const n = set.shown.length, kept = n ? set.each.rows / n : 0, phase = shift();
      const look = column => ({ mean: rotated(set.mean.column(column.index), phase), sd: rotated(set.sd.column(column.index), phase), each: set.shown.map((_, k) => rotated(Array.from({ length: kept }, (_, i) => set.each.at(k * kept + i, column.index)), phase)) });
      l.rows.forEach((row, r) => {
        const range = cyclesRange(set, row);
        row.forEach((column, c) => {
          const line = l.shown === 1 ? Math.floor(r / l.across) : r * (l.narrow ? 2 : 1), at = l.shown === 1 ? r % l.across : c;
          const box = { x: l.left + at * (l.width + l.gap), y: 34 + line * (l.height + l.space), w: l.width, h: l.height, column };
          const side = body.parts[column.part] ? body.parts[column.part].side : -1, color = side === 0 ? colors.left : side === 1 ? colors.right : colors.accent;
          drawPlot(pen, box, [{ ...look(column), color }], range, { title: column.name, suffix: (column.axis ? " · " + axisText(column.axis, body.up) : "") + (set.unit ? " [" + set.unit + "]" : ""), color, axis: at === 0 || l.shown === 1, bottom: true });
          plotBoxes.push(box);
        });
        const both = l.together && row.length === 2 ? sidesCurves(row[0]) : null;
        if (both) {
          const box = { x: l.left + (l.narrow ? 0 : 2 * (l.width + l.gap)), y: 34 + (l.narrow ? r * 2 + 1 : r) * (l.height + l.space), w: l.narrow ? 2 * l.width + l.gap : l.width, h: l.height };
          const curves = [both.left, both.right].map(of => rotated(of.column(both.index), phase)), values = curves.flat().filter(v => !Number.isNaN(v));
          const low = Math.min(...values), high = Math.max(...values), pad = (high - low) * 0.06 || 1, span = range[1] - range[0], centre = (low + high) / 2;
          const own = high - low + 2 * pad > span ? [low - pad, high + pad] : [centre - span / 2, centre + span / 2];
          drawPlot(pen, box, [{ mean: curves[0], color: colors.left }, { mean: curves[1], color: colors.right, dash: [7, 4] }], own, { title: "left and right, mirrored", axis: true, bottom: true });
          plotBoxes.push(box);
        }
      });
    },
    over(pen) {
      if (!hereInMotion()) return;
      const phase = (phaseAt(state.frame) - shift() + 1) % 1;
      if (!Number.isNaN(phase)) for (const box of plotBoxes) pen.line([box.x + phase * box.w, box.y, box.x + phase * box.w, box.y + box.h], { stroke: colors.cursor, width: 1.6 });
    },
  });
  panel.canvas.onkeydown = seekByKey;
  panel.canvas.onclick = event => {
    const frame = canvasBox(panel.canvas, event), box = plotBoxes.find(b => frame[0] >= b.x && frame[0] <= b.x + b.w && frame[1] >= b.y && frame[1] <= b.y + b.h);
    if (box) goToPhase(((frame[0] - box.x) / box.w + shift()) % 1);
  };
  listeners.push(level => {
    if (level < 3) return;
    const set = setShown(), motion = motionShown(), count = motion ? partsOf(motion).length : 0, word = motion && motion.cyclic ? "cycle" : "repetition";
    panel.title(`${plural(count, word)} of ${motion ? letters(motion.label) : ""}`, set ? "0 to 100 % of a " + word : "");
    byId("cycles-hint").textContent = !set ? "" : (count === 1 ? `The only ${word}. ` : `Thick: mean of ${plural(count, word)}; shaded: one standard deviation; thin: ${set.shown.length < count ? set.shown.length + " of them" : "each"}. `) +
      (set.name === "position" ? "Positions are relative to the body, without its heading, in the unit of the file. " : set.name === "angle" ? "Joint angles as in the file, in degrees. " : "") +
      (motion.sides && motion.sides.pairs.length && set.name !== "angle" ? "Where both sides are drawn together, the right one is mirrored and shifted by half a cycle, so the curves of a symmetric motion coincide. " : "") + (moves ? "Click a curve to see the posture at that phase." : "Click a curve to go to that phase.");
  });
}
const canvasBox = (canvas, event) => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
// Goes to this phase of the cycle at the cursor, or else of the first one that has it.
function goToPhase(phase) {
  const motion = motionShown(), parts = partsOf(motion), at = Math.max(0, containing(parts, state.frame));
  for (const index of [at, ...parts.keys()]) { const frame = frameAt(motion, index, phase); if (!Number.isNaN(frame)) return seek(frame); }
}

let groupBoxes = [];
function makeGroup() {
  if (!moves || !motions.some(motion => motion.sets.length && partsOf(motion).length > 1)) { byId("s-group").hidden = true; return; }
  byId("group-hint").textContent = "Postures of several cycles or repetitions at the same phase. Play the motion, or move in time, to see them move together; click one to go there.";
  const chosen = () => { const parts = motionShown() ? partsOf(motionShown()) : [], most = Math.min(parts.length, 6); return Array.from({ length: most }, (_, i) => Math.floor(i * parts.length / most)); };
  let phase = 0;
  const panel = new Panel("group", {
    title: "Side by side", height: w => { const across = w < 600 ? 3 : 6, n = chosen().length; return Math.ceil(n / across) * Math.min(220, w / across * 1.15) + 10; }, label: "Postures of several cycles at the same phase. Click one to go there.",
    over(pen, w, h) {
      const motion = motionShown(), list = chosen(), across = Math.min(w < 600 ? 3 : 6, Math.max(1, list.length)), cell = Math.min(w / across, 230), high = (h - 10) / Math.ceil(list.length / across || 1);
      const here = hereInMotion() ? phaseAt(state.frame) : NaN;
      if (!Number.isNaN(here)) phase = here;
      groupBoxes = [];
      list.forEach((index, i) => {
        const part = partsOf(motion)[index], frame = frameAt(motion, index, phase), x = i % across * cell, y = Math.floor(i / across) * high;
        groupBoxes.push({ x, y, w: cell, h: high, frame });
        const on = state.frame >= first(part) && state.frame < last(part);
        if (on) pen.rect(x + 4, y + 4, cell - 8, high - 8, { fill: colors.cursor, alpha: 0.09, radius: 8 });
        pen.text(x + cell / 2, y + high - 16, `${part.index + 1}${part.likeness === null || part.likeness === undefined ? "" : ` · likeness ${percent(part.likeness, 0)}`}`, { color: colors.soft, align: "center", size: 11.5 });
        if (Number.isNaN(frame)) return;
        const points = posture(frame), middle = middleOf(points), scale = Math.min(0.40 * (high - 34), 0.46 * cell) / body.size;
        const project = projection([middle[0], body.space === 2 ? middle[1] : body.height, middle[2]], cell, high - 26, scale, body.size, body.space === 2);
        drawBody(pen, points, p => { const q = project(p); return [q[0] + x, q[1] + y + 2, q[2]]; }, 2.2, -1);
      });
    },
  });
  listeners.push(level => { if (level > 2) panel.title("Side by side", motionShown() ? `${plural(chosen().length, motionShown().cyclic ? "cycle" : "repetition")} of ${letters(motionShown().label)}` : ""); });
  panel.canvas.onkeydown = seekByKey;
  panel.canvas.onclick = event => { const [x, y] = canvasBox(panel.canvas, event), box = groupBoxes.find(b => x >= b.x && x < b.x + b.w && y >= b.y && y < b.y + b.h); if (box && !Number.isNaN(box.frame)) seek(box.frame); };
}
