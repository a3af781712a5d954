// Pages without Gradio: theme and what this browser remembers.
import { recall, remember } from "./page.js";
export { recall, remember };

/** Show the theme this browser remembers, or the system's. */
export function setUpTheme() {
  const dark = matchMedia("(prefers-color-scheme:dark)").matches;
  document.documentElement.dataset.theme = recall("theme", dark ? "dark" : "light");
}
