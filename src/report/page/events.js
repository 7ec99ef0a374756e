// Marked postures, and the frames of all other cycles at the same phase.
function findMark(mark) {
  const phase = phaseAt(mark.frame), lists = [[found.cycles, true], [found.repetitions, false]];
  mark.phase = phase;
  mark.found = [{ frame: mark.frame, marked: true }];
  mark.reason = "";
  const [list] = lists.find(([parts]) => containing(parts, mark.frame) >= 0) || [];
  if (!list || Number.isNaN(phase)) { mark.reason = "This posture is outside all cycles and repetitions, so the page has no phase by which to find it elsewhere; the command below may find it."; return mark; }
  const part = list[containing(list, mark.frame)], motion = motionOf(labelOf(part.segment));
  mark.label = labelOf(part.segment);
  partsOf(motion).forEach((other, index) => {
    if (mark.frame >= first(other) && mark.frame < last(other)) return;
    const frame = frameAt(motion, index, phase);
    if (!Number.isNaN(frame)) mark.found.push({ frame, marked: false });
  });
  mark.found.sort((a, b) => a.frame - b.frame);
  return mark;
}
function addMark() {
  const frame = Math.round(state.frame * 10) / 10;
  state.marks.push(findMark({ frame, name: "event" + (state.marks.length + 1) }));
  play(false);
  showMarks();
  show();
}
function showMarks() {
  const place = byId("events");
  const intro = element("p", { class: "hint" }, `Move to a moment${body.kind === "columns" ? "" : ", such as a heel strike"}, and press “Mark this posture” (or M${body.kind === "columns" ? "" : ", or double-click the body"}). The page finds the same phase in every other cycle. For the exact answer, with confidence, run the command that appears below.`);
  const boxes = state.marks.map((mark, i) => element("div", { class: "event" },
    element("div", { class: "row" }, element("label", {}, "Name", element("input", { type: "text", value: mark.name, oninput: event => { mark.name = event.target.value || "event"; showCommand(); choices(); } })),
      element("button", { type: "button", onclick: () => seek(mark.frame) }, `Go to ${time(mark.frame)}`),
      element("button", { type: "button", onclick: () => { state.marks.splice(i, 1); state.zero = 0; showMarks(); show(); } }, "Remove")),
    element("p", { class: "facts" }, mark.reason || `Phase ${percent(mark.phase)} of ${mark.label}; ${mark.found.length} found: ` + mark.found.slice(0, 12).map(event => time(event.frame)).join(", ") + (mark.found.length > 12 ? ", …" : ""))));
  const command = element("div");
  const showCommand = () => command.replaceChildren(...(state.marks.length ? [element("p", { class: "facts" }, "The exact answer, with confidence (add more clips to find the event in them, too):"), commandBox(`stltsa events ${clipWord()}${flagWords("events")}${state.marks.map(mark => " --mark " + shellWord(`${mark.frame}=${mark.name}`)).join("")}`)] : []));
  byId("s-events").classList.toggle("nothing", !state.marks.length); // not printed
  place.replaceChildren(intro, ...boxes, command);
  showCommand();
}
