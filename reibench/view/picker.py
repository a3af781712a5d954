"""The picker: every skill, sent once, found by typing any part of any word."""

import json
from collections.abc import Sequence

from reibench.skill import Skill, Verb
from reibench.view.markup import element, text

_LENS = (
    '<svg width="16" height="16" viewBox="0 0 16 16" fill="none" stroke="currentColor"'
    ' stroke-width="1.700" aria-hidden="true"><circle cx="7" cy="7" r="4.700"/>'
    '<path d="M10.600 10.600 14.500 14.500" stroke-linecap="round"/></svg>'
)


def picker(skills: Sequence[Skill]) -> str:
    """Return the search field, the verbs, and an empty list that the page fills as one types.

    The skills keep the planners' order; whatever is put above them comes with each step.
    """
    entries = [[str(skill.verb), skill.object, skill.text] for skill in skills]
    field = element(
        "input",
        type="text",
        id="skill",
        role="combobox",
        placeholder="Type an action or a thing",
        autocomplete="off",
        autocapitalize="off",
        spellcheck="false",
        aria_label="Next action",
        aria_expanded="true",
        aria_controls="options",
        aria_autocomplete="list",
        enterkeyhint="go",
    )
    search = element("div", _LENS, field, element("kbd", "/", class_="hide-m"), class_="search")
    options = element("ul", class_="opts", id="options", role="listbox", aria_label="Actions")
    hint = element(
        "div",
        element("span", "<kbd>↑</kbd> <kbd>↓</kbd> choose"),
        element("span", "<kbd>↵</kbd> do it"),
        element("span", "<kbd>Esc</kbd> clear"),
        class_="hint",
        aria_hidden="true",
    )
    return element(
        "div",
        search,
        _verbs(skills),
        options,
        element("p", class_="nomatch", hidden=True),
        hint,
        class_="pick",
        data_skills=json.dumps(entries, separators=(",", ":")),
    )


def _verbs(skills: Sequence[Skill]) -> str:
    chips = []
    for number, verb in enumerate(Verb, start=1):
        count = sum(skill.verb is verb for skill in skills)
        chips.append(
            element(
                "button",
                text(verb),
                element("i", str(count)),
                type="button",
                data_verb=str(verb),
                aria_pressed="false",
                title=f"Only “{verb}” (Alt+{number})",
            )
        )
    return element("div", *chips, class_="verbs", role="group", aria_label="Verbs")
