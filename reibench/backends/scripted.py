"""A backend that answers from a list: the language model of tests and recorded demonstrations."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from reibench.backends import Alternative, Backend, Generation, Prompt, Selection, backends
from reibench.errors import ModelUnavailable, ReibenchError


class ScriptedBackend:
    """Give the answers in turn, and keep the prompts for inspection."""

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
        answer = self._next(prompt)
        for option in options:
            if option.strip() == answer.strip():
                sure = (Alternative(option, 1.0),)
                return Selection(option, alternatives=sure, prompt=prompt.text + prompt.begun)
        raise ReibenchError(
            f"The script {self.name!r} says {answer!r}, which is none of the {len(options)}"
            f" options; they read like {', '.join(repr(option) for option in options[:3])}."
        )

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


@backends.register("scripted")
def open_script(source: str) -> Backend:
    r"""Open the script in the file `source`: one answer a line, `\n` for a new line within it."""
    try:
        lines = Path(source).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise ModelUnavailable(
            f"The script {source} cannot be read ({error}); it should be a text file with one"
            " answer a line."
        ) from error
    answers = [line.replace("\\n", "\n") for line in lines if line.strip()]
    return ScriptedBackend(answers, name=f"scripted:{source}")
