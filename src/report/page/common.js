// What both pages use: elements, texts, tables, numbers, saving and printing.
const element = (tag, attributes = {}, ...children) => {
  const made = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) if (key.startsWith("on")) made[key] = value; else if (value !== false) made.setAttribute(key, value === true ? "" : value);
  made.append(...children.filter(child => child !== null && child !== undefined));
  return made;
};
const byId = id => document.getElementById(id);
// Controls that the space bar operates, or types into.
const usesSpace = of => of.matches('button, summary, a, select, textarea, input:not([type="range"])');

const letters = n => n < 0 ? "" : letters(Math.floor(n / 26) - 1) + String.fromCharCode(65 + n % 26);
const number = (value, digits = 3) => value === null || value === undefined || Number.isNaN(value) ? "–"
  : (value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e5) ? value.toExponential(1) : String(+value.toPrecision(digits))).replaceAll("-", "−");
const fixed = (value, digits) => value.toFixed(digits).replace(/^-(?=[0.]*$)/, "").replace("-", "−");
// A mean and its standard deviation: two digits of the deviation, and as many decimals of the mean.
const withSd = (mean, sd) => {
  if (!(sd > 0) || sd < 1e-6 || Math.abs(mean) >= 1e5) return number(mean) + (sd > 0 ? " ± " + number(sd, 2) : "");
  const decimals = Math.max(0, Math.min(6, 1 - Math.floor(Math.log10(sd))));
  return `${fixed(mean, decimals)} ± ${fixed(sd, decimals)}`;
};
const percent = (value, digits = 1) => value === null || value === undefined || Number.isNaN(value) ? "–" : fixed(100 * value, digits) + " %";
const signed = text => /^[1-9]|^0\.0*[1-9]/.test(text) ? "+" + text : text;
const plural = (count, word) => count + " " + word + (count === 1 ? "" : "s");

// What is compressed: base64 of zlib.
async function inflate(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream);
}

// Every panel draws anew when show() was called.
const listeners = [];
let changed = 0; // 1: the cursor moved; 2: the time range shown changed; 3: something else, so that all is drawn anew

function show(level = 3) {
  if (changed === 0) requestAnimationFrame(() => { const now = changed; changed = 0; for (const listener of listeners) listener(now); });
  changed = Math.max(changed, level);
}

function save(name, content, type) {
  const link = element("a", { href: URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type })), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const fileStem = (path, other) => (path || other).split("/").pop().replace(/[^\w.-]+/g, "_") || other;
// As in the command's tables: cells that a spreadsheet would take for a formula begin with an apostrophe, and those with a separator of any country are quoted.
const isFormula = cell => /^'*[=+@\t\r-]/.test(cell);
const csvCell = cell => {
  const text = typeof cell === "string" && isFormula(cell) ? "'" + cell : String(cell);
  return /[,;\t"\n\r]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
};
const csvText = rows => rows.map(row => row.map(csvCell).join(",") + "\n").join("");

function table(caption, heads, rows, textColumns = 1) {
  return element("table", {}, caption ? element("caption", {}, caption) : null,
    element("thead", {}, element("tr", {}, ...heads.map((head, i) => element("th", { scope: "col", class: i < textColumns ? "text" : false }, head)))),
    element("tbody", {}, ...rows.map(row => element("tr", {}, ...row.map((cell, i) => i === 0 ? element("th", { scope: "row", class: "text" }, cell) : element("td", { class: i < textColumns ? "text" : false }, cell))))));
}
const scrolled = (node, label) => element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": label }, node);

const shellWord = text => /^[\w+=./:,@%-]+$/.test(text) ? text : "'" + text.replace(/'/g, "'\\''") + "'";

function commandBox(text) {
  const button = element("button", { type: "button" }, "Copy");
  button.onclick = async () => {
    try { await navigator.clipboard.writeText(text); button.textContent = "Copied"; } catch { const range = document.createRange(); range.selectNodeContents(box.firstChild); getSelection().removeAllRanges(); getSelection().addRange(range); button.textContent = "Selected"; }
    setTimeout(() => { button.textContent = "Copy"; }, 1500);
  };
  const box = element("div", { class: "command" }, element("pre", {}, text), button);
  return box;
}

function theme(name) {
  document.documentElement.dataset.theme = name;
  readColors();
  show();
}

function firstTheme() {
  document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  readColors();
}

// Shrinks each of the two printed pages to fit on A4 within its margins of 13 mm, in CSS pixels.
function fitPages(on) {
  const blocks = [document.querySelector("header"), ...byId("main").children], rules = byId("print-rules"), width = 695, height = 1015;
  for (const block of blocks) block.style.zoom = block.style.width = "";
  if (!on) return;
  const second = blocks.findIndex(block => block.classList.contains("page2")), pages = [blocks.slice(0, second), blocks.slice(second)];
  rules.media = "all";
  document.body.style.width = width + "px";
  const scales = pages.map(page => { const boxes = page.map(block => block.getBoundingClientRect()).filter(box => box.height > 0); return boxes.length ? Math.min(1, height / (boxes[boxes.length - 1].bottom - boxes[0].top)) : 1; });
  rules.media = "print";
  document.body.style.width = "";
  pages.forEach((page, i) => { if (scales[i] < 1) for (const block of page) Object.assign(block.style, { zoom: String(scales[i]), width: width + "px" }); });
}

function controlTheme() {
  byId("theme").addEventListener("click", () => theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
  byId("print").addEventListener("click", () => print());
  let shownTheme = "";
  addEventListener("beforeprint", () => {
    printing = true;
    play(false);
    shownTheme = document.documentElement.dataset.theme;
    document.documentElement.dataset.theme = "light";
    readColors();
    for (const panel of panels) panel.print(true);
    fitPages(true);
  });
  addEventListener("afterprint", () => { printing = false; for (const panel of panels) panel.print(false); fitPages(false); theme(shownTheme); });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", event => theme(event.matches ? "dark" : "light"));
}

function options(select, list, value) {
  const key = JSON.stringify(list);
  if (select.dataset.key !== key) { select.dataset.key = key; select.replaceChildren(...list.map(([v, text]) => element("option", { value: String(v) }, text))); }
  select.value = String(value);
}
