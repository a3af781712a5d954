// Wording an episode: another room offers other things; what the task does not need is not asked.
import { remember, setUpTheme } from "./plain_page.js";

setUpTheme();
const form = document.querySelector("#own");
const STACK = "pick_and_place_with_movable_recep";
const EXAMINE = "look_at_obj_in_light";

function fit() {
  const kind = form.elements.task_type.value;
  form.querySelector(".movable").hidden = kind !== STACK;
  const places = form.elements.destination;
  places.closest(".field").querySelector(".label").textContent =
    kind === EXAMINE ? "Lamp it is looked at under" : "Where it should end";
  for (const group of places.querySelectorAll("optgroup")) {
    const lamps = group.label === "Lamps";
    group.hidden = lamps !== (kind === EXAMINE);
    group.disabled = group.hidden;
  }
  const chosen = places.selectedOptions[0];
  if (chosen?.parentElement.disabled) places.value = "";
}

form.elements.room.addEventListener("change", () => {
  // what is written stays: the page is loaded anew with it, for the other room
  const kept = new URLSearchParams();
  for (const [name, value] of new FormData(form)) if (value) kept.set(name, value);
  location.replace(`/own?${kept}`);
});
form.elements.task_type.addEventListener("change", fit);
form.addEventListener("submit", () => {
  const button = form.querySelector(".big");
  button.textContent = "Checking that it can be done …";
  button.disabled = true;
});
addEventListener("pageshow", () => {
  const button = form.querySelector(".big");
  button.textContent = "See both planners try";
  button.disabled = false;
});
document.addEventListener("click", (event) => {
  if (!event.target.closest?.("[data-do=theme]")) return;
  remember("theme", document.documentElement.dataset.theme === "dark" ? "light" : "dark");
  setUpTheme();
});
fit();
