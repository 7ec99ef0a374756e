// A figure: one canvas for what rarely changes, and another above it for what follows the cursor.
const panels = [];

class Panel {
  // of: { title, more, label, height(width), base(pen, w, h), over(pen, w, h), tools: [elements], zooms: the base shows the time range }
  constructor(id, of) {
    this.of = of;
    this.id = id;
    this.under = element("canvas", { "aria-hidden": "true" });
    this.canvas = element("canvas", { role: "img", tabindex: "0", "aria-label": of.label });
    this.caption = element("span", {});
    this.title(of.title, of.more);
    const button = (text, act) => element("button", { type: "button", onclick: act, "aria-label": `Save “${of.title}” as ${text}` }, text);
    this.figure = element("figure", {},
      element("figcaption", {}, this.caption, element("span", { class: "tools" }, ...(of.tools || []), button("PNG", () => this.savePng()), button("SVG", () => save(`${stem()}-${id}.svg`, this.svg(), "image/svg+xml")))),
      element("div", { class: "stack" }, this.under, this.canvas));
    byId(id).append(this.figure);
    panels.push(this);
    new IntersectionObserver(() => { if (this.stale) this.draw(this.stale); }, { rootMargin: "100px" }).observe(this.figure);
    new ResizeObserver(() => { if (this.figure.clientWidth !== this.width) this.draw(3); }).observe(this.figure);
  }
  title(text, more = "") { this.caption.replaceChildren(element("b", {}, text), more ? " · " + more : ""); }
  size() { return [Math.max(200, this.figure.clientWidth), Math.round(this.of.height(Math.max(200, this.figure.clientWidth)))]; }
  pen(canvas, w, h, density) {
    if (canvas.width !== Math.round(w * density) || canvas.height !== Math.round(h * density)) { canvas.width = Math.round(w * density); canvas.height = Math.round(h * density); }
    const context = canvas.getContext("2d");
    context.setTransform(density, 0, 0, density, 0, 0);
    context.clearRect(0, 0, w, h);
    return new CanvasPen(context);
  }
  visible() { const box = this.figure.getBoundingClientRect(); return box.bottom > -100 && box.top < innerHeight + 100 && box.width > 0; }
  draw(level, density = Math.min(2, devicePixelRatio || 1)) {
    this.stale = Math.max(this.stale || 0, level);
    const [w, h] = this.size();
    this.under.style.height = this.canvas.style.height = h + "px";
    if (!this.visible()) return;
    if (this.stale > (this.of.zooms ? 1 : 2) || w !== this.width || h !== this.height) { this.width = w; this.height = h; this.of.base && this.of.base(this.pen(this.under, w, h, density), w, h); if (!this.of.base) this.pen(this.under, w, h, density); }
    this.of.over && this.of.over(this.pen(this.canvas, w, h, density), w, h);
    if (!this.of.over) this.pen(this.canvas, w, h, density);
    this.stale = 0;
  }
  whole(pen, w, h) { this.of.base && this.of.base(pen, w, h); this.of.over && this.of.over(pen, w, h); return pen; }
  // For printing: the figure as SVG, which is sharp at any size.
  print(on) {
    if (this.printed) this.printed.remove();
    this.printed = null;
    if (!on || !this.figure.clientWidth) return;
    const w = Math.max(220, Math.round(700 * this.figure.clientWidth / document.body.clientWidth)), h = Math.round(this.of.height(w));
    this.printed = element("div", { class: "printed" });
    this.printed.innerHTML = this.whole(new SvgPen(this.id, w, h), w, h).toString(); // all texts are escaped
    this.figure.append(this.printed);
  }
  svg() { const [w, h] = this.size(); return this.whole(new SvgPen(this.id, w, h), w, h).toString(); }
  savePng() {
    const [w, h] = this.size(), canvas = document.createElement("canvas"), pen = this.pen(canvas, w, h, 2);
    pen.rect(0, 0, w, h, { fill: colors.paper });
    this.whole(pen, w, h);
    canvas.toBlob(blob => save(`${stem()}-${this.id}.png`, blob));
  }
}
let printing = false;
const drawAll = level => { for (const panel of panels) panel.draw(level); };
listeners.push(drawAll);

