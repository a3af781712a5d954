// The one way to the server: named events with data, sent through Gradio, and what comes of them.
import { choice, run, settings } from "./page.js";

const PATIENCE = 4000; // ms without an answer before the connection is doubted
let trigger = null;
let waiting = [];
let sent = 0;
let answered = 0;
let doubt = 0;

/** Send `name` with what the page shows now, and `data`. Returns its number. */
export function send(name, data = {}) {
  if (!trigger) {
    waiting.push([name, data]);
    return 0;
  }
  sent += 1;
  const payload = { ...choice(), ...run(), ...settings(), ...window.reiExtra?.(), ...data, seq: sent };
  document.documentElement.classList.add("busy");
  clearTimeout(doubt);
  doubt = setTimeout(checkConnection, PATIENCE);
  trigger(name, payload);
  return sent;
}

/** Whether an answer is still to come. */
export const isBusy = () => answered < sent;

/** Note the answer the page has just received. */
export function noteAnswer() {
  const reply = document.querySelector("[data-reply]");
  const number = Number(reply?.dataset.reply ?? 0);
  if (number > sent) return;
  answered = Math.max(answered, number);
  if (!isBusy()) {
    clearTimeout(doubt);
    document.documentElement.classList.remove("busy");
    document.querySelector(".offline")?.remove();
  }
}

async function isUp() {
  try {
    const answer = await fetch(location.pathname, { method: "HEAD", cache: "no-store" });
    return answer.ok || answer.status === 405;
  } catch {
    return false;
  }
}

async function checkConnection() {
  if (!isBusy()) return;
  if (await isUp()) {
    doubt = setTimeout(checkConnection, PATIENCE);
    return;
  }
  showOffline();
}

function showOffline() {
  if (document.querySelector(".offline")) return;
  const steps = Math.max(Number(run().expected || 1) - 1, 0);
  const box = document.createElement("div");
  box.className = "offline";
  box.setAttribute("role", "alert");
  box.innerHTML = `<span>No connection. Your ${steps} step${steps === 1 ? " is" : "s are"} saved.</span><button class="btn" type="button">Try again</button>`;
  box.querySelector("button").addEventListener("click", retry);
  document.body.append(box);
  setTimeout(retry, 3000);
}

async function retry() {
  const box = document.querySelector(".offline");
  if (!box) return;
  if (await isUp()) {
    box.remove();
    location.reload(); // everything is in the database: the page continues where it was
  } else {
    setTimeout(retry, 3000);
  }
}

function connect() {
  trigger = window.reiTrigger;
  const early = waiting;
  waiting = [];
  for (const [name, data] of early) send(name, data);
}

if (window.reiTrigger) connect();
window.addEventListener("rei:bus", () => {
  sent = answered = 0; // the page was mounted anew, perhaps after the server restarted
  connect();
});
