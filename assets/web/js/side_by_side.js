// Playing two runs side by side: rows move together, and the show waits at the first difference.
import { isBusy, send } from "./bus.js";
import { onChange } from "./page.js";

const PACE = 1100; // ms a row
let playing = 0;
let paused = false; // at the first difference, once

const stage = () => document.querySelector("#sbs");
const at = () => Number(stage()?.dataset.row ?? 0);
const rows = () => Number(stage()?.dataset.rows ?? 0);
const split = () => Number(stage()?.dataset.split ?? -1);

function go(row) {
  const view = stage();
  const target = Math.min(Math.max(row, 0), rows() - 1);
  if (!view || target === at() || isBusy()) return;
  view.dataset.row = target;
  for (const cell of view.querySelectorAll(".ln[data-row]"))
    cell.classList.toggle("here", Number(cell.dataset.row) === target);
  send("row", { row: target, left: view.dataset.left, right: view.dataset.right });
}

function stop() {
  clearInterval(playing);
  playing = 0;
  label();
}

function label() {
  const words = document.querySelector(".play span");
  if (words) words.textContent = playing ? "Pause" : "Play";
}

function play() {
  if (playing) {
    stop();
    return;
  }
  if (at() >= rows() - 1) {
    paused = false;
    go(0);
  }
  playing = setInterval(() => {
    if (isBusy()) return;
    if (at() === split() && !paused) {
      paused = true;
      stop();
      return;
    }
    if (at() >= rows() - 1) stop();
    else go(at() + 1);
  }, PACE);
  label();
}

const DO = {
  play,
  first: () => go(0),
  back: () => go(at() - 1),
  forward: () => go(at() + 1),
  split: () => split() >= 0 && go(split()),
};

/** Do what a control of the comparison asks for. */
export const sideDo = (what) => DO[what]?.();

/** React to a key while two runs are shown. */
export function sideKeys(event) {
  const act = {
    ArrowLeft: DO.back,
    ArrowRight: DO.forward,
    Home: DO.first,
    End: () => go(rows() - 1),
    " ": play,
    v: DO.split,
    V: DO.split,
    Escape: () => send("choose", { as: "me" }),
  }[event.key];
  if (!act || (event.key === " " && event.target.closest?.("button:not(.play)"))) return;
  event.preventDefault();
  act();
}

document.addEventListener("click", (event) => {
  const cell = event.target.closest?.(".ln[data-row]");
  if (cell && stage()?.dataset.running !== "true") go(Number(cell.dataset.row));
});

let scroll = 0;
document.addEventListener("scroll", (event) => {
  if (event.target.classList?.contains("stage")) scroll = event.target.scrollTop;
}, true);

let seen = null;
onChange(() => {
  const view = stage();
  if (!view || view === seen) return;
  seen = view;
  const pane = view.querySelector(".stage");
  pane.scrollTop = scroll;
  const here = view.querySelector(".ln.here");
  if (here) {
    const over = here.offsetTop + here.offsetHeight - pane.scrollTop - pane.clientHeight;
    if (over > -8) pane.scrollTop += over + 40;
    else if (here.offsetTop - pane.scrollTop < 34) pane.scrollTop = Math.max(0, here.offsetTop - 60);
  }
  if (view.dataset.running === "true") paused = false;
  label();
});
