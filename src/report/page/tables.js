// Texts and tables.
const swatch = hue => element("span", { class: "swatch", style: `background:${hue}` });
const named = label => element("span", {}, swatch(labelHue(numberOf(label))), label);

function leadText() {
  const texts = found.summary.map(s => {
    const cyclic = isCyclic(s);
    return `${s.label}: ${plural(s.count, cyclic ? "cycle" : "repetition")} of ${number(s.cycle_time_s.mean)} s${cyclic ? ` (${number(s.cycles_per_min)} per minute)` : ""}`;
  });
  const moving = found.segments.filter(s => s.kind !== "rest");
  if (!texts.length) return moving.length ? "Nothing in this recording repeats." : "The body rests throughout the recording.";
  return (moving.length > 1 ? `${plural(moving.length, "segment")} of motion. ` : "") + texts.slice(0, 5).join("; ") + (texts.length > 5 ? `; and ${texts.length - 5} more` : "") + ".";
}

function makeHead() {
  const name = (data.source.name || clip.path || "Motion").split("/").pop();
  byId("title").textContent = name;
  document.title = name + " – motion report";
  byId("lead").textContent = leadText();
  const count = body.parts.length;
  byId("facts").textContent = [plural(frames, "frame"), clip.fps ? `${number(fps, 5)} frames per second` : null, time(frames), body.kind === "skeleton" ? plural(count, "joint") : body.kind === "points" ? plural(count, "marker") : plural(count, "column")].filter(Boolean).join(" · ");
}

const degrees = value => value === null || value === undefined ? "–" : fixed(value, Math.abs(value) < 10 ? 1 : 0);
// The trend over the time from the middle of the first cycle to that of the last, with its 95 % interval.
function trendText(s) {
  const motion = motionOf(s.label), parts = partsOf(motion), middle = part => (part.begin_s + part.end_s) / 2;
  const minutes = (middle(parts[parts.length - 1]) - middle(parts[0])) / 60;
  const margin = motion.trend_margin === null ? "" : ` ± ${percent(motion.trend_margin * minutes)}`;
  return `${signed(percent(s.cycle_time_s.trend * minutes))}${margin} in ${number(60 * minutes)} s`;
}

// Of the segments of a motion, from the least to the most certain.
function confidenceText(s) {
  const all = found.segments.filter(segment => segment.label === s.label && repeats(segment)).map(segment => segment.confidence).sort((a, b) => a - b);
  return !all.length ? "–" : all.length === 1 ? percent(all[0], 0) : `${percent(all[0], 0)} to ${percent(all[all.length - 1], 0)}`;
}
const repeats = segment => segment.kind === "cyclic" || segment.kind === "repetitions";
const isCyclic = s => found.segments.some(segment => segment.label === s.label && segment.kind === "cyclic");
function makeSummary() {
  const place = byId("summary");
  if (!found.summary.length) { byId("s-summary").hidden = true; return; }
  place.setAttribute("tabindex", "0"); place.setAttribute("role", "region"); place.setAttribute("aria-label", "Numbers of each motion");
  const of = value => !value ? "–" : withSd(value.mean, value.sd);
  const least = 5; // a trend over fewer says nothing
  const all = found.summary.every(isCyclic), none = !found.summary.some(isCyclic), each = all ? "cycle" : none ? "repetition" : "cycle or repetition";
  const rows = [["Number", s => String(s.count)], ["Cycles per minute", s => isCyclic(s) ? number(s.cycles_per_min) : "–"], [`${all ? "Cycle time" : none ? "Duration" : "Cycle time or duration"}, s (mean ± SD)`, s => of(s.cycle_time_s)],
    ["Confidence", s => confidenceText(s)], ["Variation (CV)", s => s.count > 1 ? percent(s.cycle_time_s.cv) : "–"], [`Change of the ${none ? "duration" : "cycle time"}, first to last`, s => s.count >= least ? trendText(s) : "–"],
    ["Steps per minute", s => number(s.steps_per_min)], ["Step time of one side, of the other, s", s => s.step_time_s && s.step_time_s.side_means ? s.step_time_s.side_means.map(value => number(value)).join(", ") : "–"], ["Speed, units / s", s => of(s.speed)], ["Stride length, units", s => s.steps_per_min === null ? "–" : of(s.stride)], [`Path length per ${each}, units`, s => of(s.path_length)], [`Turn per ${each}, °`, s => !s.turn_deg ? "–" : s.count > 1 ? of(s.turn_deg) : degrees(s.turn_deg.mean)],
    ["Largest left–right difference", s => { const m = motionOf(s.label), pairs = m && m.sides ? m.sides.pairs : []; const p = [...pairs].filter(x => x.rms !== null).sort((a, b) => b.rms - a.rms)[0]; return p ? `${p.left} – ${p.right}: ${number(p.rms, 2)}${p.chance === null ? "" : ` (by chance: ${number(p.chance, 2)})`}` : "–"; }]]
    .map(([head, value]) => [head, ...found.summary.map(value)]).filter(row => row.slice(1).some(cell => cell !== "–"));
  place.append(element("p", { class: "hint" }, (found.summary.some(s => s.speed) ? "Speed and path length describe the body in the space of the file, so they are small on a treadmill. " : "") + (body.kind === "columns" ? "" : "Lengths are in the unit of the file. ") + "SD: standard deviation; CV: SD / mean; after ± of a change: half the width of its 95 % interval. Confidence: how certain it is that the motion repeats."), table("", ["", ...found.summary.map(s => named(s.label))], rows));
}

function makeSides() {
  const section = byId("s-sides"), place = byId("sides");
  if (!motions.some(motion => motion.sides)) { section.hidden = true; return; }
  listeners.push(level => {
    if (level < 3) return;
    const sides = motionShown().sides;
    section.hidden = !sides || !sides.pairs.length && body.kind === "columns";
    if (section.hidden) return;
    if (!sides.pairs.length) return place.replaceChildren(element("p", { class: "facts" }, "Not compared: " + sides.reason));
    const rows = [...sides.pairs].sort((a, b) => (b.rms || 0) - (a.rms || 0)).slice(0, 8);
    const hint = element("p", { class: "hint" }, `Motion ${letters(motionShown().label)}: the largest of ${sides.pairs.length} differences between the left side and the mirrored right side half a cycle later. A difference is real if it is well above the value expected by chance.`);
    place.replaceChildren(hint, scrolled(table("", ["Left – right", "", "Difference (rms)", "By chance", "Mean left − right", "Range left", "Range right", "Delay of the right"],
      rows.map(p => [`${p.left} – ${p.right}`, p.axis ? axisText(p.axis, body.up) : "", number(p.rms), number(p.chance), signed(number(p.mean)), number(p.left_range), number(p.right_range), signed(percent(p.shift))]), 2), "Left against right"));
  });
}

function makeWarnings() {
  const texts = found.warnings.map(w => w.text + (w.begin_s === null ? "" : ` (at ${number(w.begin_s, 4)} s)`));
  texts.push(...data.phase.warnings, ...(clip.notes || []));
  if (clip.dropped_start_frames > 0 && body.kind === "skeleton") texts.push(`The results leave out the T-pose at the beginning: ${plural(clip.dropped_start_frames, "frame")}.`);
  if (body.step > 1) texts.push(`To keep the file small, this page has only every ${body.step}${body.step === 2 ? "nd" : body.step === 3 ? "rd" : "th"} posture (${number(fps / body.step)} per second) and interpolates between them. The results are from all frames.`);
  for (const motion of motions) {
    if (motion.reason) texts.push(`No curves for ${letters(motion.label)}: ${motion.reason}`);
    for (const set of motion.sets) if (set.columns.length < set.columns_of_all) texts.push(`Curves are shown for the ${set.columns.length} of ${set.columns_of_all} columns that move most.`);
  }
  if (found.reason) texts.push("Nothing repeats: " + found.reason);
  for (const s of found.segments) if (repeats(s) && s.confidence < 0.5) texts.push(`${s.label} at ${time(s.begin)}: it is doubtful that this repeats (confidence ${percent(s.confidence, 0)})`);
  for (const s of found.segments) if (s.reason && s.kind === "action" && found.summary.length) texts.push(`${s.label} at ${time(s.begin)}: ${s.reason}`);
  const list = [...new Set(texts)].map(text => text[0].toUpperCase() + text.slice(1)), printed = 6;
  if (list.length > printed) byId("warnings").dataset.more = `and ${list.length - printed} more in the file`;
  byId("warnings").append(...list.slice(0, 12).map(text => element("li", {}, text)));
  if (list.length > 12) byId("warnings").after(element("details", {}, element("summary", {}, `${list.length - 12} more`), element("ul", {}, ...list.slice(12).map(text => element("li", {}, text)))));
  if (!list.length) byId("warnings").append(element("li", {}, "There are no warnings."));
}

// Rows of a long table are made when it is opened.
function folded(title, make) {
  const box = element("details", {}, element("summary", {}, title));
  box.ontoggle = () => { if (box.open && box.children.length === 1) box.append(make()); };
  return box;
}
function makeTables() {
  const go = part => element("button", { type: "button", onclick: () => { seek(part.begin); zoomTo(first(part) - 0.5 * (last(part) - first(part)), last(part) + 0.5 * (last(part) - first(part))); } }, time(first(part)));
  const length = part => number(part.end_s - part.begin_s);
  const travel = part => part.travel ? [number(part.travel.speed), number(part.travel.path_length), degrees(part.travel.turn_deg)] : ["–", "–", "–"];
  const limit = 2000, more = list => list.length > limit ? ` (the first ${limit} here; all are in the JSON)` : "";
  const add = (title, list, heads, row) => { if (list.length) byId("tables").append(folded(`${title}: ${list.length}${more(list)}`, () => scrolled(table("", heads, list.slice(0, limit).map(row), 2), title))); };
  add("Segments", found.segments, ["", "Kind", "From", "Seconds", "Number", "Cycle time, s", "Confidence", "Moves most"], (s, i) => [String(i + 1), s.label ? element("span", {}, named(s.label), " " + s.kind) : segmentText(s), go(s), length(s), String(s.count), number(s.period_s), percent(s.confidence, 0), s.carried_by.slice(0, 3).join(", ")]);
  const alike = found.label_likeness;
  const shown = alike.slice(0, 26), some = alike.length > shown.length ? `: ${alike.length} (the first ${shown.length} here; all are in the JSON)` : "";
  if (shown.length > 1) byId("tables").append(folded("Likeness of motions" + some, () => scrolled(table("", ["", ...shown.map((_, i) => named(letters(i)))], shown.map((row, i) => [named(letters(i)), ...row.slice(0, shown.length).map(v => percent(v, 0))]), 1), "Likeness of motions")));
  add("Units", found.units, ["", "Kind", "From", "Seconds"], (u, i) => [String(i + 1), unitText(u), go(u), length(u)]);
  for (const [title, list] of [["Cycles", found.cycles], ["Repetitions", found.repetitions]])
    add(title, list, ["", "Motion", "From", "Seconds", "Speed", "Path length", "Turn, °", "Likeness", "Confidence"], (c, i) => [String(i + 1), named(labelOf(c.segment)), go(c), length(c), ...travel(c), percent(c.likeness, 0), percent(c.confidence, 0)]);
}

// What a shell reads as an argument that is no option.
const argumentWord = text => shellWord(text.startsWith("-") ? "./" + text : text);
const { name: clipName, pieces, flags } = data.source; // the clip may be a stretch of its file, or several
const cut = pieces.length > 0;
const clipWord = () => argumentWord(clipName || "CLIP");
// Only Python reads this format.
const foreign = /\.npz$/i.test(clip.path || "");
// Frames of the clip as stretches of its file.
function stretchWords(begin, end) {
  if (begin <= 0 && end >= frames) return clipWord();
  let at = 0;
  return (cut ? pieces : [[0, frames]]).flatMap(([from, to]) => {
    const a = Math.max(from, from + begin - at), b = Math.min(to, from + end - at);
    at += to - from;
    return a < b ? [argumentWord(`${clip.path || "CLIP"}:${a}-${b}`)] : [];
  }).join(" ");
}
// Flags of a command for the options with which the clip was read; text files need their rate.
const flagWords = command => flags[command] + (["csv", "npy"].includes(clip.format) && clip.fps && !flags[command].includes(" --fps ") ? " --fps " + +fps.toPrecision(9) : "");
function makeDetails() {
  const p = found.parameters, samples = found.samples, e = found.embedding || {};
  const values = (e.eigenvalues || []).filter(v => v !== null), isFitted = values.length > 0;
  const noFit = "none: there are no cycles";
  const list = [["Features", `${clip.features}, ${plural(samples.feature_count, "column")}`], ["Samples", `${samples.count} at ${number(samples.fps, 4)} per second, smoothed over ${number(samples.smoothing_s)} s`],
    ["Neighbors", isFitted ? `${p.neighbors}, ${p.mode}, window ${p.window}, in samples of which a cycle has 24` : noFit], ["Dimension of the tangents", isFitted ? p.dimension : noFit], ["Range of the period search", `${number(p.period_min_s)} to ${number(p.period_max_s)} s`],
    ["Period", found.period_s ? number(found.period_s) + " s" : "none"], ["Residual of the eigenvectors", isFitted ? number(data.accuracy.residual) + " (largest ‖Bu − λu‖ / k)" : noFit],
    ["Estimated error of the subspace", !isFitted ? noFit : data.accuracy.error_estimate === null ? "unknown" : number(data.accuracy.error_estimate) + " rad (largest angle)"], ["Regularity of the curve", e.cyclicity ? number(e.cyclicity) + " (1: perfect)" : "–"], ["Up axis", samples.up_axis || "–"],
    ["Library", "libstltsa " + found.library], ["File", clip.path || "none (from memory)"], ["Checksum of the data", "CRC-32 " + data.checksum]];
  const again = data.command || (clip.path ? `stltsa decompose ${clipWord()}${flagWords("decompose")} --report ${shellWord(stem() + ".html")}` : "");
  byId("details").append(element("dl", {}, ...list.flatMap(([term, value]) => [element("dt", {}, term), element("dd", {}, String(value))])),
    element("p", { class: "facts" }, again ? "To make this report again:" : "The clip came from memory, so no command makes this report again."), foreign ? element("p", { class: "facts" }, "The command does not read this file format; Python does.") : "", again ? commandBox(again) : "");
  if (values.length < 2) return;
  new Panel("spectrum", {
    title: "Spectrum of the alignment matrix", height: () => 190, label: "Eigenvalues of the alignment matrix: " + values.map(v => number(v)).join(", "),
    base(pen, w, h) {
      const high = Math.max(...values) || 1, x = i => 58 + (i + 0.5) * (w - 76) / values.length, y = v => h - 30 - v / high * (h - 50);
      for (const v of ticks(0, high, 3)) { pen.line([52, y(v), w - 14, y(v)], { stroke: colors.grid }); pen.text(48, y(v), number(v), { size: 11, color: colors.soft, align: "right" }); }
      values.forEach((v, i) => { pen.line([x(i), y(0), x(i), y(v)], { stroke: colors.accent, width: 2 }); pen.circle(x(i), y(v), 4.5, { fill: colors.accent }); pen.text(x(i), h - 14, "λ" + (i + 1), { size: 11, color: colors.soft, align: "center" }); });
    },
  });
}
