// Curves on 0 to 100 % of a cycle.
const axisText = (axis, up) => axis.length === 1 ? axis + (axis === "xyz"[up] ? " (up)" : "") : axis.length === 2 ? "turn about " + axis[1] : axis;

// One plot: means with standard deviation, and single cycles.
function drawPlot(pen, box, lines, range, { title, color, axis, bottom }) {
  const { x, y, w, h } = box, px = share => x + share * w, py = v => y + h - (v - range[0]) / (range[1] - range[0]) * h;
  pen.rect(x, y, w, h, { fill: colors.paper, radius: 6 });
  for (const t of [0.25, 0.5, 0.75]) pen.line([px(t), y, px(t), y + h], { stroke: colors.grid });
  for (const v of ticks(range[0], range[1], 4)) { pen.line([x, py(v), x + w, py(v)], { stroke: colors.grid }); if (axis) pen.text(x - 6, py(v), number(v, 4), { size: 11, color: colors.soft, align: "right" }); }
  pen.clip(x, y, w, h, () => {
    for (const line of lines) {
      if (line.sd) {
        const up = [], down = [];
        line.mean.forEach((m, i) => { if (Number.isNaN(m + line.sd[i])) return; up.push(px(i / (line.mean.length - 1)), py(m + line.sd[i])); down.unshift(px(i / (line.mean.length - 1)), py(m - line.sd[i])); });
        pen.line([...up, ...down], { fill: line.color, alpha: 0.2 });
      }
      for (const one of line.each || []) pen.line(one.flatMap((v, i) => [px(i / (one.length - 1)), py(v)]), { stroke: line.color, width: 0.8, alpha: 0.4 });
      pen.line(line.mean.flatMap((v, i) => [px(i / (line.mean.length - 1)), py(v)]), { stroke: line.color, width: 2.4, dash: line.dash || [] });
    }
  });
  if (title) pen.text(x, y - 10, title, { bold: true, color: color || colors.ink });
  if (bottom) for (const t of w < 190 ? [0, 0.5, 1] : [0, 0.25, 0.5, 0.75, 1]) pen.text(px(t), y + h + 12, t === 1 ? "100 %" : String(100 * t), { size: 11, color: colors.soft, align: t === 1 ? "right" : t ? "center" : "left" });
}
