// The plan in the browser: names on hover, moving the focus, zoom, and things gliding to new places.
import { isStill, onChange } from "./page.js";

const wrap = () => document.querySelector(".roomwrap");
const box = () => document.querySelector(".planbox");
/** The drawing that is visible: wide or narrow. */
export const plan = () =>
  [...document.querySelectorAll(".planbox .plan")].find((drawing) => drawing.clientWidth > 0);

/** Things and furniture one can act on. */
export const spots = () =>
  [...(plan()?.querySelectorAll("[data-oid][data-type]") ?? [])];

/** Return the middle of `spot` on the screen. */
export function middle(spot) {
  const area = (spot.querySelector(".halo, .frontbox, .appliance") ?? spot).getBoundingClientRect();
  return { x: area.x + area.width / 2, y: area.y + area.height / 2, area };
}

/** Return what is at or near a point: within `reach` pixels the nearest, things before furniture. */
export function nearestSpot(x, y, reach) {
  let best = null;
  let least = reach;
  for (const spot of spots()) {
    if (!spot.classList.contains("thing")) continue;
    const at = middle(spot);
    const away = Math.max(0, Math.hypot(at.x - x, at.y - y) - at.area.width / 2);
    if (away < least) [best, least] = [spot, away];
  }
  return best;
}

// ---- names

function showTip(spot) {
  hideTip();
  const host = wrap();
  if (!host || !spot.dataset.name) return;
  const tip = document.createElement("div");
  tip.className = "tip";
  const parts = [spot.dataset.name, spot.dataset.place, spot.dataset.states].filter(Boolean);
  tip.textContent = parts.join(" · ");
  host.append(tip);
  const at = middle(spot);
  const frame = host.getBoundingClientRect();
  const half = tip.offsetWidth / 2 + 4;
  const left = Math.min(Math.max(at.x - frame.x, half), frame.width - half);
  let top = at.area.bottom - frame.y + 7;
  if (top + tip.offsetHeight > frame.height) top = at.area.top - frame.y - tip.offsetHeight - 7;
  tip.style.left = `${left}px`;
  tip.style.top = `${top}px`;
}

const hideTip = () => document.querySelector(".tip")?.remove();

document.addEventListener("pointerover", (event) => {
  if (event.pointerType === "touch") return;
  const spot = event.target.closest?.(".plan [data-oid][data-name]");
  if (spot && !document.querySelector(".menu")) showTip(spot);
  else if (!spot) hideTip();
});
document.addEventListener("focusin", (event) => {
  const spot = event.target.closest?.(".plan [data-oid][data-name]");
  if (spot) showTip(spot);
  else hideTip();
});
let press = 0;
document.addEventListener("touchstart", (event) => {
  const touch = event.touches[0];
  clearTimeout(press);
  if (!event.target.closest?.(".plan") || event.touches.length > 1) return;
  press = setTimeout(() => {
    const spot = nearestSpot(touch.clientX, touch.clientY, 22);
    if (spot) showTip(spot);
  }, 500);
}, { passive: true });
for (const end of ["touchend", "touchmove"]) document.addEventListener(end, () => clearTimeout(press), { passive: true });

// ---- focus

const ARROWS = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };
let focused = "";

function rove() {
  const all = spots();
  if (!all.length) return;
  const current = all.find((spot) => spot.dataset.oid === focused) ?? all.find((spot) => spot.classList.contains("thing")) ?? all[0];
  for (const spot of all) spot.setAttribute("tabindex", spot === current ? "0" : "-1");
}

document.addEventListener("keydown", (event) => {
  const way = ARROWS[event.key];
  const from = event.target.closest?.(".plan [data-oid][data-type]");
  if (!way || !from) return;
  event.preventDefault();
  const here = middle(from);
  let best = null;
  let least = Infinity;
  for (const spot of spots()) {
    if (spot === from) continue;
    const at = middle(spot);
    const along = (at.x - here.x) * way[0] + (at.y - here.y) * way[1];
    const aside = Math.abs((at.x - here.x) * way[1]) + Math.abs((at.y - here.y) * way[0]);
    if (along < 4) continue;
    const cost = along + 2 * aside;
    if (cost < least) [best, least] = [spot, cost];
  }
  if (best) focusSpot(best);
});

/** Give the focus to `spot`. */
export function focusSpot(spot) {
  focused = spot.dataset.oid;
  rove();
  spot.focus();
}

// ---- zoom

let zoom = { scale: 1, x: 0, y: 0 };

function applyZoom() {
  const host = box();
  if (!host) return;
  const frame = wrap().getBoundingClientRect();
  const limit = (size) => (zoom.scale - 1) * size;
  zoom.x = Math.min(0, Math.max(-limit(frame.width), zoom.x));
  zoom.y = Math.min(0, Math.max(-limit(frame.height), zoom.y));
  host.style.transform = zoom.scale === 1 ? "" : `translate(${zoom.x}px,${zoom.y}px) scale(${zoom.scale})`;
  wrap().classList.toggle("zoomed", zoom.scale > 1);
}

/** Zoom by a factor around a point of the screen (the middle if none is given). */
export function zoomBy(factor, at) {
  const frame = wrap().getBoundingClientRect();
  const x = (at?.x ?? frame.x + frame.width / 2) - frame.x;
  const y = (at?.y ?? frame.y + frame.height / 2) - frame.y;
  const scale = Math.min(3, Math.max(1, zoom.scale * factor));
  const ratio = scale / zoom.scale;
  zoom = { scale, x: x - (x - zoom.x) * ratio, y: y - (y - zoom.y) * ratio };
  hideTip();
  applyZoom();
}

let drag = null;
let fingers = new Map();
document.addEventListener("pointerdown", (event) => {
  if (!event.target.closest?.(".planbox")) return;
  fingers.set(event.pointerId, event);
  if (zoom.scale > 1) drag = { x: event.clientX - zoom.x, y: event.clientY - zoom.y, far: false, fromX: event.clientX, fromY: event.clientY };
});
document.addEventListener("pointermove", (event) => {
  if (fingers.has(event.pointerId) && fingers.size === 2) {
    const before = [...fingers.values()];
    fingers.set(event.pointerId, event);
    const after = [...fingers.values()];
    const span = ([one, other]) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
    const at = { x: (after[0].clientX + after[1].clientX) / 2, y: (after[0].clientY + after[1].clientY) / 2 };
    if (span(before) > 0) zoomBy(span(after) / span(before), at);
    return;
  }
  if (!drag) return;
  if (Math.hypot(event.clientX - drag.fromX, event.clientY - drag.fromY) > 5) drag.far = true;
  if (!drag.far) return;
  zoom.x = event.clientX - drag.x;
  zoom.y = event.clientY - drag.y;
  box()?.classList.add("dragging");
  applyZoom();
});
for (const end of ["pointerup", "pointercancel"])
  document.addEventListener(end, (event) => {
    fingers.delete(event.pointerId);
    box()?.classList.remove("dragging");
    justDragged = Boolean(drag?.far);
    drag = null;
  });
let justDragged = false;
/** Whether the click that follows ended a drag, and so chooses nothing. */
export const endedDrag = () => justDragged;

// ---- gliding

let places = new Map();

function glide() {
  const drawing = plan();
  if (!drawing) return;
  const now = new Map();
  for (const moving of drawing.querySelectorAll("g[transform][data-oid]")) {
    const spot = moving.getAttribute("transform").match(/translate\((\S+) (\S+)\)/);
    if (spot) now.set(moving.dataset.oid, { x: Number(spot[1]), y: Number(spot[2]), moving });
  }
  if (places.drawing === drawing) return;
  const animated = !isStill() && places.room === drawing.getAttribute("aria-label");
  for (const [key, { x, y, moving }] of now) {
    const before = places.get(key);
    if (!animated || !before || (before.x === x && before.y === y)) continue;
    moving.animate(
      [{ transform: `translate(${before.x}px,${before.y}px)` }, { transform: `translate(${x}px,${y}px)` }],
      { duration: 160, easing: "ease-out" },
    );
  }
  places = now;
  places.drawing = drawing;
  places.room = drawing.getAttribute("aria-label");
}

let lastRoom = "";
onChange(() => {
  const room = plan()?.getAttribute("aria-label") ?? "";
  if (room !== lastRoom) {
    zoom = { scale: 1, x: 0, y: 0 };
    lastRoom = room;
  }
  glide();
  applyZoom();
  rove();
});
