// The comparison of two motions: the library computed its numbers, which are only drawn here.
const data = JSON.parse(byId("data").textContent);
let found = null; // stltsa-comparison/1
const state = { phase: 0, playing: false, speed: 1, part: 0, apart: false };
const sided = () => found.kind === "left_right";
const which = ["first", "second"];
const lastNames = (path, count) => (path || "clip from memory").split("/").slice(-count).join("/");
// With the folder if both files have the same name.
const fileName = path => lastNames(path, !sided() && found.first.path !== found.second.path && lastNames(found.first.path, 1) === lastNames(found.second.path, 1) ? 2 : 1);
const stem = () => fileStem(found.first.path, "motion") + (sided() ? "-sides" : "-" + fileStem(found.second.path, "motion"));
const shortNames = () => sided() ? ["left", "right, mirrored"] : which.map(w => `${w}: ${fileName(found[w].path)}`);
const colorOf = w => w === 0 ? colors.left : colors.right;
const partName = part => part.first === part.second ? part.first : `${part.first} – ${part.second}`;
const partMoves = part => part.differences.amplitude.first > 0 || part.differences.amplitude.second > 0;
const isKnown = value => value !== null && value !== undefined;
// A value and its interval, as text.
const between = (low, high, text) => isKnown(low) && isKnown(high) ? `${text(low)} to ${text(high)}` : "–";
const share = value => signed(percent(value));
const star = estimate => estimate.significant ? " *" : "";

// Whether the end of a joint is at the joint itself.
const isOwnEnd = end => end.first.endsWith(" end") && found.parts.some(part => part.first + " end" === end.first && part.differences.rms_difference === end.differences.rms_difference && part.differences.amplitude.first === end.differences.amplitude.first);
// Parts that move, those with the largest differences first.
let order = [];
function sortParts() {
  order = found.parts.map((part, index) => index).filter(index => partMoves(found.parts[index]) && !isOwnEnd(found.parts[index]));
  order.sort((a, b) => (found.parts[b].differences.rms_difference || 0) - (found.parts[a].differences.rms_difference || 0) || a - b);
  if (!order.length) order = found.parts.map((part, index) => index);
  state.part = order[0];
}

function leadText() {
  const { first, second, cycle_time_s: time } = found;
  if (sided()) return `The right side, mirrored and half a cycle later, on the left side of ${plural(first.cycles, "cycle")} of ${first.label}: a symmetric motion would give one curve.`;
  const longer = time.difference > 0 ? "longer" : "shorter", size = `${number(Math.abs(time.difference))} s (${percent(Math.abs(time.difference) / time.first, 0)})`;
  const sure = !isKnown(time.low) ? "; too few cycles to say how certain that is" : time.significant ? `, 95 % interval ${between(time.low, time.high, value => signed(number(value)))} s` : ", which may be chance";
  const compared = number(time.first) === number(time.second) ? "as long as one of the first" : `${size} ${longer} than one of the first${sure}`;
  return `${plural(first.cycles, "cycle")} of ${first.label} in ${fileName(first.path)} and ${second.cycles} of ${second.label} in ${fileName(second.path)}. A cycle of the second takes ${number(time.second)} s, ${compared}.`;
}
function makeHead() {
  const title = sided() ? `${fileName(found.first.path)}: left and right` : `${fileName(found.first.path)} and ${fileName(found.second.path)}`;
  byId("title").textContent = title;
  document.title = title + " – comparison";
  byId("lead").textContent = leadText();
  byId("facts").textContent = !found.judged ? "With one cycle on a side, no difference can be called significant." : `${found.significant} of ${found.judged} differences in timing and amplitude are significant; about ${number(found.expected_by_chance, 2)} would be so by chance alone.`;
}

// Where a curve is at a phase in [0, 1).
function valueAt(values, phase) {
  const at = phase * (values.length - 1), i = Math.floor(at), a = values[i];
  const b = values[Math.min(i + 1, values.length - 1)];
  return a === null || b === null ? NaN : a + (at - i) * (b - a);
}
const axes = { 0: [[1, 1], [0, 1], [2, -1]], 2: [[0, 1], [2, 1], [1, -1]] }[data.up] || [[0, 1], [1, 1], [2, 1]];
const posture = (w, phase) => found.parts.map(part => axes.map(([axis, sign]) => sign * valueAt(part.channels[axis][which[w]].mean, phase)));
const body = { size: 1, low: 0, height: 0 };
// Its size, the ground, and the direction in which most of it moves, for the first view.
function lookAtBodies() {
  const points = [], sway = [0, 0, 0];
  for (let k = 0; k < 20; ++k)
    for (const w of [0, 1]) {
      const here = posture(w, k / 20), half = posture(w, (k / 20 + 0.5) % 1);
      points.push(...here);
      here.forEach((p, i) => { const x = p[0] - half[i][0], z = p[2] - half[i][2]; sway[0] += x * x; sway[1] += x * z; sway[2] += z * z; });
    }
  const lows = points.map(p => p[1]);
  const widths = Array.from({ length: 20 }, (_, k) => posture(0, k / 20)).map(list => Math.max(...[0, 2].map(a => Math.max(...list.map(p => p[a])) - Math.min(...list.map(p => p[a])))));
  state.phase = widths.indexOf(Math.max(...widths)) / 20; // of the widest posture
  body.low = Math.min(...lows);
  body.height = (body.low + Math.max(...lows)) / 2;
  body.size = Math.max(...points.map(p => Math.hypot(p[0], p[1] - body.height, p[2]))) || 1;
  camera.yaw = Math.atan2(2 * sway[1], sway[0] - sway[2]) / 2 + 0.35;
  camera.pitch = 0.12;
}
let shownFlat = [];
function makeViewer() {
  if (!data.parents) {
    byId("viewer").remove();
    byId("panels").style.gridTemplateColumns = "minmax(0, 1fr)";
    return;
  }
  lookAtBodies();
  const apart = element("button", { type: "button", "aria-pressed": "false", onclick: () => { state.apart = !state.apart; apart.setAttribute("aria-pressed", String(state.apart)); show(1); } }, "Apart");
  const panel = new Panel("viewer", {
    title: "Mean cycles", tools: [apart, ...viewTools()], height: w => printing ? 300 : Math.min(470, w * (w < 500 ? 0.9 : 0.8)),
    label: "The mean postures of both motions at one phase, the second one dashed. Drag them or press the arrow keys to turn them; click a joint to see its curves.",
    over(pen, w, h) {
      const scale = 0.43 * Math.min(h, state.apart ? w : 1.4 * w) / body.size * camera.zoom, target = [0, body.height, 0], width = Math.max(2, Math.min(4.5, h / 105 * camera.zoom));
      shownFlat = [];
      pen.clip(0, 0, w, h, () => {
        for (const second of [0, 1]) {
          const moved = state.apart ? (second ? 0.25 : -0.25) * w : 0, plain = projection(target, w, h - 20, scale, body.size);
          const project = p => { const q = plain(p); return [q[0] + moved, q[1], q[2]]; };
          if (!second || state.apart) drawGrid(pen, project, target, body.size, body.low);
          drawBody(pen, second, project, width);
        }
      });
      drawKey(pen, w, h);
      pen.text(14, 12, partName(found.parts[state.part]), { color: colors.cursor, bold: true });
    },
  });
  orbit(panel.canvas, false, (x, y) => {
    let best = -1, least = 22;
    for (const [index, p] of shownFlat) { const d = Math.hypot(p[0] - x, p[1] - y); if (d < least) { least = d; best = index; } }
    if (best >= 0) choose(best);
  });
}
// Bones of a skeleton; joints without an ancestor among the parts hang on the root, which is the origin.
function drawBody(pen, w, project, width) {
  const flat = posture(w, state.phase).map(p => Number.isNaN(p[0] + p[1] + p[2]) ? null : project(p)), origin = project([0, 0, 0]);
  const look = { stroke: colorOf(w), width, dash: w ? [1.6 * width, 1.5 * width] : [] };
  flat.forEach((p, i) => {
    if (!p) return;
    shownFlat.push([i, p]);
    const parent = data.parents[i] >= 0 ? flat[data.parents[i]] : data.skeleton ? origin : null;
    if (parent) pen.line([parent[0], parent[1], p[0], p[1]], look);
    if (!data.skeleton) pen.circle(p[0], p[1], width * 1.1, { fill: w ? colors.sheet : colorOf(w), stroke: colorOf(w), width: 1.5 });
    if (i === state.part) pen.circle(p[0], p[1], width * 2 + 2, { stroke: colors.cursor, width: 2 });
  });
  // The head: a disk from its joint to the end of its bone.
  const head = data.skeleton ? found.parts.findIndex(part => /head/i.test(part.first)) : -1, end = head < 0 ? -1 : data.parents.indexOf(head);
  if (end < 0 || !flat[head] || !flat[end]) return;
  const [a, b] = [flat[head], flat[end]];
  pen.circle((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, Math.max(2 * width, Math.hypot(a[0] - b[0], a[1] - b[1]) / 2), { fill: w ? colors.sheet : colorOf(w), stroke: colorOf(w), width: 2 });
}
function drawKey(pen, width, h) {
  let x = 14;
  shortNames().forEach((name, w) => {
    const text = fitted(pen, name, width / 2 - 46);
    pen.line([x, h - 14, x + 22, h - 14], { stroke: colorOf(w), width: 3, dash: w ? [6, 5] : [] });
    pen.text(x + 29, h - 14, text, { color: colors.soft });
    x += 29 + pen.measure(text, 12) + 20;
  });
}

// The differences of each part with their intervals.
const measures = [
  { title: "later in the cycle, %", short: "later, %", unknown: "not alike", of: part => part.differences.lag, value: e => e.difference, low: e => e.low, high: e => e.high },
  { title: "amplitude, %", short: "amplitude, %", unknown: "–", of: part => ({ ...part.differences.amplitude_ratio, significant: part.differences.amplitude.significant }), value: e => minusOne(e.value), low: e => minusOne(e.low), high: e => minusOne(e.high) }];
const minusOne = ratio => isKnown(ratio) ? ratio - 1 : null;
// Wide enough for all values and most intervals; longer ones end at the border.
function reachOf(measure, rows) {
  const all = rows.map(row => measure.of(found.parts[row])), values = all.map(measure.value).filter(isKnown).map(Math.abs);
  const ends = all.flatMap(e => [measure.low(e), measure.high(e)]).filter(isKnown).map(Math.abs).sort((a, b) => a - b);
  return 1.15 * Math.max(0.005, ...values, ends.length ? ends[Math.floor(0.8 * (ends.length - 1))] : 0);
}
// Ticks of which at least one is on each side of zero.
function symmetricTicks(reach, count) {
  const list = ticks(-reach, reach, count), power = 10 ** Math.floor(Math.log10(reach));
  if (list.length > 2) return list;
  const most = [5, 2, 1].map(k => k * power).find(size => size <= reach);
  return [-most, 0, most];
}
function makeIntervals() {
  const most = 16, top = 34, space = () => printing ? 15 : 23;
  const rowsShown = () => order.slice(0, most).concat(order.indexOf(state.part) >= most ? [state.part] : []);
  const panel = new Panel("intervals", {
    title: "Largest differences", height: () => top + rowsShown().length * space() + 32,
    label: "Timing and amplitude of the second motion against the first, with 95 percent intervals, for the parts with the largest differences. Click a row to see its curves.",
    base(pen, w, h) {
      const rows = rowsShown(), label = Math.min(240, 0.37 * w), gap = 36, width = (w - label - 22 - gap) / 2;
      rows.forEach((row, r) => {
        const y = top + (r + 0.5) * space();
        if (row === state.part) pen.rect(4, y - space() / 2, w - 8, space(), { fill: colors.cursor, alpha: 0.1, radius: 6 });
        pen.text(14, y, fitted(pen, partName(found.parts[row]), label - 18), { size: 12, bold: row === state.part });
      });
      measures.forEach((measure, m) => {
        const x = label + m * (width + gap), reach = reachOf(measure, rows), px = v => x + (v / reach + 1) / 2 * width;
        pen.text(x + width / 2, 16, width < 140 ? measure.short : measure.title, { color: colors.soft, align: "center" });
        for (const border of [x, x + width]) pen.line([border, top, border, h - 30], { stroke: colors.grid });
        for (const t of symmetricTicks(reach, Math.max(2, Math.min(6, Math.floor(width / 44))))) { pen.line([px(t), top, px(t), h - 30], { stroke: t ? colors.grid : colors.soft }); pen.text(px(t), h - 17, signed(number(100 * t)), { size: 11, color: colors.soft, align: "center" }); }
        rows.forEach((row, r) => { if (!isKnown(measure.value(measure.of(found.parts[row])))) pen.text(x + width / 2 + 6, top + (r + 0.5) * space(), measure.unknown, { size: 11, color: colors.soft }); });
        pen.clip(x, 0, width, h, () => rows.forEach((row, r) => {
          const of = measure.of(found.parts[row]), y = top + (r + 0.5) * space(), value = measure.value(of);
          if (!isKnown(value)) return;
          if (isKnown(measure.low(of))) pen.line([px(Math.max(-2 * reach, measure.low(of))), y, px(Math.min(2 * reach, measure.high(of))), y], { stroke: colors.accent, width: 2 });
          pen.circle(px(value), y, 4.5, { fill: of.significant ? colors.accent : colors.sheet, stroke: colors.accent, width: 2 });
        }));
      });
    },
  });
  panel.canvas.onclick = event => { const row = Math.floor((event.clientY - panel.canvas.getBoundingClientRect().top - top) / space()); if (row >= 0 && row < rowsShown().length) choose(rowsShown()[row]); };
  panel.canvas.onkeydown = event => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    choose(order[Math.max(0, Math.min(order.length - 1, order.indexOf(state.part) + step))]);
  };
  panel.title("Largest differences", found.judged ? "filled: significant; lines: 95 %" : "");
}

let boxes = [];
const withNaN = values => values.map(value => value === null ? NaN : value);
function rangeOf(lines, zero) {
  let low = zero ? 0 : Infinity, high = zero ? 0 : -Infinity;
  for (const line of lines) line.mean.forEach((m, i) => { const s = line.sd[i] || 0; if (m - s < low) low = m - s; if (m + s > high) high = m + s; });
  if (!(low < high)) return Number.isFinite(low) ? [low - 1, low + 1] : [0, 1];
  return [low - 0.06 * (high - low), high + 0.06 * (high - low)];
}
function makeCurves() {
  const shape = w => {
    const count = found.parts[state.part].channels.length, across = Math.min(count, w < 600 ? 1 : 3), gap = 58;
    return { count, across, gap, width: (w - 58 - 16 - gap * (across - 1)) / across, high: printing ? 84 : 150, low: printing ? 52 : 84 };
  };
  const panel = new Panel("curves", {
    title: "Curves", height: w => { const s = shape(w); return 44 + Math.ceil(s.count / s.across) * (s.high + s.low + 84); },
    label: "Mean cycles of both motions with their standard deviations, and below, the difference with its 95 percent interval. Click to move to this phase.",
    base(pen, w, h) {
      const part = found.parts[state.part], s = shape(w);
      boxes = [];
      part.channels.forEach((channel, c) => {
        const x = 58 + c % s.across * (s.width + s.gap), y = 34 + Math.floor(c / s.across) * (s.high + s.low + 84);
        const lines = which.map((name, i) => ({ mean: withNaN(channel[name].mean), sd: withNaN(channel[name].sd), color: colorOf(i), dash: i ? [7, 4] : [] }));
        const difference = [{ mean: withNaN(channel.difference.mean), sd: withNaN(channel.difference.margin), color: colors.accent }];
        const above = { x, y, w: s.width, h: s.high }, below = { x, y: y + s.high + 32, w: s.width, h: s.low };
        drawPlot(pen, above, lines, rangeOf(lines), { title: channel.axis ? axisText(channel.axis, data.up) : partName(part), axis: true, bottom: false });
        const range = rangeOf(difference, true), zero = below.y + below.h * (range[1] / (range[1] - range[0]));
        drawPlot(pen, below, difference, range, { title: sided() ? "right minus left" : "second minus first", color: colors.soft, axis: true, bottom: true });
        pen.line([below.x, zero, below.x + below.w, zero], { stroke: colors.soft, width: 1.2 });
        boxes.push(above, below);
      });
      drawKey(pen, w, h);
    },
    over(pen) { for (const box of boxes) pen.line([box.x + state.phase * box.w, box.y, box.x + state.phase * box.w, box.y + box.h], { stroke: colors.cursor, width: 1.6 }); },
  });
  panel.canvas.onclick = event => {
    const place = panel.canvas.getBoundingClientRect(), x = event.clientX - place.left, y = event.clientY - place.top;
    const box = boxes.find(b => x >= b.x && x <= b.x + b.w && y >= b.y && y <= b.y + b.h);
    if (box) seek((x - box.x) / box.w);
  };
  listeners.push(level => { if (level > 2) panel.title(partName(found.parts[state.part]), "0 to 100 % of the cycle"); });
  const unit = { positions: "Positions are relative to the body, in the unit of the file, with the heading removed. ", points: "Positions are relative to the body, in the unit of the file. ", euler: "Angles in radians. " }[found.features] || "";
  const spreads = found.parts.some(part => part.channels.some(channel => withNaN(channel.difference.margin).some(value => !Number.isNaN(value))));
  byId("curves-hint").textContent = `${spreads ? "Thick: mean cycles; shaded: one standard deviation. Below: the difference, with its 95 % interval at each single phase: of 100 phases without a difference, five lie outside it by chance." : "Thick: mean cycles; shaded: one standard deviation, if there is more than one cycle. Below: the difference; its interval is unknown, because a motion has only one cycle."} ${unit}${data.parents ? "Click a curve to see its posture." : "Click a curve to go to this phase."}`;
}

function makeNumbers() {
  const { first, second, cycle_time_s: time } = found;
  const rows = sided() ? [["Cycles compared", String(first.cycles)], ["Cycles a minute", number(first.cycles_per_min)], ["Cycle time, s", withSd(time.first, time.first_sd)]]
    : [["Cycles compared", String(first.cycles), String(second.cycles), ""], ["Cycles a minute", number(first.cycles_per_min), number(second.cycles_per_min), signed(number(second.cycles_per_min - first.cycles_per_min))],
      ["Cycle time, s", withSd(time.first, time.first_sd), withSd(time.second, time.second_sd), `${signed(number(time.difference))}${star(time)}`], ...(isKnown(time.low) ? [["", "", "", `95 %: ${between(time.low, time.high, value => signed(number(value)))}`]] : [])];
  byId("numbers").append(element("p", { class: "hint" }, `Mean ± standard deviation over the cycles.${sided() ? "" : " *: the 95 % interval does not include 0."}`), scrolled(table("", sided() ? ["", "both"] : ["", "first", "second", "difference"], rows), "Numbers"));
}
function makeWarnings() {
  const list = [...found.warnings];
  which.forEach((w, i) => { const names = found[w].left_out; if (names.length && !sided()) list.push(`Only the ${w} clip has ${names.slice(0, 8).join(", ")}${names.length > 8 ? ` and ${names.length - 8} more` : ""}: not compared.`); });
  if (found.judged) list.push(`Each of the ${found.judged} differences is judged by itself. Without any difference, about ${number(found.expected_by_chance, 2)} of ${found.judged} would be marked as significant.`);
  byId("warnings").append(...list.map(text => element("li", {}, text)));
}
function makeParts() {
  const rows = order.map(index => {
    const part = found.parts[index], { lag, lag_s: seconds, amplitude, amplitude_ratio: ratio, rms_difference: rms, rms_by_chance: chance, correlation } = part.differences;
    return [element("button", { type: "button", onclick: () => { choose(index); byId("curves").scrollIntoView({ block: "center" }); } }, partName(part)),
      isKnown(lag.difference) ? share(lag.difference) + star(lag) : "–", between(lag.low, lag.high, share), isKnown(seconds.value) ? signed(fixed(seconds.value, 3)) : "–",
      number(amplitude.first), number(amplitude.second), isKnown(ratio.value) ? share(ratio.value - 1) + star(amplitude) : "–", between(minusOne(ratio.low), minusOne(ratio.high), share), number(rms), number(chance), number(correlation)];
  });
  byId("parts").append(element("p", { class: "hint" }, `Those with the largest differences first. Later: how much later in its cycle ${sided() ? "the right side" : "the second motion"} does this, relative to the whole body. Amplitude: the largest distance between two places of the mean curve. rms: over the cycle, of the difference; by chance: what the spread between cycles alone would make. *: the 95 % interval does not include 0.`), scrolled(table("",
    ["", "Later", "95 %", "Later, s", ...(sided() ? ["Amplitude, left", "right"] : ["Amplitude, first", "second"]), "Change", "95 %", "rms", "By chance", "Correlation"], rows), "All differences"));
  const still = found.parts.filter(part => !partMoves(part)).length;
  if (still > 0) byId("parts").append(element("p", { class: "facts" }, `${plural(still, "other")} ${still === 1 ? "does" : "do"} not move.`));
}
function makeDetails() {
  const { alignment: a } = found, list = [["Compared", { positions: "positions of joints", rotations6d: "rotations (6 numbers each)", euler: "joint angles", raw: "columns of the file", points: "positions of markers" }[found.features]], ["Curves", `${found.samples} samples a cycle`]];
  if (sided()) list.push(["Alignment", "the right side mirrored, half a cycle later"]);
  else list.push(["Alignment", `second shifted by ${share(a.shift)} of the cycle${isKnown(a.low) ? ` (95 %: ${between(a.low, a.high, share)})` : ""}`], ["Correlation", `${number(a.likeness)}${isKnown(a.runner_up) ? `; at the next best shift ${number(a.runner_up)}` : ""}`], ["Turned by", fixed(a.turn_deg, 1) + "°"]);
  if (isKnown(found.size_ratio) && !sided()) list.push(["Size of the second body", `${number(found.size_ratio)} of the first`]);
  list.push(...(sided() ? ["first"] : which).map(w => [sided() ? "File" : w === "first" ? "First file" : "Second file", `${found[w].path || "none (from memory)"} (${plural(found[w].frames, "frame")}, ${number(found[w].fps, 5)} per second)`]), ["Library", "libstltsa " + found.library]);
  byId("details").append(element("dl", {}, ...list.flatMap(([term, value]) => [element("dt", {}, term), element("dd", {}, String(value))])));
  if (data.command) byId("details").append(element("p", { class: "facts" }, "To make this page again:"), commandBox(data.command));
}

// The columns of stltsa compare -o FILE.csv.
function csv() {
  const cell = value => isKnown(value) ? value : "", significant = of => isKnown(of.low) ? Number(of.significant) : "";
  const judged = (name, of) => [[name + "_error", cell(of.standard_error)], [name + "_low", cell(of.low)], [name + "_high", cell(of.high)], [name + "_significant", significant(of)]];
  const values = (name, of) => [[name + "_first", cell(of.first)], [name + "_sd_first", cell(of.first_sd)], [name + "_second", cell(of.second)], [name + "_sd_second", cell(of.second_sd)], [name + "_difference", cell(of.difference)], ...judged(name, of)];
  const row = (level, part, axis, d, mean) => [["level", level], ["part", part.first], ["second_part", part.second], ["axis", axis || ""], ["rms", cell(d.rms_difference)], ["rms_by_chance", cell(d.rms_by_chance)], ["correlation", cell(d.correlation)],
    ["lag", cell(d.lag.difference)], ["lag_sd_first", cell(d.lag.first_sd)], ["lag_sd_second", cell(d.lag.second_sd)], ...judged("lag", d.lag), ["lag_s", cell(d.lag_s.value)], ...values("amplitude", d.amplitude),
    ["ratio", cell(d.amplitude_ratio.value)], ["ratio_low", cell(d.amplitude_ratio.low)], ["ratio_high", cell(d.amplitude_ratio.high)], ...values("mean", mean)];
  const rows = found.parts.flatMap(part => [row("part", part, "", part.differences, part.channels.length === 1 ? part.channels[0].mean : {}), ...part.channels.map(channel => row("channel", part, channel.axis, channel.differences, channel.mean))]);
  return csvText([rows[0].map(([head]) => head), ...rows.map(cells => cells.map(([, value]) => value))]);
}
function curvesCsv() {
  const rows = [["part", "second_part", "axis", "percent", "first_mean", "first_sd", "second_mean", "second_sd", "difference", "margin"]], cell = value => isKnown(value) ? value : "";
  for (const part of found.parts) for (const c of part.channels) for (let s = 0; s < found.samples; ++s) rows.push([part.first, part.second, c.axis || "", +(100 * s / (found.samples - 1)).toPrecision(12), ...[c.first.mean, c.first.sd, c.second.mean, c.second.sd, c.difference.mean, c.difference.margin].map(curve => cell(curve[s]))]);
  return csvText(rows);
}

function seek(phase) { state.phase = phase - Math.floor(phase); show(1); }
function choose(part) { state.part = part; show(); }
let before = 0;
function tick(now) {
  if (!state.playing) return;
  const time = found.cycle_time_s, seconds = isKnown(time.second) ? (time.first + time.second) / 2 : time.first;
  seek(state.phase + Math.min(now - before, 100) / 1000 / (seconds || 1) * state.speed);
  before = now;
  requestAnimationFrame(tick);
}
function play(on = !state.playing) {
  state.playing = on;
  byId("play").textContent = on ? "Pause" : "Play";
  if (on) { before = performance.now(); requestAnimationFrame(tick); }
}
function control() {
  const on = (id, type, act) => byId(id).addEventListener(type, act);
  on("play", "click", () => play());
  on("scrub", "input", event => seek(Math.min(0.99999, event.target.value / 100)));
  on("speed", "change", event => { state.speed = +event.target.value; });
  on("part", "change", event => choose(+event.target.value));
  on("save-json", "click", () => save(stem() + ".json", JSON.stringify(found) + "\n", "application/json"));
  on("save-csv", "click", () => save(stem() + ".csv", csv(), "text/csv"));
  on("save-curves", "click", () => save(stem() + "-curves.csv", curvesCsv(), "text/csv"));
  addEventListener("keydown", event => { if (event.key === " " && !usesSpace(event.target)) { event.preventDefault(); play(); } });
  controlTheme();
  byId("part-kind").textContent = data.skeleton || found.features === "euler" || found.features === "rotations6d" ? "Joint" : found.features === "points" ? "Marker" : "Column";
  listeners.push(level => {
    byId("scrub").value = String(100 * state.phase);
    byId("clock").textContent = `${Math.round(100 * state.phase)} % of the cycle`;
    if (level > 2) options(byId("part"), order.map(index => [index, partName(found.parts[index])]), state.part);
  });
}

async function start() {
  firstTheme();
  found = await (await inflate(data.comparison)).json();
  sortParts();
  makeHead();
  makeViewer(); makeIntervals(); makeCurves();
  makeNumbers(); makeWarnings(); makeParts(); makeDetails();
  control();
  show();
  document.documentElement.dataset.ready = "yes";
}
start().catch(error => { byId("lead").textContent = "This page cannot be shown: " + error.message + ". It needs Firefox 113, Chromium 103, Safari 16.4, or later."; throw error; });
