// Looking at points in three dimensions: x to the right, y up, z to the viewer.
const camera = { yaw: 0.5, pitch: 0.16, zoom: 1 };

function projection(target, w, h, scale, size, flat = false) {
  const cy = Math.cos(camera.yaw), sy = Math.sin(camera.yaw), cp = Math.cos(camera.pitch), sp = Math.sin(camera.pitch), far = 7 * size;
  return p => {
    const x = p[0] - target[0], y = p[1] - target[1], z = p[2] - target[2];
    const right = x * cy + z * sy, back = -x * sy + z * cy, up = y * cp - back * sp, near = y * sp + back * cp;
    const k = scale * (flat ? 1 : far / Math.max(far * 0.2, far - near));
    return [w / 2 + right * k, h / 2 - up * k, near];
  };
}

function drawGrid(pen, project, target, size, ground) {
  const rough = size / 2, power = 10 ** Math.floor(Math.log10(rough)), step = [1, 2, 5, 10].map(k => k * power).find(s => s >= rough);
  const reach = 7, [cx, cz] = [0, 2].map(a => Math.round(target[a] / step));
  const fade = i => Math.max(0, 1 - Math.abs(i) / (reach + 0.5));
  for (let i = -reach; i <= reach; ++i)
    for (const turn of [false, true]) {
      const ends = [-reach, 0, reach].map(j => project(turn ? [(cx + j) * step, ground, (cz + i) * step] : [(cx + i) * step, ground, (cz + j) * step]));
      pen.line(ends.flatMap(p => [p[0], p[1]]), { stroke: colors.line, alpha: fade(i) });
    }
}

// Turning and zooming by pointer, touch, wheel and keys; pick(x, y) answers a click.
function orbit(canvas, flat, pick) {
  const pointers = new Map();
  let dragged = 0;
  canvas.style.touchAction = "pan-y";
  canvas.style.cursor = "grab";
  canvas.onpointerdown = event => { pointers.set(event.pointerId, [event.clientX, event.clientY]); canvas.setPointerCapture(event.pointerId); dragged = 0; };
  canvas.onpointermove = event => {
    const from = pointers.get(event.pointerId);
    if (!from) return;
    const dx = event.clientX - from[0], dy = event.clientY - from[1];
    dragged += Math.abs(dx) + Math.abs(dy);
    if (pointers.size === 2) {
      const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
      camera.zoom = Math.max(0.3, Math.min(6, camera.zoom * Math.hypot(event.clientX - other[0], event.clientY - other[1]) / Math.max(1, Math.hypot(from[0] - other[0], from[1] - other[1]))));
    } else if (!flat) { camera.yaw -= dx * 0.008; camera.pitch = Math.max(-0.3, Math.min(1.5, camera.pitch + dy * 0.006)); }
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    show(1);
  };
  canvas.onpointerup = canvas.onpointercancel = event => {
    pointers.delete(event.pointerId);
    if (dragged > 5 || event.type === "pointercancel") return;
    const box = canvas.getBoundingClientRect();
    pick(event.clientX - box.left, event.clientY - box.top);
  };
  canvas.addEventListener("wheel", event => { if (!event.ctrlKey) return; event.preventDefault(); camera.zoom = Math.max(0.3, Math.min(6, camera.zoom * Math.exp(-event.deltaY / 300))); show(1); }, { passive: false });
  canvas.onkeydown = event => {
    const turn = { ArrowLeft: [0.15, 0], ArrowRight: [-0.15, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
    if (!turn || flat) return;
    event.preventDefault();
    camera.yaw += turn[0]; camera.pitch = Math.max(-0.3, Math.min(1.5, camera.pitch + turn[1]));
    show(1);
  };
}

const viewTools = () => [
  element("button", { type: "button", "aria-label": "Turn the view by 90 degrees", title: "Turn by 90°", onclick: () => { camera.yaw += Math.PI / 2; show(1); } }, "↻ 90°"),
  element("button", { type: "button", "aria-label": "Larger", onclick: () => { camera.zoom = Math.min(6, camera.zoom * 1.2); show(1); } }, "+"),
  element("button", { type: "button", "aria-label": "Smaller", onclick: () => { camera.zoom = Math.max(0.3, camera.zoom / 1.2); show(1); } }, "−")];
