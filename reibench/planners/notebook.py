"""What a planner has asked and made since its last decision, to be recorded with the next."""

from collections.abc import Sequence

from reibench.artefact import Artefact
from reibench.backends import Alternative, Backend, Prompt, Selection, Usage
from reibench.planners import Closing, Decision
from reibench.skill import Skill


class Notebook:
    """Asks the model, and keeps the cost and the words of every call for the record.

    The last prompt becomes the decision's own; those before it, and every free answer, artefacts.
    """

    def __init__(self, backend: Backend) -> None:
        self._backend = backend
        self._prompt = ""
        self._usage = Usage()
        self._alternatives: tuple[Alternative, ...] = ()
        self._artefacts: list[Artefact] = []

    def generate(
        self, prompt: Prompt, title: str, *, most: int, stop: Sequence[str], grammar: str = ""
    ) -> str:
        """Let the model write at most `most` tokens, and keep it under `title`."""
        answer = self._backend.generate(prompt, max_tokens=most, stop=stop, grammar=grammar)
        self._asked(answer.prompt or prompt.text + prompt.begun, answer.usage, ())
        self._artefacts.append(Artefact("answer", title, answer.text))
        return answer.text

    def choose(self, prompt: Prompt, options: Sequence[str]) -> str:
        """Let the model choose."""
        chosen: Selection = self._backend.choose(prompt, options)
        self._asked(chosen.prompt or prompt.text, chosen.usage, chosen.alternatives)
        return chosen.text.strip()

    def note(self, title: str, text: str) -> None:
        """Keep a remark for people."""
        self._artefacts.append(Artefact("note", title, text))

    def decision(self, skill: Skill, *made: Artefact) -> Decision:
        """Return the decision for `skill` with what led to it, and begin a new page."""
        closing = self.closing(*made)
        return Decision(
            skill, closing.prompt, closing.usage, closing.alternatives, closing.artefacts
        )

    def closing(self, *made: Artefact) -> Closing:
        """Return what led to saying done, and begin a new page."""
        closing = Closing(self._prompt, self._usage, self._alternatives, (*self._artefacts, *made))
        self._prompt, self._usage, self._alternatives = "", Usage(), ()
        self._artefacts = []
        return closing

    def _asked(self, prompt: str, usage: Usage, alternatives: tuple[Alternative, ...]) -> None:
        if self._prompt:
            earlier = Artefact("prompt", "Earlier prompt", self._prompt)
            self._artefacts.append(earlier)
        self._prompt = prompt
        self._usage += usage
        self._alternatives = alternatives
