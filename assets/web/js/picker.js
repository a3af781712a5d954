// The picker: all skills in the browser, found by any part of any word.
import { isBusy, noteAnswer, send } from "./bus.js";
import { isField, onChange, run } from "./page.js";

const ARTICLES = new Set(["a", "an", "the"]);
let skills = []; // {verb, type, text, words, initials}
let source = "";
let verb = "";
let chosen = 0;
let shown = []; // skills in the order they are offered
let suggested = "";

const pick = () => document.querySelector(".pick");
export const field = () => document.querySelector("#skill");
const escapeHtml = (words) =>
  words.replace(/[&<>"]/g, (sign) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);

function load() {
  const written = pick()?.dataset.skills;
  if (!written || written === source) return Boolean(written);
  source = written;
  skills = JSON.parse(written).map(([name, type, text]) => {
    const words = text.toLowerCase().split(" ");
    const initials = words.filter((word) => !ARTICLES.has(word)).map((word) => word[0]).join("");
    return { verb: name, type, text, words, initials };
  });
  skills.push({ verb: "done", type: "", text: "done", words: ["done"], initials: "d" });
  return true;
}

/** Return every skill that acts on this type of object. */
export const skillsOf = (type) => (load() ? skills.filter((skill) => skill.type === type) : []);

/** Return the skills that suit what is in reach, the likeliest first. */
export const likelySkills = () => JSON.parse(document.querySelector("#act")?.dataset.likely || "[]");

const matches = (skill, token) =>
  skill.words.some((word) => word.includes(token)) || skill.initials.includes(token);

const tokens = () => (field()?.value ?? "").toLowerCase().split(/\s+/).filter(Boolean);

function found() {
  const wanted = tokens();
  return skills.filter((skill) => wanted.every((token) => matches(skill, token)));
}

/** Show what the field and the verbs ask for. */
export function refresh() {
  const box = pick();
  if (!box || !load()) return;
  const wanted = tokens();
  const all = found();
  const fitting = verb ? all.filter((skill) => skill.verb === verb) : all;
  const likely = likelySkills();
  const byText = new Map(fitting.map((skill) => [skill.text, skill]));
  const reach = likely.map((text) => byText.get(text)).filter(Boolean);
  const rest = fitting.filter((skill) => !reach.includes(skill));
  shown = [...reach, ...rest];
  // with nothing asked for, Enter must not do whatever happens to stand first
  chosen = wanted.length || verb ? 0 : -1;
  markVerbs(box, all, wanted);
  list(box, reach, rest, wanted);
  sayNoMatch(box, wanted);
  dimPlan(wanted.length ? new Set(shown.map((skill) => skill.type)) : null);
}

function markVerbs(box, all, wanted) {
  for (const chip of box.querySelectorAll("[data-verb]")) {
    const any = all.some((skill) => skill.verb === chip.dataset.verb);
    chip.classList.toggle("has", Boolean(wanted.length) && any);
    chip.classList.toggle("none", Boolean(wanted.length) && !any);
    chip.setAttribute("aria-pressed", String(verb === chip.dataset.verb));
  }
}

function list(box, reach, rest, wanted) {
  const rows = [];
  let heading = "";
  const group = (title) => rows.push(`<li class="group" role="presentation">${title}</li>`);
  if (reach.length && !wanted.length) group("In reach");
  shown.forEach((skill, index) => {
    if (!wanted.length && index >= reach.length && skill.verb !== heading) {
      heading = skill.verb;
      group(heading === "done" ? "end the episode" : `${heading} · ${rest.filter((one) => one.verb === heading).length}`);
    }
    const on = index === chosen;
    rows.push(
      `<li role="option" id="skill-${index}" data-index="${index}" class="${on ? "on" : ""}" aria-selected="${on}"><span>${marked(skill.text, wanted)}</span></li>`,
    );
  });
  const options = box.querySelector(".opts");
  options.innerHTML = rows.join("");
  options.scrollTop = 0;
  pointAt(box);
}

function pointAt(box) {
  const input = field();
  if (shown[chosen]) input?.setAttribute("aria-activedescendant", `skill-${chosen}`);
  else input?.removeAttribute("aria-activedescendant");
  for (const option of box.querySelectorAll("[role=option]")) {
    const on = Number(option.dataset.index) === chosen;
    option.classList.toggle("on", on);
    option.setAttribute("aria-selected", String(on));
  }
}

function marked(text, wanted) {
  let at = -1;
  let length = 0;
  for (const token of wanted) {
    const place = text.toLowerCase().indexOf(token);
    if (place >= 0 && token.length > length) [at, length] = [place, token.length];
  }
  if (at < 0) return escapeHtml(text);
  const end = at + length;
  return `${escapeHtml(text.slice(0, at))}<b>${escapeHtml(text.slice(at, end))}</b>${escapeHtml(text.slice(end))}`;
}

function sayNoMatch(box, wanted) {
  const line = box.querySelector(".nomatch");
  line.hidden = shown.length > 0 || !wanted.length;
  suggested = "";
  if (line.hidden) return;
  const asked = wanted.join(" ");
  suggested = verb && found().length ? asked : nearest(wanted);
  const end = suggested ? ` Did you mean <button type="button" data-suggest>${escapeHtml(suggested)}</button>?` : "";
  line.innerHTML = `No skill is called “${escapeHtml(asked)}”.${end}`;
}

function nearest(wanted) {
  const words = new Set(skills.flatMap((skill) => skill.words));
  const mended = wanted.map((token) => {
    if (skills.some((skill) => matches(skill, token))) return token;
    let best = "";
    let least = 3;
    for (const word of words) {
      const cost = distance(token, word);
      if (cost < least) [best, least] = [word, cost];
    }
    return best || token;
  });
  const fits = skills.some((skill) => mended.every((token) => matches(skill, token)));
  return fits ? mended.join(" ") : "";
}

function distance(one, other) {
  if (Math.abs(one.length - other.length) > 2) return 9;
  let row = [...Array(other.length + 1).keys()];
  for (let i = 1; i <= one.length; i += 1) {
    const next = [i];
    for (let j = 1; j <= other.length; j += 1) {
      const swap = row[j - 1] + (one[i - 1] === other[j - 1] ? 0 : 1);
      next.push(Math.min(swap, row[j] + 1, next[j - 1] + 1));
    }
    row = next;
  }
  return row[other.length];
}

function dimPlan(types) {
  const room = document.querySelector("section.room");
  room?.classList.toggle("dimmed", Boolean(types));
  for (const thing of room?.querySelectorAll("[data-oid][data-type]") ?? []) {
    const kind = thing.dataset.type.replace(/(Sliced|Cracked)$/, "");
    thing.classList.toggle("match", Boolean(types?.has(kind)));
  }
}

let early = null; // what was chosen while an answer was still to come

/**
 * Carry out a skill, unless the episode is over. What is chosen before the last answer is there is
 * done after it, but only if that changed nothing: nobody acts on a room they have not seen.
 */
export function carryOut(text) {
  const { sitting, expected, over } = run();
  if (!sitting || over) return;
  noteAnswer(); // it may have come since the last frame
  if (isBusy()) {
    early = { text, sitting, expected };
    return;
  }
  const input = field();
  if (input) {
    input.value = `${text} …`;
    input.dataset.doing = text;
  }
  if (text === "done") send("done");
  else send("step", { skill: text, expected, seconds: thinking() });
}

let shownAt = performance.now();
const thinking = () => Math.round(performance.now() - shownAt) / 1000;

/** Fill the field with `words`, as when a thing in the room is chosen. */
export function filterBy(words) {
  const input = field();
  if (!input || input.value === words) return;
  input.value = words;
  refresh();
}

function setVerb(name) {
  verb = verb === name ? "" : name;
  refresh();
  field()?.focus();
}

function move(by) {
  if (!shown.length) return;
  const from = chosen < 0 && by < 0 ? 0 : chosen;
  chosen = (from + by + shown.length) % shown.length;
  pointAt(pick());
  const option = pick().querySelector(`#skill-${chosen}`);
  option?.scrollIntoView({ block: "nearest" });
}

function escape() {
  const input = field();
  if (input.value || verb) {
    verb = "";
    input.value = "";
    refresh();
  } else {
    input.blur();
  }
}

document.addEventListener("input", (event) => {
  if (event.target.id !== "skill") return;
  const { doing } = event.target.dataset;
  if (doing !== undefined) {
    // what is typed while an action is under way is the beginning of the next one
    delete event.target.dataset.doing;
    event.target.value = event.target.value.replace(`${doing} …`, "");
  }
  refresh();
});
document.addEventListener("keydown", (event) => {
  if (event.altKey && /^Digit[1-8]$/.test(event.code)) {
    const chip = pick()?.querySelectorAll("[data-verb]")[Number(event.code.slice(5)) - 1];
    if (chip) {
      event.preventDefault();
      setVerb(chip.dataset.verb);
    }
    return;
  }
  if (event.target.id !== "skill" || event.ctrlKey || event.metaKey) return;
  const act = {
    ArrowDown: () => move(1),
    ArrowUp: () => move(-1),
    Enter: () => shown[chosen] && event.target.dataset.doing === undefined && carryOut(shown[chosen].text),
    Escape: escape,
  }[event.key];
  if (act) {
    event.preventDefault();
    event.stopPropagation();
    act();
  }
});
document.addEventListener("click", (event) => {
  const option = event.target.closest?.("[role=option][data-index]");
  if (option) carryOut(shown[Number(option.dataset.index)].text);
  const chip = event.target.closest?.("[data-verb]");
  if (chip) setVerb(chip.dataset.verb);
  if (event.target.closest?.("[data-suggest]")) {
    verb = "";
    filterBy(suggested);
    field().focus();
  }
});

function catchUp({ sitting, expected }) {
  if (!early || isBusy()) return;
  const { text } = early;
  const same = early.sitting === sitting && early.expected === expected;
  early = null;
  if (same) carryOut(text);
}

let last = "";
onChange(() => {
  const box = pick();
  const { sitting, expected, over } = run();
  catchUp(run());
  if (!box) return;
  document.documentElement.classList.toggle("closed", Boolean(over));
  const now = `${sitting}/${expected}/${over}/${document.querySelector("[data-reply]")?.dataset.reply}/${source === box.dataset.skills}`;
  if (now === last || isBusy()) return;
  last = now;
  shownAt = performance.now();
  const input = field();
  if (input.dataset.doing !== undefined) {
    input.value = "";
    delete input.dataset.doing;
    verb = "";
    if (!isField(document.activeElement) && document.activeElement === document.body) {
      if (!matchMedia("(pointer:coarse)").matches) input.focus();
    }
  }
  refresh();
});
