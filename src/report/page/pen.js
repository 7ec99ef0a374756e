// Two pens with the same functions: one draws on a canvas, the other writes SVG.
const colors = {}, hues = {};
// Okabe and Ito's colors, which color-blind people can tell apart, as in the library's figures; lighter in the dark.
const palettes = {
  light: { blue: "#0072b2", orange: "#e69f00", green: "#009e73", purple: "#cc79a7", sky: "#56b4e9", vermilion: "#d55e00", yellow: "#d9c400", gray: "#8c959f" },
  dark: { blue: "#4aa8e0", orange: "#f0b63a", green: "#35c49a", purple: "#e09cc2", sky: "#8fd0f7", vermilion: "#f08a4b", yellow: "#efe04a", gray: "#98a1ab" },
};
function readColors() {
  Object.assign(hues, palettes[document.documentElement.dataset.theme]);
  const style = getComputedStyle(document.documentElement);
  for (const name of ["paper", "sheet", "ink", "soft", "line", "grid", "accent", "left", "right", "middle", "cursor", "alpha"]) colors[name] = style.getPropertyValue("--" + name).trim();
}
const hueOfUnit = kind => hues[{ preparing: "sky", initial: "orange", cyclic: "blue", final: "vermilion", "wind-up": "purple", action: "green", hold: "yellow" }[kind]] || hues.green;
const labelHue = label => label < 0 ? hues.gray : hues[["blue", "orange", "green", "purple", "sky", "vermilion", "yellow"][label % 7]];
const font = "system-ui, 'Segoe UI', Roboto, 'Liberation Sans', Arial, sans-serif";

class CanvasPen {
  constructor(context) { this.context = context; }
  style({ fill, stroke, width = 1, dash = [], alpha = 1 }) {
    const c = this.context;
    c.globalAlpha = alpha; c.lineWidth = width; c.setLineDash(dash); c.lineJoin = c.lineCap = "round";
    if (fill) { c.fillStyle = fill; c.fill(); }
    if (stroke) { c.strokeStyle = stroke; c.stroke(); }
    c.globalAlpha = 1;
  }
  // Points [x, y, x, y, ...]; NaN interrupts the line.
  line(points, look) {
    const c = this.context;
    c.beginPath();
    for (let i = 0, down = false; i < points.length; i += 2) {
      if (Number.isNaN(points[i]) || Number.isNaN(points[i + 1])) { down = false; continue; }
      if (down) c.lineTo(points[i], points[i + 1]); else c.moveTo(points[i], points[i + 1]);
      down = true;
    }
    this.style(look);
  }
  rect(x, y, w, h, look) { const c = this.context; c.beginPath(); if (look.radius && c.roundRect) c.roundRect(x, y, w, h, Math.min(look.radius, w / 2, h / 2)); else c.rect(x, y, w, h); this.style(look); }
  circle(x, y, r, look) { this.context.beginPath(); this.context.arc(x, y, r, 0, 2 * Math.PI); this.style(look); }
  text(x, y, text, { color = colors.ink, size = 12, align = "left", base = "middle", bold = false } = {}) {
    const c = this.context;
    c.font = (bold ? "600 " : "") + size + "px " + font; c.textAlign = align; c.textBaseline = base; c.fillStyle = color; c.fillText(text, x, y);
  }
  measure(text, size = 12) { this.context.font = size + "px " + font; return this.context.measureText(text).width; }
  clip(x, y, w, h, draw) { const c = this.context; c.save(); c.beginPath(); c.rect(x, y, w, h); c.clip(); draw(); c.restore(); }
}

const escaped = text => String(text).replace(/[&<>"']/g, c => "&#" + c.charCodeAt(0) + ";");
const measuring = new CanvasPen(document.createElement("canvas").getContext("2d"));
class SvgPen {
  constructor(id, width, height) { this.id = id; this.width = width; this.height = height; this.parts = []; this.clips = 0; }
  style({ fill = "none", stroke, width = 1, dash = [], alpha = 1 }) {
    return ` fill="${fill}"` + (stroke ? ` stroke="${stroke}" stroke-width="${width}" stroke-linejoin="round" stroke-linecap="round"` : "") +
      (dash.length ? ` stroke-dasharray="${dash}"` : "") + (alpha < 1 ? ` opacity="${+alpha}"` : "");
  }
  line(points, look) {
    let path = "", down = false;
    for (let i = 0; i < points.length; i += 2) {
      if (Number.isNaN(points[i]) || Number.isNaN(points[i + 1])) { down = false; continue; }
      path += (down ? "L" : "M") + points[i].toFixed(2) + " " + points[i + 1].toFixed(2);
      down = true;
    }
    this.parts.push(`<path d="${path}"${this.style(look)}/>`);
  }
  rect(x, y, w, h, look) { this.parts.push(`<rect x="${x.toFixed(2)}" y="${y.toFixed(2)}" width="${Math.max(0, w).toFixed(2)}" height="${Math.max(0, h).toFixed(2)}"${look.radius ? ` rx="${look.radius}"` : ""}${this.style(look)}/>`); }
  circle(x, y, r, look) { this.parts.push(`<circle cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="${r}"${this.style(look)}/>`); }
  text(x, y, text, { color = colors.ink, size = 12, align = "left", base = "middle", bold = false } = {}) {
    const anchor = { left: "start", center: "middle", right: "end" }[align], shift = { middle: 0.35, top: 0.8, bottom: -0.2, alphabetic: 0 }[base] * size;
    this.parts.push(`<text x="${x.toFixed(2)}" y="${(y + shift).toFixed(2)}" font-size="${size}"${bold ? ' font-weight="600"' : ""} text-anchor="${anchor}" fill="${color}">${escaped(text)}</text>`);
  }
  measure(text, size) { return measuring.measure(text, size); }
  clip(x, y, w, h, draw) {
    const name = `${this.id}-clip${this.clips++}`;
    this.parts.push(`<clipPath id="${name}"><rect x="${x}" y="${y}" width="${w}" height="${h}"/></clipPath><g clip-path="url(#${name})">`);
    draw();
    this.parts.push("</g>");
  }
  toString() {
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${this.width}" height="${this.height}" viewBox="0 0 ${this.width} ${this.height}" font-family="${escaped(font)}">` +
      `<rect width="100%" height="100%" fill="${colors.paper}"/>${this.parts.join("\n")}</svg>\n`;
  }
}

// As much of a text as fits into a width; "" if that is hardly anything.
function fitted(pen, text, width, size = 12) {
  if (pen.measure(text, size) <= width) return text;
  for (let n = text.length - 1; n > 2; --n) if (pen.measure(text.slice(0, n) + "…", size) <= width) return text.slice(0, n) + "…";
  return "";
}

// Round numbers between low and high, about `count` of them.
function ticks(low, high, count) {
  const rough = (high - low) / Math.max(1, count), power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(k => k * power).find(size => size >= rough * 0.999) || rough;
  const list = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9 && list.length < 50; ++i) list.push(+(i * step).toPrecision(12));
  return list;
}
// Texts that tell the ticks apart; far from zero, all but the first are relative to the first.
function tickTexts(list) {
  const step = list.length > 1 ? list[1] - list[0] : Math.abs(list[0]) || 1, most = Math.max(...list.map(Math.abs));
  const digits = Math.max(1, Math.ceil(Math.log10(most / step + 1)) + 1);
  if (most < 1e6 && step >= 1) return list.map(v => String(v).replace("-", "−"));
  if (digits <= 5) return list.map(v => number(v, digits));
  return list.map((v, i) => i ? "+" + number(v - list[0], 3) : number(v, 4));
}
function timeTicks(a, b, count) {
  const rough = (b - a) / Math.max(1, count);
  const step = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800].find(size => size >= rough) || 3600;
  const list = [];
  for (let i = Math.ceil(a / step - 1e-9); i * step <= b + 1e-9; ++i) list.push(i * step);
  return { list, text: s => b < 60 ? +s.toFixed(2) + " s" : Math.floor(s / 60 + 1e-9) + ":" + String(+(s - 60 * Math.floor(s / 60 + 1e-9)).toFixed(2)).padStart(2, "0") };
}
