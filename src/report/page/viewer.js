// The moving body, in three dimensions.
const body = data.body;
const moves = body.space > 0; // not a matrix of bare numbers

// x to the right, y up, z towards the viewer. In clips of points in a plane, y points down, as in images.
const axes = body.space === 2 ? [[0, 1], [1, -1], null] : body.up === 2 ? [[0, 1], [2, 1], [1, -1]] : body.up === 0 ? [[1, 1], [0, 1], [2, -1]] : [[0, 1], [1, 1], [2, 1]];
function place(row, part, to) {
  for (let a = 0; a < 3; ++a) to[a] = axes[a] ? axes[a][1] * body.places.between(row, part * body.space + axes[a][0]) : 0;
  return to;
}
function posture(frame) {
  const row = frame / body.step, list = [];
  for (let p = 0; p < body.parts.length; ++p) list.push(place(row, p, [0, 0, 0]));
  return list;
}
const known = point => !Number.isNaN(point[0] + point[1] + point[2]);
function middleOf(points) {
  const sum = [0, 0, 0];
  let count = 0;
  for (const p of points) if (known(p)) { ++count; for (let a = 0; a < 3; ++a) sum[a] += p[a]; }
  return sum.map(s => s / Math.max(1, count));
}
const median = list => list.length ? list.sort((a, b) => a - b)[list.length >> 1] : 0;

// Finds the size of the body, the ground and the direction of travel, for the initial view.
function lookAtBody() {
  const sizes = [], talls = [], lows = [], ways = [];
  for (let i = 0; i < 60; ++i) {
    const points = posture(i / 60 * frames).filter(known);
    if (!points.length) continue;
    const middle = middleOf(points);
    sizes.push(Math.max(...points.map(p => Math.hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]))));
    talls.push(Math.max(...points.map(p => p[1])) - Math.min(...points.map(p => p[1])));
    lows.push(Math.min(...points.map(p => p[1])));
    ways.push(middle);
  }
  const size = sizes.sort((a, b) => a - b)[Math.floor(sizes.length * 0.9)] || 1;
  body.size = size > 0 ? size : 1;
  body.ground = lows.sort((a, b) => a - b)[Math.floor(lows.length * 0.1)] || 0;
  body.tall = median(talls);
  body.height = median(ways.map(way => way[1]));
  const along = ways.length ? [0, 2].map(a => ways[ways.length - 1][a] - ways[0][a]) : [0, 0];
  if (body.space === 2) Object.assign(camera, { yaw: 0, pitch: 0 });
  else if (Math.hypot(...along) > body.size) camera.yaw = Math.atan2(along[1], along[0]) + 0.35; // from the side, walking to the right
  camera.first = camera.yaw;
}

// The bone from the head joint to its child or, if it has none, from its parent to the head joint; as in the library's figures.
function headBone() {
  if (body.head === undefined) {
    const isHead = i => /head/i.test(body.parts[i].name), joint = body.kind === "skeleton" ? body.parts.findIndex((_, i) => isHead(i)) : -1;
    const child = joint < 0 ? -1 : body.parts.findIndex(part => part.parent === joint);
    body.head = joint < 0 ? null : child >= 0 ? [joint, child] : body.parts[joint].parent >= 0 ? [body.parts[joint].parent, joint] : null;
  }
  return body.head;
}
const partColor = part => body.parts[part].side === 0 ? colors.left : body.parts[part].side === 1 ? colors.right : colors.middle;

function drawBody(pen, points, project, width, chosen) {
  const flat = points.map(p => known(p) ? project(p) : null);
  const shapes = [];
  body.parts.forEach((part, i) => {
    if (!flat[i]) return;
    const parent = part.parent >= 0 ? flat[part.parent] : null;
    if (parent && Math.hypot(...points[part.parent].map((v, a) => v - points[i][a])) > 0) shapes.push([Math.min(parent[2], flat[i][2]), () => pen.line([parent[0], parent[1], flat[i][0], flat[i][1]], { stroke: partColor(i), width })]);
    if (body.kind === "points") shapes.push([flat[i][2], () => pen.circle(flat[i][0], flat[i][1], width * 1.1, { fill: partColor(i) })]);
  });
  const head = headBone();
  if (head && flat[head[0]] && flat[head[1]]) { // a disk whose radius is a sixteenth of the body's height
    const [neck, crown] = head.map(i => points[i]), radius = body.tall / 16, length = Math.hypot(...crown.map((v, a) => v - neck[a]));
    const share = length > 0 ? Math.max(0.5, radius / length) : 0, middle = neck.map((v, a) => v + share * (crown[a] - v)), at = project(middle);
    const edge = project([middle[0] + radius * Math.cos(camera.yaw), middle[1], middle[2] + radius * Math.sin(camera.yaw)]);
    shapes.push([at[2], () => pen.circle(at[0], at[1], Math.hypot(edge[0] - at[0], edge[1] - at[1]), { fill: partColor(head[0]) })]);
  }
  shapes.sort((a, b) => a[0] - b[0]).forEach(shape => shape[1]());
  if (chosen >= 0 && flat[chosen]) pen.circle(flat[chosen][0], flat[chosen][1], width * 2 + 2, { stroke: colors.cursor, width: 2 });
  return flat;
}

// The path of the body over the ground, in the time range shown.
function wayShown() {
  const key = state.view.join();
  if (wayShown.key !== key) {
    const [a, b] = state.view;
    wayShown.key = key;
    wayShown.points = Array.from({ length: 161 }, (_, i) => middleOf(posture(a + (b - a) * i / 160)));
  }
  return wayShown.points;
}
function drawGround(pen, target, project) {
  drawGrid(pen, project, target, body.size, body.ground);
  const way = [];
  for (const middle of wayShown()) {
    if (Math.hypot(middle[0] - target[0], middle[2] - target[2]) < 4 * body.size) { const p = project([middle[0], body.ground, middle[2]]); way.push(p[0], p[1]); }
    else way.push(NaN, NaN);
  }
  pen.line(way, { stroke: colors.soft, width: 1.5, dash: [2, 5], alpha: 0.8 });
}

let shownFlat = [];
function makeViewer() {
  if (moves) lookAtBody();
  const kinds = { skeleton: "Skeleton", points: "Markers", columns: "Signals" };
  const tools = moves && body.space === 3 ? viewTools() : [];
  const panel = new Panel("viewer", {
    title: kinds[body.kind], tools, height: w => printing ? 315 : Math.min(470, w * (w < 500 ? 0.9 : 0.72)),
    label: moves ? "The moving body. Drag it or press the arrow keys to turn it; click a joint to see its curves." : "The columns around the current time.",
    over(pen, w, h) {
      if (!moves) return drawColumns(pen, w, h);
      const points = posture(state.frame), middle = middleOf(points);
      const target = body.space === 2 ? middle : [middle[0], body.height + (body.ground - body.height) * 0.12, middle[2]];
      const project = projection(target, w, h, 0.42 * h / body.size * camera.zoom, body.size, body.space === 2);
      pen.clip(0, 0, w, h, () => {
        if (body.space === 3) drawGround(pen, target, project);
        shownFlat = drawBody(pen, points, project, Math.max(2.2, Math.min(5, h / 95 * camera.zoom)), state.part);
      });
      pen.rect(0, h - 28, w, 28, { fill: colors.sheet, alpha: 0.8 });
      let x = 14;
      if (body.parts.some(part => part.side === 0)) for (const [side, color] of [["left", colors.left], ["right", colors.right]]) { pen.circle(x, h - 14, 4, { fill: color }); pen.text(x + 9, h - 14, side, { color: colors.soft }); x += 58; }
      const at = containing(found.segments, state.frame), segment = found.segments[at], unit = found.units[containing(found.units, state.frame)];
      if (segment) pen.text(w - 14, h - 14, [segment.label, unit && unitText(unit), cycleText(state.frame)].filter(Boolean).join(" · "), { color: colors.soft, align: "right" });
      if (state.part >= 0 && body.parts[state.part]) pen.text(14, 12, body.parts[state.part].name, { color: colors.cursor, bold: true });
    },
  });
  if (!moves) return;
  orbit(panel.canvas, body.space === 2, (x, y) => {
    let best = -1, least = 22;
    shownFlat.forEach((p, i) => { const d = p ? Math.hypot(p[0] - x, p[1] - y) : 99; if (d < least) { least = d; best = i; } });
    if (best >= 0) { state.part = best; show(); }
  });
  panel.canvas.ondblclick = () => motions.length && addMark();
}
function cycleText(frame) {
  const cycle = containing(found.cycles, frame);
  if (cycle >= 0) return "cycle " + (cycle + 1);
  const repetition = containing(found.repetitions, frame);
  return repetition >= 0 ? "repetition " + (repetition + 1) : "";
}

// For a matrix: the columns that move most in the segment at the current time.
function chosenColumns(most) {
  const at = containing(found.segments, state.frame), segment = found.segments[at];
  const names = segment && segment.carried_by.length ? segment.carried_by : (found.segments.find(s => s.carried_by.length) || { carried_by: [] }).carried_by;
  const list = [...new Set([state.part, ...names.map(name => body.parts.findIndex(part => part.name === name)), ...body.parts.keys()])].filter(i => i >= 0);
  return list.slice(0, most).sort((a, b) => a - b);
}
function drawColumns(pen, w, h) {
  const list = chosenColumns(6), half = Math.min(frames / 2, Math.max(2 * fps, 40));
  const begin = Math.max(0, Math.min(state.frame - half, frames - 2 * half)), x = frame => 110 + (frame - begin) / (2 * half) * (w - 124);
  const rows = Math.max(1, list.length), each = (h - 34) / rows;
  list.forEach((part, k) => {
    const top = 8 + k * each, low = body.places.low[part % body.places.low.length], range = body.places.unit[part % body.places.unit.length] * 65534 || 1, points = [];
    pen.line([110, top + each - 6, w - 14, top + each - 6], { stroke: colors.line });
    const step = Math.max(body.step, 2 * half / w);
    for (let frame = begin; frame <= begin + 2 * half; frame += step) points.push(x(frame), top + each - 8 - (body.places.between(frame / body.step, part) - low) / range * (each - 14));
    pen.clip(108, 0, w - 120, h, () => pen.line(points, { stroke: part === state.part ? colors.cursor : colors.accent, width: 1.6 }));
    pen.text(102, top + each / 2, fitted(pen, body.parts[part].name, 92), { color: colors.soft, align: "right" });
  });
  const axis = timeTicks(begin / fps, (begin + 2 * half) / fps, 5);
  for (const s of axis.list) pen.text(x(s * fps), h - 12, axis.text(s), { color: colors.soft, align: "center", size: 11 });
  pen.line([x(state.frame), 6, x(state.frame), h - 24], { stroke: colors.cursor, width: 1.5 });
}
