// Choosing a thing: a menu of the skills that act on it, the likely ones first.
import { isBusy } from "./bus.js";
import { carryOut, field, filterBy, likelySkills, refresh, skillsOf } from "./picker.js";
import { endedDrag, focusSpot, middle, nearestSpot, plan } from "./plan.js";
import { isNarrow, onChange, run } from "./page.js";

let opener = null;
let byKey = false; // whether the menu was opened from the keyboard
let returnTo = ""; // id of the thing that gets the focus back after the step
let beside = ""; // id of the thing whose neighbours the strip lists

const baseType = (spot) => spot.dataset.type.replace(/(Sliced|Cracked)$/, "");

/** Return the skills offered for `spot`: likely ones, then the rest in the planners' order. */
function offered(spot) {
  const likely = likelySkills();
  const own = skillsOf(baseType(spot)).map((skill) => skill.text);
  const near = document.querySelector("#act")?.dataset.near;
  const putting = likely.filter((text) => text.startsWith("put down") && near === baseType(spot));
  const first = likely.filter((text) => own.includes(text));
  return [...new Set([...putting, ...first, ...own])];
}

function open(spot) {
  close();
  opener = spot;
  spot.classList.add("chosen");
  const { over, sitting } = run();
  const entries = sitting && !over ? offered(spot) : [];
  const menu = document.createElement("div");
  menu.className = "menu";
  menu.setAttribute("role", "menu");
  menu.setAttribute("aria-label", spot.dataset.name);
  const details = [spot.dataset.states, spot.dataset.place].filter(Boolean).join(" · ");
  menu.innerHTML = `<h3></h3><ul></ul>`;
  menu.querySelector("h3").textContent = spot.dataset.name;
  const note = document.createElement("span");
  note.textContent = details;
  menu.querySelector("h3").append(note);
  const list = menu.querySelector("ul");
  for (const text of entries) {
    const item = document.createElement("li");
    item.setAttribute("role", "menuitem");
    item.tabIndex = -1;
    item.dataset.skill = text;
    item.textContent = text;
    list.append(item);
  }
  if (!entries.length) list.innerHTML = `<li class="none">Nothing can be done with it here.</li>`;
  document.querySelector(".roomwrap").append(menu);
  place(menu, spot);
  document.querySelector(".tip")?.remove();
  if (entries.length && !isNarrow()) filterBy(spot.dataset.noun);
  list.querySelector("[role=menuitem]")?.focus();
}

function place(menu, spot) {
  if (isNarrow()) return;
  const frame = document.querySelector(".roomwrap").getBoundingClientRect();
  const at = middle(spot);
  let left = at.area.right - frame.x + 10;
  if (left + menu.offsetWidth > frame.width - 4) left = at.area.left - frame.x - menu.offsetWidth - 10;
  const top = Math.min(Math.max(at.area.top - frame.y - 8, 4), frame.height - menu.offsetHeight - 4);
  menu.style.left = `${Math.max(left, 4)}px`;
  menu.style.top = `${Math.max(top, 4)}px`;
}

/** Close the menu; `back` returns the focus to what it was opened from. */
export function close({ back = false } = {}) {
  const menu = document.querySelector(".menu");
  opener?.classList.remove("chosen");
  if (!menu) return;
  menu.remove();
  const input = field();
  if (input && input.dataset.doing === undefined && input.value) {
    input.value = "";
    refresh();
  }
  if (back && opener?.isConnected) {
    if (opener.closest(".plan")) focusSpot(opener);
    else opener.focus();
  }
  opener = null;
}

/** Show everything on or in the same place as `spot` where fingers can hit it. */
function showSurface(spot) {
  beside = spot.dataset.oid;
  const strip = document.querySelector(".surface");
  if (!strip || !isNarrow()) return;
  const others = [...plan().querySelectorAll("[data-oid][data-type]")].filter(
    (other) => other.dataset.place === spot.dataset.place && other.classList.contains("thing"),
  );
  strip.innerHTML = "";
  const label = document.createElement("span");
  label.className = "label";
  label.textContent = spot.dataset.place || "Here";
  strip.append(label);
  for (const other of [spot, ...others.filter((one) => one !== spot)].slice(0, 14)) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "btn";
    Object.assign(button.dataset, other.dataset);
    const picture = other.querySelector("use:not(.badge use)");
    const icon = picture ? `<svg viewBox="0 0 32 32" aria-hidden="true"><use href="${picture.getAttribute("href")}"></use></svg>` : "";
    button.innerHTML = icon;
    button.append(other.dataset.name);
    strip.append(button);
  }
}

document.addEventListener("click", (event) => {
  const item = event.target.closest?.(".menu [data-skill]");
  if (item) {
    const text = item.dataset.skill;
    returnTo = byKey ? (opener?.dataset.oid ?? "") : "";
    close();
    carryOut(text);
    return;
  }
  if (event.target.closest?.(".menu")) return;
  const room = event.target.closest?.(".room.live");
  let spot = event.target.closest?.(".room.live [data-oid][data-type]");
  if (room && event.target.closest(".plan") && !endedDrag() && isNarrow())
    spot = nearestSpot(event.clientX, event.clientY, 22) ?? spot;
  if (!room || !spot || endedDrag()) {
    close();
    return;
  }
  event.preventDefault();
  byKey = false;
  if (spot.closest(".plan")) showSurface(spot);
  open(spot);
});
document.addEventListener("keydown", (event) => {
  const menu = document.querySelector(".menu");
  const spot = event.target.closest?.(".room.live .plan [data-oid][data-type]");
  if (spot && (event.key === "Enter" || event.key === " ")) {
    event.preventDefault();
    byKey = true;
    open(spot);
    return;
  }
  if (spot && event.key === "Escape") {
    event.preventDefault();
    spot.blur();
    document.querySelector(".tip")?.remove();
    field()?.focus();
    return;
  }
  if (!menu) return;
  if (event.key === "Escape") {
    event.preventDefault();
    event.stopPropagation();
    close({ back: true });
    return;
  }
  const items = [...menu.querySelectorAll("[data-skill]")];
  const at = items.indexOf(document.activeElement);
  if (at < 0) return;
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (step) {
    event.preventDefault();
    items[(at + step + items.length) % items.length].focus();
  } else if (event.key === "Enter" || event.key === " ") {
    event.preventDefault();
    items[at].click();
  } else if (event.key === "Tab") {
    close();
  } else if (/^[a-z]$/.test(event.key) && !event.ctrlKey && !event.metaKey && !event.altKey) {
    event.preventDefault();
    event.stopPropagation();
    const order = [...items.slice(at + 1), ...items.slice(0, at + 1)];
    order.find((item) => item.dataset.skill.startsWith(event.key))?.focus();
  }
}, true);

onChange(() => {
  const strip = document.querySelector(".surface");
  if (beside && strip && !strip.childElementCount && isNarrow()) {
    const spot = plan()?.querySelector(`[data-oid="${beside}"]`);
    if (spot) showSurface(spot);
  }
  if (opener && !opener.isConnected) close();
  if (returnTo && !isBusy()) {
    const spot = plan()?.querySelector(`[data-oid="${returnTo}"]`);
    returnTo = "";
    if (spot) focusSpot(spot);
  }
});
