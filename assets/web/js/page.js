// What the page shows now, read from the document, and what this browser remembers.

const KEY = "reibench-settings";
const root = document.documentElement;

/** The episode and actor on the page. */
export function choice() {
  const shown = document.querySelector("#choice");
  return { episode: shown?.dataset.episode ?? "", actor: shown?.dataset.actor ?? "me" };
}

/** The sitting on the page. */
export function run() {
  const act = document.querySelector("#act");
  if (!act) return {};
  const { sitting = "", expected = "0", over = "false", running = "false" } = act.dataset;
  return {
    sitting,
    expected: Number(expected),
    over: over === "true",
    running: running === "true",
    solution: Boolean(act.querySelector(".solution")),
  };
}

function stored() {
  try {
    return JSON.parse(localStorage.getItem(KEY) ?? "{}");
  } catch {
    return {};
  }
}

/** What this browser remembers and the server should know. */
export function settings() {
  const { model = "", planner = "", method = "" } = stored();
  return { model, planner, method };
}

/** Return one remembered value. */
export const recall = (name, otherwise) => stored()[name] ?? otherwise;

/** Remember one value. */
export function remember(name, value) {
  try {
    localStorage.setItem(KEY, JSON.stringify({ ...stored(), [name]: value }));
  } catch {
    // private windows may refuse; the choice then lasts as long as the page
  }
}

/** Call `react` after every change of the page, once a frame at most. */
export function onChange(react) {
  reactions.push(react);
}

const reactions = [];
let pending = false;

function schedule() {
  if (pending) return;
  pending = true;
  requestAnimationFrame(() => {
    pending = false;
    for (const react of reactions) react();
  });
}

new MutationObserver(schedule).observe(root, { childList: true, subtree: true });

/** Whether `target` is something one types into. */
export const isField = (target) =>
  target instanceof HTMLElement &&
  (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName));

/** Whether the screen is narrow. */
export const isNarrow = () => matchMedia("(max-width:760px)").matches;

/** Whether the visitor asked for less motion. */
export const isStill = () => matchMedia("(prefers-reduced-motion:reduce)").matches;

/** Say `words` to screen readers. */
export function announce(words) {
  const region = document.querySelector("#live");
  if (region && words) region.textContent = words;
}
