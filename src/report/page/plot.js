// Curves on 0 to 100 % of a cycle.
const axisText = (axis, up) => axis.length === 1 ? axis + (axis === "xyz"[up] ? " (up)" : "") : axis.length === 2 ? "turn about " + axis[1] : axis;

// Indices of values that follow one another without a gap.
function knownParts(values) {
  const parts = [];
  values.forEach((value, i) => { if (Number.isNaN(value)) return; if (i > 0 && !Number.isNaN(values[i - 1])) parts[parts.length - 1].push(i); else parts.push([i]); });
  return parts;
}

// One plot: means with standard deviation, and single cycles.
function drawPlot(pen, box, lines, range, { title, suffix = "", color, axis, bottom }) {
  const { x, y, w, h } = box, px = share => x + share * w, py = v => y + h - (v - range[0]) / (range[1] - range[0]) * h;
  pen.rect(x, y, w, h, { fill: colors.paper, radius: 6 });
  for (const t of [0.25, 0.5, 0.75]) pen.line([px(t), y, px(t), y + h], { stroke: colors.grid });
  const unknown = lines.every(line => line.mean.every(Number.isNaN)), marks = unknown ? [] : ticks(range[0], range[1], 4), texts = tickTexts(marks);
  marks.forEach((v, i) => { pen.line([x, py(v), x + w, py(v)], { stroke: colors.grid }); if (axis) pen.text(x - 6, py(v), texts[i], { size: 11, color: colors.soft, align: "right" }); });
  pen.clip(x, y, w, h, () => {
    for (const line of lines) {
      if (line.sd) for (const part of knownParts(line.mean.map((m, i) => m + line.sd[i]))) {
        const edge = sign => part.map(i => [px(i / (line.mean.length - 1)), py(line.mean[i] + sign * line.sd[i])]);
        pen.line([...edge(1), ...edge(-1).reverse()].flat(), { fill: line.color, alpha: 0.2 });
      }
      for (const one of line.each || []) pen.line(one.flatMap((v, i) => [px(i / (one.length - 1)), py(v)]), { stroke: line.color, width: 0.8, alpha: 0.4 });
      pen.line(line.mean.flatMap((v, i) => [px(i / (line.mean.length - 1)), py(v)]), { stroke: line.color, width: 2.4, dash: line.dash || [] });
    }
  });
  if (unknown) pen.text(x + w / 2, y + h / 2, "too many values are missing", { color: colors.soft, align: "center" });
  if (title) pen.text(x, y - 10, fitted(pen, title, w - pen.measure(suffix) - 8) + suffix, { bold: true, color: color || colors.ink });
  if (bottom) for (const t of w < 190 ? [0, 0.5, 1] : [0, 0.25, 0.5, 0.75, 1]) pen.text(px(t), y + h + 12, t === 1 ? "100 %" : String(100 * t), { size: 11, color: colors.soft, align: t === 1 ? "right" : t ? "center" : "left" });
}
