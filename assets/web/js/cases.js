// Cases: links and filters change a part of the page and the address; steps are walked with keys.
import { recall, remember, setUpTheme } from "./plain_page.js";

setUpTheme();
const $ = (selector, within = document) => within.querySelector(selector);
const $$ = (selector, within = document) => [...within.querySelectorAll(selector)];
const view = () => $("#case");
const number = (name) => Number(view()?.dataset[name] ?? 0);
const narrow = () => matchMedia("(max-width:760px)").matches;
const say = (words) => { $("#live").textContent = words; };

// ---- parts of the page

const known = new Map(); // what was fetched lately, by address
let listsAsked = 0;
let casesAsked = 0;
let coming = null; // the case that was asked for, until it is here
let target = ""; // its runs

async function part(name, address, { ahead = false } = {}) {
  const url = new URL(address, location.href);
  url.searchParams.set("part", name);
  const key = url.toString();
  if (name === "at" && known.has(key)) return known.get(key);
  const answer = await fetch(key).catch(() => null);
  const text = await answer?.text().catch(() => null);
  if (!answer?.ok || text === null) {
    if (ahead) return null;
    if (answer && !answer.ok) location.href = address; // the whole page says what is wrong
    else trouble("The server does not answer; try again.");
    return null;
  }
  if (name === "at") {
    known.set(key, text);
    if (known.size > 200) known.delete(known.keys().next().value);
  }
  return text;
}

function trouble(words) {
  document.body.classList.remove("busy");
  if ($("#count")) $("#count").textContent = words;
  say(words);
}

function put(selector, markup) {
  const holder = document.createElement("template");
  holder.innerHTML = markup;
  $(selector).replaceWith(holder.content.firstElementChild);
}

async function showList(address, { keep = true } = {}) {
  const mine = ++listsAsked;
  document.body.classList.add("busy");
  const field = document.activeElement?.id === "words" ? document.activeElement : null;
  const markup = await part("list", address);
  if (markup === null || mine !== listsAsked) return;
  const opened = $$(".filt details").some((each) => each.open);
  const [start, end] = field ? [field.selectionStart, field.selectionEnd] : [];
  put("#listing", markup);
  document.body.classList.remove("busy");
  if (opened) $$(".filt details").forEach((each) => { each.open = true; });
  if (field) {
    $("#words").focus();
    $("#words").setSelectionRange(start, end);
  }
  if (keep) keepAddress("pushState", address);
  markCurrent();
  say($("#count")?.textContent ?? "");
}

function showCase(address, options = {}) {
  if (options.keep !== false && noted() && !confirm("Your tags and note are not kept yet. Leave them?")) return;
  stop();
  target = new URL(address, location.href).searchParams.get("runs") ?? "";
  markCurrent(); // at once, so that the next key counts from here
  coming = putCase(address, ++casesAsked, options);
}

async function putCase(address, mine, { keep = true }) {
  const markup = await part("case", address);
  if (mine !== casesAsked) return; // another case was asked for since
  [coming, target] = [null, ""];
  if (markup !== null) {
    put("#case", markup);
    if (keep) keepAddress("pushState", address);
    draw();
    say($("#case h1")?.textContent ?? "");
    if (keep && narrow()) view().scrollIntoView({ block: "start" });
  }
  markCurrent();
}

const noted = () => $$(".keepform :is(input,textarea)").some((each) => each.value !== each.defaultValue);

function markCurrent() {
  const runs = target || (view()?.dataset.runs ?? "");
  for (const link of $$("#list .case")) {
    const on = new URL(link.href).searchParams.get("runs") === runs;
    link.classList.toggle("on", on);
    if (on) link.setAttribute("aria-current", "true");
    else link.removeAttribute("aria-current");
  }
}

// ---- steps

function keepAddress(how, where) {
  if (window.reiSteps) return; // a file on disk has no address to keep
  try {
    history[how](null, "", where);
  } catch {
    // browsers refuse when keys are held down for long; the next step keeps it
  }
}

function address() {
  const url = new URL(location.href);
  if (!view()?.dataset.runs) return url;
  url.searchParams.set("case", view().dataset.case);
  url.searchParams.set("runs", view().dataset.runs);
  url.searchParams.set("step", number("row") + 1);
  url.searchParams.set("lane", number("lane") + 1);
  return url;
}

const place = () => [view()?.dataset.runs, number("row"), number("lane")].join();

async function go(row, lane = number("lane")) {
  if (!view()?.dataset.runs) return;
  view().dataset.row = Math.max(-1, Math.min(row, number("rows") - 1));
  view().dataset.lane = Math.max(0, Math.min(lane, number("lanes") - 1));
  draw();
  keepAddress("replaceState", address());
  const wanted = place();
  const markup = window.reiSteps ? window.reiSteps(number("row"), number("lane")) : await part("at", address());
  if (markup === null || wanted !== place()) return;
  const open = $$("#at details").map((each) => [each.querySelector("summary")?.textContent, each.open]);
  $("#at").innerHTML = markup;
  const were = new Map(open);
  for (const each of $$("#at details")) {
    const name = each.querySelector("summary")?.textContent;
    if (were.has(name)) each.open = were.get(name);
  }
  label();
  const told = $("#at .changed");
  say(`${$("#where")?.textContent}. ${told?.textContent ?? ""}`);
  if (!window.reiSteps && number("row") < number("rows") - 1) {
    const next = address();
    next.searchParams.set("step", number("row") + 2);
    part("at", next, { ahead: true }); // it is likely to be wanted
  }
}

function draw() {
  const [row, lane] = [number("row"), number("lane")];
  for (const cell of $$("#lanes .ln")) {
    const here = Number(cell.dataset.row) === row;
    const front = here && Number(cell.dataset.lane) === lane;
    cell.classList.toggle("row", here);
    cell.classList.toggle("cur", front);
    if (cell.tagName === "BUTTON") cell.tabIndex = front ? 0 : -1;
    if (front && !narrow()) cell.scrollIntoView({ block: "nearest" });
  }
  for (const thumb of $$(".thumb"))
    thumb.classList.toggle("on", Number(thumb.dataset.row) === row && Number(thumb.dataset.lane) === lane);
}

// ---- playing

const PACE = 900; // ms a row
let playing = 0;
const label = () => {
  const button = $("#at .play");
  if (button) button.textContent = playing ? "Pause" : "Play";
};
function stop() {
  clearInterval(playing);
  playing = 0;
  label();
}
function play() {
  if (playing) return stop();
  if (number("row") >= number("rows") - 1) go(-1);
  playing = setInterval(() => {
    if (number("row") >= number("rows") - 1) stop();
    else go(number("row") + 1);
  }, PACE);
  label();
}

function neighbour(by) {
  const all = $$("#list .case");
  const at = all.findIndex((each) => each.classList.contains("on"));
  const next = all[Math.max(0, Math.min(at + by, all.length - 1))];
  if (!next || next === all[at]) return;
  next.scrollIntoView({ block: "nearest" });
  showCase(next.href);
}

const DO = {
  back: () => go(number("row") - 1),
  forward: () => go(number("row") + 1),
  split: () => number("split") >= 0 && go(number("split")),
  play,
  copy: async (button) => {
    const link = address().toString();
    try {
      await navigator.clipboard.writeText(link);
    } catch {
      prompt("The link to this case:", link); // a page without https may not copy
    }
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = "Copy link"; }, 1500);
  },
  theme: () => {
    remember("theme", document.documentElement.dataset.theme === "dark" ? "light" : "dark");
    setUpTheme();
  },
};

const WALKS = new Set(["back", "forward", "split", "play"]);

document.addEventListener("click", (event) => {
  const link = event.target.closest?.("a[data-part]");
  if (link && !event.ctrlKey && !event.metaKey && !event.shiftKey) {
    event.preventDefault();
    if (link.dataset.part === "case") showCase(link.href);
    else showList(withCase(link.href));
    return;
  }
  const button = event.target.closest?.("[data-do]");
  if (button && DO[button.dataset.do]) {
    const what = button.dataset.do;
    if (what !== "play") stop();
    // what walks through a case walks through the one that was asked for, as keys do
    if (coming && WALKS.has(what)) inCase(() => DO[what](button));
    else DO[what](button);
    return;
  }
  const tab = event.target.closest?.("[data-tab]");
  if (tab) return void go(number("row"), Number(tab.dataset.tab));
  const cell = event.target.closest?.("#case [data-row][data-lane]");
  if (cell) {
    stop();
    go(Number(cell.dataset.row), Number(cell.dataset.lane));
  }
  for (const menu of $$(".export[open]")) if (!menu.contains(event.target)) menu.open = false;
});

// a filter changes the list, not the case that is being looked at
function withCase(href) {
  const url = new URL(href, location.href);
  const here = address();
  for (const name of ["case", "runs", "step", "lane"])
    if (here.searchParams.get(name)) url.searchParams.set(name, here.searchParams.get(name));
  return url.toString();
}

let waiting = 0;
function applyFilters() {
  const url = new URL("/cases", location.href);
  for (const [name, value] of new FormData($("#filters"))) if (value) url.searchParams.set(name, value);
  showList(withCase(url));
}
document.addEventListener("change", (event) => {
  if (event.target.closest?.("#filters") && event.target.tagName === "SELECT") applyFilters();
});
document.addEventListener("input", (event) => {
  if (event.target.id !== "words") return;
  clearTimeout(waiting);
  waiting = setTimeout(applyFilters, 180);
});
document.addEventListener("submit", (event) => {
  if (event.target.id !== "filters") return;
  event.preventDefault();
  clearTimeout(waiting);
  applyFilters();
});

const KEYS = {
  ArrowLeft: DO.back,
  ArrowRight: DO.forward,
  Home: () => go(-1),
  End: () => go(number("rows") - 1),
  " ": play,
  v: DO.split,
  j: () => neighbour(1),
  k: () => neighbour(-1),
  "/": () => $("#words")?.focus(),
  1: () => go(number("row"), 0),
  2: () => go(number("row"), 1),
  3: () => go(number("row"), 2),
};
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "Escape") {
    for (const menu of $$(".export[open]")) menu.open = false;
    if (document.activeElement?.id === "words") document.activeElement.blur();
    return;
  }
  if (/^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
  const act = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!act || (event.key === " " && event.target.closest?.("button:not(.play),a,summary"))) return;
  if (event.key.length === 1 && event.key !== " " && !recall("keys", true)) return;
  event.preventDefault();
  if (event.key !== " ") stop();
  if (coming && act !== KEYS.j && act !== KEYS.k && act !== KEYS["/"]) inCase(act);
  else act();
});

// what is pressed while a case is on its way is done in that case
async function inCase(act) {
  while (coming) await coming;
  act();
}

addEventListener("popstate", () => {
  showList(location.href, { keep: false });
  showCase(location.href, { keep: false }); // an address without runs shows the first case
});
draw();
