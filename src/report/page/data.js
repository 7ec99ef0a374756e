// Reads the data of the page. Numbers come as 16-bit integers (src/report/packed.hpp); what they mean was
// computed by the library.
const data = JSON.parse(document.getElementById("data").textContent);
const found = data.decomposition;
const clip = found.clip || { path: null, frames: data.body.places.rows, fps: 1, notes: [] };
const fps = clip.fps || 1, frames = clip.frames;
const motions = data.motions;
const stem = () => fileStem(clip.path, "clip");

class Packed {
  constructor(of, integers) { Object.assign(this, { rows: of.rows, cols: of.cols, low: of.low, unit: of.unit, integers }); }
  at(row, column) {
    const integer = this.integers[column * this.rows + row], range = column % this.low.length;
    return integer === 65535 ? NaN : this.low[range] + this.unit[range] * integer;
  }
  // Between two rows; NaN if one of them is missing.
  between(row, column) {
    const r = Math.max(0, Math.min(row, this.rows - 1)), a = Math.floor(r), t = r - a, first = this.at(a, column);
    return t === 0 ? first : first + t * (this.at(a + 1, column) - first);
  }
  column(column) { return Array.from({ length: this.rows }, (_, row) => this.at(row, column)); }
}

async function unpack(of) {
  const planes = new Uint8Array(await (await inflate(of.data)).arrayBuffer());
  const count = of.rows * of.cols, integers = new Uint16Array(count);
  for (let c = 0, at = 0; c < of.cols; ++c)
    for (let r = 0, above = 0; r < of.rows; ++r, ++at) integers[at] = above = above + planes[at] + (planes[count + at] << 8) & 65535;
  return new Packed(of, integers);
}

// Replaces each packed object by its numbers.
async function unpackAll(node) {
  await Promise.all(Object.entries(node).map(async ([key, value]) => {
    if (value === null || typeof value !== "object") return;
    if (typeof value.data === "string" && value.unit) { node[key] = await unpack(value); value.data = null; }
    else if (!Array.isArray(value) || typeof value[0] === "object") await unpackAll(value);
  }));
}

const labelOf = segment => { const text = found.segments[segment] && found.segments[segment].label; return text || ""; };
const motionOf = text => motions.find(motion => letters(motion.label) === text);
// Cycles or repetitions of a motion, in order of time.
function partsOf(motion) {
  const all = motion.cyclic ? found.cycles : found.repetitions;
  return motion.list || (motion.list = all.map((part, index) => ({ ...part, index })).filter(part => labelOf(part.segment) === letters(motion.label)));
}
const first = part => part.begin_s * fps, last = part => part.end_s * fps;
// The last element that begins at or before the frame, if it contains the frame.
function containing(list, frame) {
  let low = 0, high = list.length;
  while (low < high) { const middle = low + high >> 1; if (first(list[middle]) <= frame) low = middle + 1; else high = middle; }
  return low > 0 && frame < Math.max(last(list[low - 1]), list[low - 1].end) ? low - 1 : -1;
}

// Phase of a frame, in [0, 1): in a cycle, the stored one; in a repetition, from its times. NaN elsewhere.
function phaseAt(frame) {
  const series = data.phase.values, row = frame / data.phase.step;
  const a = series.at(Math.max(0, Math.min(Math.floor(row), series.rows - 1)), 0);
  if (!Number.isNaN(a)) {
    let b = series.at(Math.min(Math.floor(row) + 1, series.rows - 1), 0);
    if (Number.isNaN(b)) return a;
    if (b < a - 0.5) b += 1;
    return (a + (row - Math.floor(row)) * (b - a)) % 1;
  }
  const at = containing(found.repetitions, frame);
  if (at < 0) return NaN;
  const motion = motionOf(found.repetitions[at].label);
  const times = motion && motion.times && motion.times[partsOf(motion).findIndex(part => part.index === at)];
  if (!times) return NaN;
  for (let i = 0; i + 1 < times.length; ++i)
    if (times[i] !== null && times[i + 1] !== null && frame >= times[i] && frame < times[i + 1]) return (i + (frame - times[i]) / (times[i + 1] - times[i])) / (times.length - 1);
  return NaN;
}

// The frame at which a cycle or repetition has a phase; NaN if there is none.
function frameAt(motion, index, phase) {
  const part = partsOf(motion)[index];
  if (!motion.cyclic) {
    const times = motion.times && motion.times[index];
    if (!times) return NaN;
    const at = phase * (times.length - 1), i = Math.min(Math.floor(at), times.length - 2);
    return times[i] === null || times[i + 1] === null ? NaN : times[i] + (at - i) * (times[i + 1] - times[i]);
  }
  const series = data.phase.values, step = data.phase.step;
  let before = NaN;
  for (let row = Math.floor(first(part) / step); row <= Math.min(Math.ceil(last(part) / step), series.rows - 1); ++row) {
    const here = series.at(row, 0);
    const rise = here < before - 0.5 ? here + 1 - before : here - before;
    const needed = phase < before - 0.5 ? phase + 1 - before : phase - before;
    if (rise > 0 && needed >= 0 && needed < rise) {
      const frame = (row - 1 + needed / rise) * step;
      if (frame >= first(part) - step && frame <= last(part)) return frame;
    }
    before = here;
  }
  return NaN;
}

// Whether a segment has a curve: where nothing was fitted, the values are constant.
const curvedSegments = new Map(); // kept here, because the results are saved as they are
function hasCurve(segment) {
  if (!curvedSegments.has(segment)) {
    const { values, first: from, step } = data.curve, begin = Math.max(0, Math.ceil((segment.begin - from) / step)), end = Math.min(values.rows, Math.ceil((segment.end - from) / step));
    let low = Infinity, high = -Infinity;
    for (let r = begin; r < end; ++r) { const v = values.at(r, 0); if (v < low) low = v; if (v > high) high = v; }
    curvedSegments.set(segment, high - low > 20 * values.unit[0]);
  }
  return curvedSegments.get(segment);
}

const time = frame => { const s = frame / fps, m = Math.floor(s / 60); return frames / fps < 60 ? s.toFixed(2) + " s" : m + ":" + (s - 60 * m).toFixed(2).padStart(5, "0"); };
