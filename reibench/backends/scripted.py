"""Backends that answer from a list or by rules: the model of tests and recorded demonstrations."""

import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from itertools import cycle
from pathlib import Path

from reibench.backends import Alternative, Backend, Generation, Prompt, Selection, backends
from reibench.errors import ModelUnavailable, ReibenchError

RESOLVES = frozenset({"resolver"})
"""A script can answer for this adapter; one for `planner` would be asked in other words."""


class ScriptedBackend:
    """Give the answers in turn, and keep the prompts for inspection."""

    adapters = RESOLVES

    def __init__(self, answers: Iterable[str], *, name: str = "scripted:list") -> None:
        self.name = name
        self.prompts: list[Prompt] = []
        """What was asked, in order."""
        self._answers = iter(answers)

    def generate(
        self, prompt: Prompt, *, max_tokens: int = 128, stop: Sequence[str] = (), grammar: str = ""
    ) -> Generation:
        """Return the next answer as it stands."""
        answer = self._next(prompt)
        return Generation(answer, prompt=prompt.text + prompt.begun)

    def choose(self, prompt: Prompt, options: Sequence[str]) -> Selection:
        """Return the option the next answer names, spaces around it ignored."""
        return _chosen(self.name, self._next(prompt), prompt, options)

    def close(self) -> None:
        """Do nothing: there is no model to free."""

    def _next(self, prompt: Prompt) -> str:
        self.prompts.append(prompt)
        answer = next(self._answers, None)
        if answer is None:
            raise ReibenchError(
                f"The script {self.name!r} has no answer left after"
                f" {len(self.prompts) - 1}; it needs one for every question."
            )
        return answer


class RuleScript:
    """Answer by rules: the first whose pattern is in the prompt, with its answers over and over.

    So one script serves any planner and method over any number of episodes.
    """

    adapters = RESOLVES

    def __init__(self, rules: Mapping[str, Sequence[str]], *, name: str = "scripted:rules") -> None:
        """Take `rules`: regular expressions searched in prompts, each with its answers in turn."""
        self.name = name
        self._rules = [(re.compile(asked), cycle(answers)) for asked, answers in rules.items()]

    def generate(
        self, prompt: Prompt, *, max_tokens: int = 128, stop: Sequence[str] = (), grammar: str = ""
    ) -> Generation:
        """Return the answer as it stands."""
        return Generation(self._answer(prompt), prompt=prompt.text + prompt.begun)

    def choose(self, prompt: Prompt, options: Sequence[str]) -> Selection:
        """Return the option the answer names; the answer `#1` is the first option, and so on."""
        answer = self._answer(prompt)
        if number := re.fullmatch(r"#(\d+)", answer):
            answer = options[min(int(number[1]), len(options)) - 1]
        return _chosen(self.name, answer, prompt, options)

    def close(self) -> None:
        """Do nothing: there is no model to free."""

    def _answer(self, prompt: Prompt) -> str:
        text = prompt.text + prompt.begun
        for asked, answers in self._rules:
            if asked.search(text):
                return next(answers)
        raise ReibenchError(
            f"No rule of {self.name!r} is for a prompt that ends with {text[-60:]!r}; a last rule"
            ' with asked = "" takes what no other does.'
        )


def _chosen(name: str, answer: str, prompt: Prompt, options: Sequence[str]) -> Selection:
    """Return the option that `answer` names, spaces around it ignored."""
    for option in options:
        if option.strip() == answer.strip():
            sure = (Alternative(option, 1.0),)
            return Selection(option, alternatives=sure, prompt=prompt.text + prompt.begun)
    raise ReibenchError(
        f"The script {name!r} says {answer!r}, which is none of the {len(options)}"
        f" options; they read like {', '.join(repr(option) for option in options[:3])}."
    )


@backends.register("scripted")
def open_script(source: str) -> Backend:
    r"""Open the script in the file `source`.

    A text file has one answer a line, `\n` for a new line within it. A file ending in .toml has
    tables `[[rule]]` with `asked`, a regular expression, and `answers`, a list.
    """
    try:
        written = Path(source).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ModelUnavailable(
            f"The script {source} cannot be read ({error}); it should be a text file with one"
            " answer a line."
        ) from error
    if source.lower().endswith(".toml"):
        return RuleScript(_rules(source, written), name=f"scripted:{source}")
    answers = [line.replace("\\n", "\n") for line in written.splitlines() if line.strip()]
    return ScriptedBackend(answers, name=f"scripted:{source}")


def _rules(source: str, written: str) -> dict[str, list[str]]:
    try:
        entries = tomllib.loads(written)["rule"]
        rules = {entry["asked"]: [str(answer) for answer in entry["answers"]] for entry in entries}
        usable = all(rules.values()) and all(re.compile(asked) for asked in rules)
    except (tomllib.TOMLDecodeError, KeyError, TypeError, re.error) as error:
        raise ModelUnavailable(
            f"The script {source} is not one of rules ({error}); it should have tables [[rule]],"
            " each with asked = 'a regular expression' and answers = ['…']."
        ) from error
    if not usable:
        raise ModelUnavailable(f"A rule of {source} has no answers; give it at least one.")
    return rules
