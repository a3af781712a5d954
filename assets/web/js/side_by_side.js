// Playing two runs side by side: rows move together, and the show waits at the first difference.
import { isBusy, send } from "./bus.js";
import { onChange } from "./page.js";

const PACE = 1100; // ms a row
let playing = 0;
let paused = false; // at the first difference, once
let wanted = null; // the row asked for while an answer was still to come

const stage = () => document.querySelector("#sbs");
const at = () => Number(stage()?.dataset.row ?? 0);
const rows = () => Number(stage()?.dataset.rows ?? 0);
const split = () => Number(stage()?.dataset.split ?? -1);

function go(row) {
  const view = stage();
  const target = Math.min(Math.max(row, 0), rows() - 1);
  if (!view || target === at()) return;
  mark(view, target);
  if (isBusy()) wanted = target;
  else ask(view, target);
}

function mark(view, row) {
  view.dataset.row = row;
  for (const cell of view.querySelectorAll(".ln[data-row]"))
    cell.classList.toggle("here", Number(cell.dataset.row) === row);
}

const ask = (view, row) =>
  send("row", { row, left: view.dataset.left, right: view.dataset.right });

/** Go where keys pressed during the last answer asked to: only the last of them counts. */
function catchUp(view) {
  if (wanted === null || isBusy()) return;
  const row = Math.min(wanted, rows() - 1);
  wanted = null;
  if (!view || row === at()) return;
  mark(view, row);
  ask(view, row);
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

// ---- presenting: the whole screen, verdicts at the end

const root = document.documentElement;

function present() {
  const on = root.dataset.present !== "on";
  root.dataset.present = on ? "on" : "";
  if (on) {
    root.requestFullscreen?.().catch(() => {}); // a browser may refuse; the page is enough
    paused = false;
    go(0);
  } else if (document.fullscreenElement) {
    document.exitFullscreen();
  }
}
document.addEventListener("fullscreenchange", () => {
  if (!document.fullscreenElement) root.dataset.present = "";
});

// ---- guessing: votes stay in this browser, by episode

const votes = new Map();
const votesOf = (episode) => votes.get(episode) ?? new Map();

function showVotes() {
  const panel = document.querySelector(".guess");
  if (!panel) return;
  const mine = votesOf(panel.dataset.of);
  for (const button of panel.querySelectorAll("[data-guess]")) {
    const words = mine.get(button.dataset.guess) ? String(mine.get(button.dataset.guess)) : "";
    const shown = button.querySelector(".votes");
    if (shown.textContent !== words) shown.textContent = words;
  }
  const meant = panel.dataset.meant;
  if (!meant) return;
  const all = [...mine.values()].reduce((sum, count) => sum + count, 0);
  panel.hidden = all === 0;
  const words = `${mine.get(meant) ?? 0} of ${all} guessed it.`;
  const tally = panel.querySelector(".tally");
  if (tally.textContent !== words) tally.textContent = words;
}
document.addEventListener("click", (event) => {
  const button = event.target.closest?.("[data-guess]");
  if (!button) return;
  const episode = button.closest(".guess").dataset.of;
  const mine = new Map(votesOf(episode));
  mine.set(button.dataset.guess, (mine.get(button.dataset.guess) ?? 0) + 1);
  votes.set(episode, mine);
  showVotes();
});

const DO = {
  play,
  present,
  unguess: () => {
    votes.clear();
    showVotes();
  },
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
    p: DO.present,
    P: DO.present,
    Escape: () => (root.dataset.present === "on" ? present() : send("choose", { as: "me" })),
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
  catchUp(view);
  if (!view && root.dataset.present === "on") present();
  showVotes();
  view?.classList.toggle("ended", at() >= rows() - 1);
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
