// The comparison: menus close when one clicks elsewhere; the theme can be changed.
import { remember, setUpTheme } from "./plain_page.js";

setUpTheme();
document.addEventListener("click", (event) => {
  for (const menu of document.querySelectorAll("details.export[open]"))
    if (!menu.contains(event.target)) menu.open = false;
  if (!event.target.closest?.("[data-do=theme]")) return;
  remember("theme", document.documentElement.dataset.theme === "dark" ? "light" : "dark");
  setUpTheme();
});
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") for (const menu of document.querySelectorAll("details.export[open]")) menu.open = false;
});
