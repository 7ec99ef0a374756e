// SPDX-License-Identifier: BSD-3-Clause
// Checks reports in a browser; see tests/report/check.
"use strict";
const fs = require("fs");
const path = require("path");
const { chromium } = require("playwright-core");
const puppeteer = require("puppeteer-core");
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

const [folder, ...reports] = process.argv[3] === "--picture" ? [process.argv[2]] : process.argv.slice(2);
let failures = 0;
function check(holds, what) {
  console.log(`  ${holds ? "ok  " : "FAIL"} ${what}`);
  if (!holds) failures += 1;
}

// The bytes of a report and of its parts: code, postures, results, curves and mean cycles.
function bytesByPart(report) {
  const page = fs.readFileSync(report, "utf8"), text = page.match(/id="data">\n([^]*?)<\/script>/)[1];
  const bytes = of => Buffer.byteLength(of), part = key => key in data ? bytes(JSON.stringify(data[key])) : 0;
  const data = JSON.parse(text);
  const parts = { code: bytes(page) - bytes(text), postures: part("body"), results: part("decomposition") + part("comparison"), curves: part("curve") + part("phase"), "mean cycles": part("motions") };
  return `${bytes(page)} bytes: ` + Object.entries(parts).map(([name, size]) => `${name} ${size}`).join(", ");
}

const pixels = (page, id, layer) => page.evaluate(([name, at]) => document.querySelectorAll(`#${name} canvas`)[at].toDataURL().length + document.querySelectorAll(`#${name} canvas`)[at].toDataURL().slice(-4000), [id, layer]);

// A page with the report, its requests and its console messages.
async function opened(browser, report, { width = 1240, colorScheme = "light", hasTouch = false } = {}) {
  const page = await browser.newPage({ viewport: { width, height: width < 600 ? 844 : 900 }, colorScheme, hasTouch, acceptDownloads: true });
  const told = [];
  page.on("request", request => { if (!/^(data|blob):/.test(request.url()) && request.url() !== "file://" + report) told.push("request " + request.url()); });
  page.on("console", message => told.push(message.type() + " " + message.text()));
  page.on("pageerror", error => told.push("error " + error.message));
  await page.goto("file://" + report);
  await page.waitForSelector("html[data-ready]");
  return { page, told };
}

// Whether the condition holds within three seconds.
async function comes(page, holds) {
  for (let i = 0; i < 30; ++i) {
    if (await holds()) return true;
    await page.waitForTimeout(100);
  }
  return false;
}

// First paint, playing and seeking, which both pages have.
async function checkPlaying(page) {
  const timing = await page.evaluate(() => ({ paint: performance.getEntriesByName("first-contentful-paint")[0].startTime, ready: performance.now() }));
  check(timing.paint < 1000, `first paint after ${timing.paint.toFixed(0)} ms (ready after ${timing.ready.toFixed(0)} ms)`);
  const clock = () => page.locator("#clock").textContent();
  const moving = await page.locator("#viewer canvas").count() ? "viewer" : "curves";
  const before = await clock(), picture = await pixels(page, moving, 1);
  await page.click("#play");
  const rate = await page.evaluate(() => new Promise(done => {
    let count = 0;
    const begin = performance.now();
    const step = () => { count += 1; if (performance.now() - begin > 2000) done(count / 2); else requestAnimationFrame(step); };
    requestAnimationFrame(step);
  }));
  check(rate > 10, `plays at ${rate.toFixed(0)} frames per second (software rendering)`);
  await page.click("#play");
  check(await clock() !== before && await pixels(page, moving, 1) !== picture, "playing moves the picture");
  const cost = await page.evaluate(async () => {
    const scrub = document.getElementById("scrub"), begin = performance.now();
    for (let i = 0; i < 60; ++i) {
      scrub.value = String(i / 60 * scrub.max);
      scrub.dispatchEvent(new Event("input"));
      await new Promise(requestAnimationFrame);
    }
    return (performance.now() - begin) / 60;
  });
  check(cost < 100, `seeking takes ${cost.toFixed(1)} ms per step`);
}

// Downloads, accessibility, and what the page asked for or said.
async function checkRest(page, told, ids, format) {
  for (const id of ["save-json", ...ids]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click("#" + id)]);
    const file = path.join(folder, download.suggestedFilename());
    await download.saveAs(file);
    check(fs.statSync(file).size > 50, `${download.suggestedFilename()} is saved`);
    if (id === "save-json") {
      const saved = JSON.parse(fs.readFileSync(file, "utf8"));
      const written = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent).decomposition);
      check(saved.format.startsWith(format), `it is ${format}`);
      if (written) check(JSON.stringify(saved) === JSON.stringify(written), "it is what the library wrote");
    }
  }
  for (const [kind, magic] of [["SVG", "<svg"], ["PNG", "\x89PNG"]]) {
    await page.reload(); // Chromium blocks the eleventh download of a page
    await page.waitForSelector("html[data-ready]");
    for (const button of await page.locator("figcaption button", { hasText: kind }).all()) {
      if (!await button.isVisible()) continue;
      const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
      const file = path.join(folder, download.suggestedFilename());
      await download.saveAs(file);
      check(fs.readFileSync(file, "latin1").startsWith(magic), `${download.suggestedFilename()} is a ${kind}`);
    }
  }
  for (const details of await page.locator("details > summary").all()) await details.click();
  await page.evaluate(axe);
  for (const theme of ["light", "dark"]) {
    if (theme === "dark") await page.click("#theme");
    const found = (await page.evaluate(() => axe.run())).violations.filter(one => ["serious", "critical"].includes(one.impact));
    check(found.length === 0, `accessible in the ${theme} theme` + found.map(one => ` (${one.id}: ${one.nodes[0].target})`).join(""));
  }
  check(told.length === 0, "no request, nothing on the console" + told.map(text => " (" + text + ")").join(""));
  await page.close();
}

async function checkReport(page) {
  const clock = () => page.locator("#clock").textContent();
  await page.locator("#band canvas").last().focus();
  await page.keyboard.press("Home");
  check(await comes(page, async () => /frame 0$/.test(await clock())), "Home goes to the first frame");
  await page.keyboard.press("ArrowRight");
  check(await comes(page, async () => /frame 1$/.test(await clock())), "an arrow key goes one frame on");
  const view = await pixels(page, "band", 0);
  await page.keyboard.press("+");
  check(await comes(page, async () => await pixels(page, "band", 0) !== view), "+ zooms the recording");
  const zooming = await page.evaluate(async () => {
    scrollTo(0, 0); // the loop is on the screen, too
    const band = document.querySelectorAll("#band canvas")[1], begin = performance.now();
    for (const key of "++++----") {
      band.dispatchEvent(new KeyboardEvent("keydown", { key }));
      await new Promise(requestAnimationFrame);
      await new Promise(requestAnimationFrame);
    }
    return (performance.now() - begin) / 8;
  });
  check(zooming < 300, `zooming takes ${zooming.toFixed(0)} ms per step`);
  await page.keyboard.press("0");
  await page.mouse.move(0, 0);
  await page.locator("#band canvas").last().scrollIntoViewIfNeeded();
  const box = await page.locator("#band canvas").last().boundingBox();
  await page.mouse.click(box.x + box.width * 0.5, box.y + 75);
  check(await comes(page, async () => !/frame 1$/.test(await clock())), "a click on the recording goes there");
  await page.locator("#scrub").focus(); // controls keep only the keys that they use
  await page.keyboard.press("m");
  if (await page.locator("#mark").isVisible()) check(await page.locator(".event").count() === 1 && /stltsa events .* --mark/.test(await page.locator("#events pre").textContent()), "m marks an event, and its command is shown");
}

async function checkComparison(page) {
  const part = () => page.locator("#part").inputValue();
  const count = await page.locator("#part option").count(), first = await part();
  await page.locator("#intervals canvas").last().focus();
  await page.keyboard.press("ArrowDown");
  if (count > 1) check(await comes(page, async () => await part() !== first), "an arrow key in the list of differences chooses the next part");
  const picture = await pixels(page, "curves", 0);
  await page.locator("#part").selectOption({ index: count - 1 }); // neighbors may have the same curves
  if (count > 1) check(await comes(page, async () => await pixels(page, "curves", 0) !== picture), "choosing a part shows its curves");
  const apart = page.locator("#viewer button", { hasText: "Apart" });
  if (await apart.count()) {
    const together = await pixels(page, "viewer", 1);
    await apart.click();
    check(await comes(page, async () => await pixels(page, "viewer", 1) !== together), "Apart moves the bodies apart");
  }
  const clock = () => page.locator("#clock").textContent(), before = await clock();
  await page.locator("#curves canvas").last().scrollIntoViewIfNeeded();
  const box = await page.locator("#curves canvas").last().boundingBox();
  await page.mouse.click(box.x + 70, box.y + 80);
  check(await comes(page, async () => await clock() !== before), "a click on a curve goes to that phase");
}

async function checkUse(browser, report) {
  const { page, told } = await opened(browser, report);
  const compared = await page.evaluate(() => /comparison/.test(document.title));
  await checkPlaying(page);
  await (compared ? checkComparison(page) : checkReport(page));
  await (compared ? checkRest(page, told, ["save-csv", "save-curves"], "stltsa-comparison") : checkRest(page, told, ["save-csv"], "stltsa-decomposition"));
}

// Two fingers that move apart by this much to each side.
async function pinch(page, id, far) {
  await page.locator("#" + id).scrollIntoViewIfNeeded();
  const box = await page.locator(`#${id} canvas`).last().boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
  const session = await page.context().newCDPSession(page), send = (type, off) => session.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x: x - off, y, id: 0 }, { x: x + off, y, id: 1 }] });
  await send("touchStart", 20);
  for (let k = 1; k <= 8; ++k) await send("touchMove", 20 + far * k / 8);
  await send("touchEnd", 0);
}

async function checkTouch(browser, report) {
  const { page } = await opened(browser, report, { width: 390, hasTouch: true });
  if (await page.locator("#viewer canvas").count()) {
    const picture = await pixels(page, "viewer", 1);
    await pinch(page, "viewer", 60);
    const space = await page.locator("#viewer button", { hasText: "+" }).count() > 0;
    if (space) check(await comes(page, async () => await pixels(page, "viewer", 1) !== picture), "two fingers make the body larger");
  }
  if (await page.locator("#band canvas").count()) {
    const view = await pixels(page, "band", 0);
    await pinch(page, "band", 60);
    check(await comes(page, async () => await pixels(page, "band", 0) !== view), "two fingers zoom the recording");
  }
  await page.close();
}

async function checkFirefox(browser, report) {
  const page = await browser.newPage(), told = [];
  await page.setViewport({ width: 1240, height: 900 });
  page.on("console", message => told.push(message.type() + " " + message.text()));
  page.on("pageerror", error => told.push("error " + error.message));
  page.on("request", request => { if (!/^data:/.test(request.url()) && request.url() !== "file://" + report) told.push("request " + request.url()); });
  await page.goto("file://" + report);
  await page.waitForSelector("html[data-ready]");
  const clock = () => page.$eval("#clock", node => node.textContent), before = await clock();
  await page.click("#play");
  let moved = false;
  for (let i = 0; i < 30 && !moved; ++i) { await new Promise(done => setTimeout(done, 100)); moved = await clock() !== before; }
  check(moved, "plays in Firefox");
  check(told.length === 0, "no request, nothing on the console of Firefox" + told.map(text => " (" + text + ")").join(""));
  await page.screenshot({ path: path.join(folder, path.basename(report, ".html") + "-firefox.png") });
  await page.close();
}

async function checkPrint(browser, report, name) {
  const { page } = await opened(browser, report);
  const pdf = await page.pdf({ format: "A4", preferCSSPageSize: true, path: path.join(folder, name + ".pdf") });
  const count = (pdf.toString("latin1").match(/\/Type\s*\/Page\b/g) || []).length;
  check(count <= 2, `prints on ${count} pages`);
  await page.close();
}

async function shoot(browser, report, name) {
  for (const width of [1240, 1024, 768, 390])
    for (const colorScheme of ["light", "dark"]) {
      const { page, told } = await opened(browser, report, { width, colorScheme });
      const high = await page.evaluate(() => document.documentElement.scrollHeight);
      check(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `fits a width of ${width}`);
      await page.setViewportSize({ width, height: Math.min(high, 8000) });
      await page.waitForTimeout(800);
      await page.screenshot({ path: path.join(folder, `${name}-${width}-${colorScheme}.png`) });
      check(told.length === 0, `nothing on the console at ${width}, ${colorScheme}` + told.join(" "));
      await page.close();
    }
}

(async () => {
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: process.getuid() === 0 ? ["--no-sandbox"] : [] });
  if (process.argv[3] === "--picture") {
    const { page } = await opened(browser, path.resolve(process.argv[4]));
    await page.setViewportSize({ width: 1240, height: 1130 });
    await page.waitForTimeout(800);
    await page.screenshot({ path: process.argv[5] });
    return browser.close();
  }
  for (const report of reports.map(name => path.resolve(name))) {
    const name = path.basename(report, ".html");
    console.log(`${report}: ${bytesByPart(report)}`);
    for (const checks of [checkUse, checkTouch, checkPrint, shoot])
      try { await checks(browser, report, name); } catch (error) { check(false, `${checks.name}: ${error.message.split("\n")[0]}`); }
  }
  await browser.close();
  const firefox = "/usr/bin/firefox-esr";
  if (fs.existsSync(firefox)) {
    const other = await puppeteer.launch({ browser: "firefox", executablePath: firefox, headless: true });
    console.log(await other.version());
    for (const report of reports) await checkFirefox(other, path.resolve(report));
    await other.close();
  } else console.log("firefox-esr is not installed: not checked in Firefox");
  console.log(failures ? `${failures} checks failed` : "all checks passed");
  process.exit(failures ? 1 : 0);
})();
