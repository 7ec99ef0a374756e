// Selections, keys, saving and printing.
function choices() {
  const motion = motionShown();
  if (!motion) return;
  options(byId("label"), motions.map((m, i) => [i, `${letters(m.label)} · ${plural(partsOf(m).length, m.cyclic ? "cycle" : "repetition")}`]), state.label);
  byId("c-label").hidden = motions.length < 2;
  const names = { position: "positions", angle: "joint angles", rotation: "rotations", value: "values" };
  options(byId("set"), motion.sets.map((set, i) => [i, names[set.name] || set.name]), Math.min(state.set, motion.sets.length - 1));
  byId("c-set").hidden = motion.sets.length < 2;
  const set = setShown(), seen = new Set(), list = [];
  for (const column of set ? set.columns : []) {
    const part = body.parts[column.part];
    if (!part || seen.has(column.part)) continue;
    const pair = part.partner >= 0 && set.columns.some(other => other.part === part.partner) ? part.partner : -1;
    seen.add(column.part).add(pair);
    list.push([column.part, pair >= 0 ? `${part.name} – ${body.parts[pair].name}` : part.name]);
  }
  const shown = partShown(), partner = body.parts[shown] ? body.parts[shown].partner : -1;
  options(byId("part"), list, list.some(([value]) => value === shown) ? shown : partner);
  byId("c-part").firstChild.textContent = { skeleton: "Joint ", points: "Marker ", columns: "Column " }[body.kind];
  const own = state.marks.map((mark, i) => [i + 1, mark.name, mark]).filter(([, , mark]) => mark.label === letters(motion.label));
  options(byId("zero"), [[0, "phase 0"], ...own.map(([value, text]) => [value, text])], own.some(([value]) => value === state.zero) ? state.zero : 0);
  byId("c-zero").hidden = !own.length;
}

function csv() {
  const rows = [["level", "kind", "label", "begin", "end", "begin_s", "end_s", "duration_s", "likeness", "confidence"]];
  const add = (level, kind, label, part) => rows.push([level, kind, label, part.begin, part.end, part.begin_s, part.end_s, part.end_s - part.begin_s, part.likeness ?? "", part.confidence ?? ""]);
  for (const s of found.segments) add("segment", s.kind, s.label || "", s);
  for (const u of found.units) add("unit", u.kind, labelOf(u.segment), u);
  for (const c of found.cycles) add("cycle", "cycle", labelOf(c.segment), c);
  for (const r of found.repetitions) add("repetition", "repetition", r.label, r);
  return csvText(rows);
}
function cyclesCsv() {
  const rows = [["label", "signal", "name", "axis", "percent", "mean", "sd"]];
  for (const motion of motions) for (const set of motion.sets) set.columns.forEach((column, c) => { for (let r = 0; r < set.mean.rows; ++r) rows.push([letters(motion.label), set.name, column.name, column.axis, r, set.mean.at(r, c), Number.isNaN(set.sd.at(r, c)) ? "" : set.sd.at(r, c)]); });
  return csvText(rows);
}

function showExport() {
  const [a, b] = state.view.map(Math.round), whole = a <= 0 && b >= frames, stretch = whole ? "" : `${a}-${b}`;
  byId("shown").textContent = whole ? "" : `shown: ${time(a)} to ${time(b)}, frames ${a} to ${b}`;
  if (byId("export").dataset.key === stretch + "!") return;
  byId("export").dataset.key = stretch + "!";
  // The whole file in its own format would be written over itself.
  const suffixes = ["glb", "bvh"].filter(suffix => !whole || cut || suffix !== clip.format);
  const name = stem().replace(/\.\w+$/, "") + (stretch || cut ? "-" + (stretch || "stretch") : "");
  byId("export").replaceChildren(...(body.kind === "skeleton" ? [element("p", { class: "facts" }, whole ? "The whole clip for other programs (to choose a part of it, zoom in above):" : "The part of the clip that is shown above, for other programs:"), ...suffixes.map(suffix => commandBox(`stltsa synthesize ${stretchWords(a, b)}${flagWords("synthesize")} -o ${argumentWord(name + "." + suffix)}`))] : []));
}

function control() {
  const on = (id, type, act) => byId(id).addEventListener(type, act);
  on("play", "click", () => play());
  on("back", "click", () => seek(Math.ceil(state.frame) - 1));
  on("forth", "click", () => seek(Math.floor(state.frame) + 1));
  on("mark", "click", addMark);
  byId("scrub").max = String(frames - 1);
  on("scrub", "input", event => seek(+event.target.value));
  on("speed", "change", event => { state.speed = +event.target.value; });
  on("closer", "click", () => zoomBy(0.5));
  on("wider", "click", () => zoomBy(2));
  on("whole", "click", () => zoomTo(0, frames));
  on("label", "change", event => select(+event.target.value));
  on("set", "change", event => { state.set = +event.target.value; show(); });
  on("part", "change", event => { state.part = +event.target.value; show(); });
  on("zero", "change", event => { state.zero = +event.target.value; show(); });
  on("save-json", "click", () => save(stem() + ".json", JSON.stringify(found) + "\n", "application/json"));
  on("save-csv", "click", () => save(stem() + ".csv", csv(), "text/csv"));
  on("save-cycles", "click", () => save(stem() + "-cycles.csv", cyclesCsv(), "text/csv"));
  addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches('select, textarea, input[type="text"]')) return;
    if (event.key === " " && !usesSpace(event.target)) { event.preventDefault(); play(); }
    else if ((event.key === "m" || event.key === "M") && motions.length) addMark();
  });
  controlTheme();
  listeners.push(level => {
    byId("scrub").value = String(state.frame);
    byId("scrub").setAttribute("aria-valuetext", time(state.frame));
    byId("clock").textContent = `${time(state.frame)} · frame ${Math.round(state.frame)}`;
    if (level > 1) showExport();
    if (level > 2) choices();
  });
}

async function start() {
  firstTheme();
  makeHead();
  await unpackAll(data);
  // The motion with the most frames comes first.
  const lengths = motions.map(motion => partsOf(motion).reduce((sum, part) => sum + part.end - part.begin, 0));
  state.label = Math.max(0, lengths.indexOf(Math.max(...lengths)));
  const representative = found.representative_cycle || (motions.length ? partsOf(motions[state.label])[0] : null);
  if (representative) state.frame = Math.round(representative.begin + 0.22 * (representative.end - representative.begin));
  makeViewer(); makeBand(); makeLoop(); makeCycles(); makeGroup();
  makeSummary(); makeSides(); makeWarnings(); makeTables(); makeDetails();
  showMarks();
  byId("mark").hidden = byId("s-events").hidden = !motions.length; // nothing repeats, so a mark cannot be found again
  byId("save-cycles").hidden = !motions.some(motion => motion.sets.length);
  control();
  show();
  document.documentElement.dataset.ready = "yes";
}
start().catch(error => { byId("lead").textContent = "This report cannot be shown: " + error.message + ". It needs Firefox 113, Chromium 103, Safari 16.4, or later."; throw error; });
