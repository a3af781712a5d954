// The researchers' pages: what is live keeps itself up to date, and a task is walked through by keys.
import { recall, remember, setUpTheme } from "./plain_page.js";

const EVERY = 5000; // ms between looks at what is live
const PACE = 900; // ms a step while playing
let playing = 0;
let asked = 0;
let walking = 0; // steps asked for that are still to come

setUpTheme();

const now = () => document.querySelector("#now");

/** Fetch an address of this page and show its part in place; forms and what is typed stay. */
async function show(address, { quietly = false } = {}) {
  asked += 1;
  const mine = asked;
  const at = document.activeElement?.dataset?.key;
  if (!quietly) walking += 1;
  try {
    const answer = await fetch(address, { cache: "no-store" });
    if (mine !== asked) return;
    if (!answer.ok) {
      if (!quietly) location.href = address;
      return;
    }
    const made = new DOMParser().parseFromString(await answer.text(), "text/html");
    const fresh = made.querySelector("#now");
    if (mine !== asked || !fresh) return;
    document.querySelector(".away")?.remove();
    const room = document.querySelector(".replay .talking")?.scrollTop;
    if (fresh.outerHTML !== now().outerHTML) now().replaceWith(fresh);
    const talk = document.querySelector(".replay .talking");
    if (talk && room) talk.scrollTop = room;
    if (at) now().querySelector(`[data-key="${at}"]`)?.focus();
    document.querySelector(".marks [aria-current]")?.scrollIntoView({ block: "nearest", inline: "nearest" });
    if (!quietly) history.replaceState(null, "", address);
    label();
  } catch {
    if (!document.querySelector(".away")) {
      const words = document.createElement("p");
      words.className = "away";
      words.setAttribute("role", "alert");
      words.textContent = "The server does not answer; what is shown may be old.";
      document.querySelector("main")?.prepend(words);
    }
  } finally {
    if (!quietly) walking -= 1;
  }
}

setInterval(() => {
  if (now()?.matches("[data-live]") && !document.hidden && !walking) show(location.href, { quietly: true });
}, EVERY);

// ---- walking through a task

const way = (key) => document.querySelector(`.walk [data-key="${key}"]`);
const place = () => document.querySelector(".walk")?.dataset ?? {};

function label() {
  const button = document.querySelector(".walk [data-do=play]");
  if (button) button.textContent = playing ? "Pause" : "Play";
}

function stop() {
  clearInterval(playing);
  playing = 0;
  label();
}

function play() {
  if (playing) {
    stop();
    return;
  }
  if (place().at === place().last) show(way("Home").href);
  playing = setInterval(() => {
    if (Number(place().at) >= Number(place().last)) stop();
    else show(way("ArrowRight").href);
  }, PACE);
  label();
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest?.("input,textarea,select")) return;
  if (event.key === " " && document.querySelector(".walk") && !event.target.closest?.("a,button")) {
    event.preventDefault();
    play();
    return;
  }
  const link = way(event.key);
  if (!link) return;
  event.preventDefault();
  stop();
  show(link.href);
});
document.addEventListener("click", (event) => {
  const control = event.target.closest?.("[data-do]");
  if (control?.dataset.do === "theme") {
    const theme = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
    remember("theme", theme);
    document.documentElement.dataset.theme = recall("theme", theme);
  }
  if (control?.dataset.do === "play") play();
  const link = event.target.closest?.(".walk a");
  if (link && !event.ctrlKey && !event.metaKey && !event.shiftKey) {
    event.preventDefault();
    stop();
    show(link.href);
  }
});
