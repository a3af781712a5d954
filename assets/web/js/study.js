// A participant's page: what they press, and when the page was shown and left, by their own clock.
import { isBusy, send } from "./bus.js";
import { announce, onChange } from "./page.js";
import "./main.js";

const root = document.documentElement;
const where = () => document.querySelector("#where")?.dataset ?? {};
const study = () => new URL(location.href).searchParams.get("study") ?? "";

// ---- times

let shownAt = Date.now();
let hiddenSince = 0;
let hidden = 0;
document.addEventListener("visibilitychange", () => {
  if (document.hidden) hiddenSince = Date.now();
  else if (hiddenSince) {
    hidden += Date.now() - hiddenSince;
    hiddenSince = 0;
  }
});

/** What every event carries besides what it is about. */
window.reiExtra = () => ({
  study: study(),
  stage: where().stage,
  place: Number(where().place ?? 0),
  attempt: Number(where().attempt ?? 0),
  shown: shownAt,
  left: Date.now(),
  hidden,
});

// ---- what is pressed

function answers() {
  const form = document.querySelector("#questions");
  return form ? Object.fromEntries(new FormData(form)) : {};
}

/** Send what leads on, but not while the answer to a first click is still to come. */
const once = (name, data) => isBusy() || send(name, data);

const DO = {
  agree: () => once("consent", { agreed: true }),
  decline: () => once("consent", { agreed: false }),
  read: () => once("read"),
  answer: () => once("answer", { answers: answers() }),
  withdraw: () => {
    document.querySelector("#leaving")?.close();
    send("withdraw");
  },
  "leave-study": () => document.querySelector("#leaving")?.showModal(),
  stay: () => document.querySelector("#leaving")?.close(),
  help: () => document.querySelector("#helping")?.showModal(),
  "close-help": () => document.querySelector("#helping")?.close(),
};
document.addEventListener("click", (event) => {
  const button = event.target.closest?.("[data-do]");
  if (button && DO[button.dataset.do]) DO[button.dataset.do](button);
});
document.addEventListener("submit", (event) => event.preventDefault());
document.addEventListener("change", (event) => {
  if (event.target.id !== "agree") return;
  const go = document.querySelector("[data-do=agree]");
  if (go) go.disabled = !event.target.checked;
});

// ---- a time limit, as a calm bar

let ending = 0;
let until = 0;
function watchTime(at) {
  clearTimeout(ending);
  if (!at.left) return;
  until = performance.now() + 1000 * Number(at.left);
  ending = setTimeout(() => send("look"), 1000 * Number(at.left));
}
setInterval(() => {
  const bar = document.querySelector("#time i");
  const limit = Number(where().limit ?? 0);
  if (bar && limit) bar.style.width = `${Math.max(0, (until - performance.now()) / (10 * limit))}%`;
}, 500);

// ---- after each change

let last = "";
onChange(() => {
  const at = where();
  root.dataset.view = at.view ?? "card";
  root.dataset.shows = at.shows ?? "";
  const now = `${at.stage}/${at.place}/${at.step}/${at.attempt ?? ""}`;
  if (now === last || at.stage === undefined) return;
  const stage = `${at.stage}/${at.place}`;
  const fresh = !last.startsWith(`${stage}/`);
  const again = !fresh && at.attempt !== undefined;
  last = now;
  watchTime(at);
  shownAt = Date.now();
  hidden = 0;
  if (again) document.querySelector("#questions")?.reset();
  if (!fresh && !again) return;
  root.dataset.talk = "open"; // on a phone too, everybody sees what was said before they act
  scrollTo(0, 0);
  document.querySelector(".talk")?.scrollTo(0, 0);
  const page = document.querySelector("#card");
  page?.focus({ preventScroll: true });
  document.querySelector("#page")?.scrollTo(0, 0);
  announce(document.querySelector("#card h1, .progress b")?.textContent ?? "");
  // who somebody is elsewhere has no business in the address
  const address = new URL(location.href);
  for (const name of [...address.searchParams.keys()]) {
    if (!["study", "invite", "__theme"].includes(name)) address.searchParams.delete(name);
  }
  history.replaceState(null, "", address);
});
root.dataset.page = "study";
