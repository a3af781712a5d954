// The page's switchboard: buttons, keys, theme, address, and what follows each answer.
import { isBusy, noteAnswer, send } from "./bus.js";
import { announce, choice, isField, isNarrow, onChange, recall, remember, run, settings } from "./page.js";
import { carryOut, field } from "./picker.js";
import { zoomBy } from "./plan.js";
import "./menu.js";
import { sideKeys, sideDo } from "./side_by_side.js";

const root = document.documentElement;

// ---- theme

function setTheme(theme) {
  root.dataset.theme = theme;
  document.body?.classList.toggle("dark", theme === "dark"); // Gradio's own parts follow
}
const wanted = () => recall("theme", matchMedia("(prefers-color-scheme:dark)").matches ? "dark" : "light");
matchMedia("(prefers-color-scheme:dark)").addEventListener("change", () => setTheme(wanted()));

// ---- switches that outlive an answer

function setMarks(on) {
  root.classList.toggle("show-re", on);
  remember("marks", on);
  syncSwitches();
}
function setNames(on) {
  root.classList.toggle("show-names", on);
  syncSwitches();
}
function setRoom(as) {
  root.dataset.room = as;
  syncSwitches();
}
function syncSwitches() {
  const pressed = (selector, on) => document.querySelector(selector)?.setAttribute("aria-pressed", String(on));
  pressed("[data-do=marks]", root.classList.contains("show-re"));
  pressed("[data-do=names]", root.classList.contains("show-names"));
  for (const tab of document.querySelectorAll("button[data-room]"))
    tab.setAttribute("aria-selected", String(tab.dataset.room === (root.dataset.room ?? "plan")));
  document.querySelector("[data-do=setup]")?.setAttribute("aria-expanded", String(root.dataset.setup === "open"));
  document.querySelector("[data-do=unfold]")?.setAttribute("aria-expanded", String(root.dataset.talk === "open"));
  const keys = document.querySelector("#single-keys");
  if (keys) keys.checked = recall("keys", true);
}
const flip = (name) => {
  root.dataset[name] = root.dataset[name] === "open" ? "" : "open";
  syncSwitches();
};

// ---- buttons

const DO = {
  theme: () => {
    remember("theme", root.dataset.theme === "dark" ? "light" : "dark");
    setTheme(wanted());
  },
  marks: () => setMarks(!root.classList.contains("show-re")),
  names: () => setNames(!root.classList.contains("show-names")),
  "zoom-in": () => zoomBy(1.4),
  "zoom-out": () => zoomBy(1 / 1.4),
  unfold: () => flip("talk"),
  setup: () => flip("setup"),
  shelf: () => {
    flip("shelf");
    if (root.dataset.shelf === "open") {
      send("look");
      document.querySelector(".sheet [data-do=close]")?.focus();
    }
  },
  close: () => {
    root.dataset.shelf = "";
    document.querySelector("[data-do=shelf]")?.focus();
  },
  find: () => {
    root.dataset.finder = "open";
    seek();
    document.querySelector("#finder [data-seek=words]")?.focus();
  },
  "close-finder": () => {
    root.dataset.finder = "";
    document.querySelector("[data-do=find]")?.focus();
  },
  keys: (button) => remember("keys", button.checked),
  shuffle: () => send("choose", { shuffle: Math.floor(Math.random() * 1e6) }),
  again: () => send("again"),
  retry: () => location.reload(),
  solution: () => send("solve", { solution: !run().solution }),
  done: () => !run().over && carryOut("done"),
  watch: () => send("watch"),
  stop: (button) => {
    button.disabled = true;
    button.textContent = "Stopping after this step …";
    send("halt");
  },
  compare: () => send("choose", { as: "side" }),
  leave: () => send("choose", { as: "me" }),
  get: (button) => send("fetch", { wanted: button.dataset.model }),
};

// ---- finding an episode

let seeking = 0;
function seek() {
  const fields = [...document.querySelectorAll("#finder [data-seek]")];
  send("seek", Object.fromEntries(fields.map((field) => [field.dataset.seek, field.value])));
}
document.addEventListener("input", (event) => {
  if (!event.target.dataset?.seek) return;
  clearTimeout(seeking);
  seeking = setTimeout(seek, 120);
});
function openFound(row) {
  root.dataset.finder = "";
  send("choose", { task: row.dataset.open, level: row.dataset.at });
}

document.addEventListener("click", (event) => {
  const row = event.target.closest?.("[data-open]");
  if (row) return openFound(row);
  const button = event.target.closest?.("[data-do]");
  if (button) {
    if (DO[button.dataset.do]) DO[button.dataset.do](button);
    else sideDo(button.dataset.do);
    return;
  }
  const tab = event.target.closest?.("button[data-room]");
  if (tab) setRoom(tab.dataset.room);
  const level = event.target.closest?.("[data-level]");
  if (level && !level.disabled) send("choose", { level: level.dataset.level });
  const actor = event.target.closest?.(".seg [data-actor]");
  if (actor) send("choose", { as: actor.dataset.actor });
  if (root.dataset.shelf === "open" && !event.target.closest?.(".sheet")) root.dataset.shelf = "";
});
document.addEventListener("change", (event) => {
  const what = event.target.dataset?.choose;
  if (!what) return;
  if (["model", "planner", "method"].includes(what)) {
    remember(what, event.target.value);
    send("choose");
  } else if (what === "actor") {
    send("choose", { as: event.target.value });
  } else {
    send("choose", { [what]: event.target.value });
  }
});

// ---- keys

const LETTERS = {
  e: () => DO.marks(),
  n: () => DO.names(),
  p: () => setRoom(root.dataset.room === "list" ? "plan" : "list"),
  "/": () => field()?.focus(),
};
const RADIO_KEYS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowDown: [0, 1], ArrowUp: [0, -1] };

document.addEventListener("keydown", (event) => {
  if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) {
    if (document.querySelector("[data-do=done]")) DO.done();
    return;
  }
  if (event.key === "Escape" && root.dataset.shelf === "open") {
    DO.close();
    return;
  }
  if (event.key === "Escape" && root.dataset.finder === "open") {
    DO["close-finder"]();
    return;
  }
  if (root.dataset.finder === "open" && moveInFound(event)) return;
  const radio = event.target.closest?.("[role=radio]");
  if (radio && RADIO_KEYS[event.key]) {
    event.preventDefault();
    moveRadio(radio, RADIO_KEYS[event.key]);
    return;
  }
  if (isField(event.target) || event.ctrlKey || event.metaKey || event.altKey) return;
  if (choice().actor === "side") {
    sideKeys(event);
    return;
  }
  // participants type: a letter that does something would surprise them
  if (root.dataset.page !== "study" && recall("keys", true) && LETTERS[event.key.toLowerCase()]) {
    event.preventDefault();
    LETTERS[event.key.toLowerCase()]();
  }
});

// arrows go from the field through what was found
function moveInFound(event) {
  if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return false;
  if (event.target.tagName === "SELECT" || !event.target.closest?.("#finder")) return false;
  const stops = [document.querySelector("#finder [data-seek=words]"), ...document.querySelectorAll("#found [data-open]")];
  const at = stops.indexOf(event.target) + (event.key === "ArrowDown" ? 1 : -1);
  stops[Math.max(0, Math.min(stops.length - 1, at))]?.focus();
  event.preventDefault();
  return true;
}

function moveRadio(radio, [x, y]) {
  const group = radio.closest("[role=radiogroup]");
  const all = [...group.querySelectorAll("[role=radio]")];
  const wide = group.classList.contains("lv") ? 3 : all.length;
  const step = wide === 3 ? x + 3 * y : x + y;
  let at = all.indexOf(radio);
  do at = (at + step + all.length) % all.length;
  while (all[at].disabled && all[at] !== radio);
  refocus = all[at].dataset.level ? `[data-level="${all[at].dataset.level}"]` : `.seg [data-actor="${all[at].dataset.actor}"]`;
  all[at].click();
}
let refocus = "";

// ---- after each change

let shown = "";
let told = "";
let askedModel = false;

onChange(() => {
  noteAnswer();
  const { episode, actor } = choice();
  if (actor) root.dataset.actor = actor;
  const chosen = { episode, actor, ...settings() };
  if (episode && JSON.stringify(chosen) !== shown) {
    shown = JSON.stringify(chosen);
    const address = new URL(location.href);
    for (const [name, value] of Object.entries(chosen)) {
      if (value) address.searchParams.set(name, value);
      else address.searchParams.delete(name);
    }
    history.replaceState(null, "", address);
    root.dataset.setup = "";
    root.dataset.talk = "";
  }
  const act = document.querySelector("#act");
  const said = act?.dataset.announce ?? "";
  const outcome = document.querySelector(".act .verdict strong")?.textContent ?? "";
  if (said + outcome !== told) {
    told = said + outcome;
    announce([said, outcome].filter(Boolean).join(" "));
    showRefusal();
  }
  scrollToEnd(".act .stepscroll", `${act?.dataset.sitting} ${act?.dataset.expected} ${act?.dataset.over}`);
  scrollToEnd(".talk", episode);
  showDue(`${act?.dataset.sitting} ${act?.dataset.expected} ${act?.dataset.over}`);
  if (refocus && !isBusy()) {
    document.querySelector(refocus)?.focus();
    refocus = "";
  }
  syncSwitches();
  tick();
});

// on a phone the list of steps is below the room: why something was refused is shown where one is
function showRefusal() {
  document.querySelector(".refusal")?.remove();
  const row = document.querySelector(".act .steps .step.now.fail");
  if (!row || !isNarrow()) return;
  const { top, bottom } = row.getBoundingClientRect();
  if (top >= 0 && bottom <= innerHeight) return;
  const box = document.createElement("p");
  box.className = "refusal";
  box.setAttribute("aria-hidden", "true"); // it has been announced
  box.textContent = row.querySelector("small")?.textContent ?? "";
  document.body.append(box);
  setTimeout(() => box.remove(), 5000);
}

const scrolled = new Map();
function scrollToEnd(selector, version) {
  const pane = document.querySelector(selector);
  if (!pane || (scrolled.get(selector) === version && pane === scrolled.get(pane))) return;
  scrolled.set(selector, version);
  scrolled.set(pane, pane);
  pane.scrollTop = pane.scrollHeight;
}

// the sub-task that is being done, in the middle of a long graph
function showDue(version) {
  const pane = document.querySelector(".made");
  if (!pane || (scrolled.get(".made") === version && scrolled.get(pane) === pane)) return;
  scrolled.set(".made", version);
  scrolled.set(pane, pane);
  const all = pane.querySelectorAll(".node.now, .node.done, .node.failed");
  const due = pane.querySelector(".node.now, .node.failed") ?? all[all.length - 1];
  if (!due) return;
  const [box, frame] = [due.getBoundingClientRect(), pane.getBoundingClientRect()];
  pane.scrollTo({ top: pane.scrollTop + box.top - frame.top - frame.height / 2, behavior: "instant" });
}

// seconds since the model began to think
let clock = 0;
let began = 0;
function tick() {
  const hand = document.querySelector(".clock");
  if (hand && !clock) {
    began = performance.now();
    clock = setInterval(() => {
      const now = document.querySelector(".clock");
      if (now) now.textContent = `${Math.round((performance.now() - began) / 1000)} s`;
    }, 1000);
  } else if (!hand && clock) {
    clearInterval(clock);
    clock = 0;
  } else if (hand && !hand.textContent) {
    began = performance.now();
  }
}

// ---- what an expression stands for, shown in the room

document.addEventListener("pointerover", (event) => {
  const said = event.target.closest?.(".re[data-type]");
  for (const spot of document.querySelectorAll(".plan .meant")) spot.classList.remove("meant", "chosen");
  if (!said || !root.classList.contains("show-re")) return;
  for (const spot of document.querySelectorAll(`.plan [data-type="${said.dataset.type}"]`)) spot.classList.add("meant", "chosen");
});

// an address that names a model, planner or method is meant to be gone on with
for (const name of ["model", "planner", "method"]) {
  const named = new URL(location.href).searchParams.get(name);
  if (named) remember(name, named);
}

setTheme(wanted());
root.classList.toggle("show-re", recall("marks", false));
window.addEventListener("load", () => setTheme(wanted()));
