"""Step 3, replacement: names give way to pronouns and descriptions (appendix B.3)."""

from collections.abc import Sequence

from reibench.dataset.build.asking import Asker
from reibench.dataset.build.generation import things_of
from reibench.dataset.build.marking import named_mentions, replaced
from reibench.dataset.build.seeding import SeedInstruction
from reibench.dataset.build.speech import read_dialogue, show
from reibench.dataset.forms import names
from reibench.dataset.levels import derive
from reibench.dataset.scripts import Script

REPLACEMENT = """\
Please do not include the word "{words}" in the sentence "{request}" but do not change the \
original meaning of this dialogue. You can use some descriptive language to replace the word \
{words} itself.

Requirements:

1. Please output the whole new dialogue

2. You must output the whole new dialogue, including all the sentences from Alice and Robot

3. {retain}

4. You need to output the complete multi-turn dialogue, including the multiple turns of language \
from both Alice and the robot.

Here is an example:

{example}

Here is the dialogue:

{dialogue}

Output:

"""
RETAIN = (
    'Please retain every instance of "{words}" in the previous text, except for replacing "{words}"'
    " in the last sentence spoken by Alice."
)
"""The paper's third requirement: it makes the mixed level."""
REPLACE = (
    'Please retain only the first instance of "{words}" in the whole dialogue, and replace every'
    " other one by a pronoun or by descriptive language, changing nothing else."
)
"""Ours, for the implicit level, of which the paper has an example but no prompt. Its {Example} is
not given either: ours is a written dialogue before and after."""


def replace_mentions(
    seed: SeedInstruction, turns: Sequence[str], asker: Asker, examples: Sequence[Script]
) -> list[list[str]]:
    """Return what takes the place of each counted mention, by turn; the first ones keep theirs.

    The request's come from the mixed level, those of the context from the implicit one.

    Raises:
        Unfit: when the answers differ from the dialogue in anything but the mentions.
    """
    things = things_of(seed)
    marks = [named_mentions(text, things) for text in turns]

    def of_request(answer: str) -> list[str]:
        return replaced(turns[-1], marks[-1], read_dialogue(answer)[-1], things)

    request = asker.ask(_prompt(seed, turns, examples, RETAIN), of_request)

    def of_context(answer: str) -> list[list[str]]:
        answers = read_dialogue(answer)
        fresh = {of for of, _ in things if of != "destination"}
        found = []
        for old, mine, new in zip(turns[:-1], marks[:-1], answers[:-1], strict=True):
            kept = []
            for mention in mine:
                if mention.of in fresh:
                    fresh.discard(mention.of)
                else:
                    kept.append(mention)
            found.append(replaced(old, kept, new, things))
        return found

    context = asker.ask(_prompt(seed, turns, examples, REPLACE), of_context)
    return [*context, request]


def _prompt(
    seed: SeedInstruction, turns: Sequence[str], examples: Sequence[Script], rule: str
) -> str:
    words = " and ".join(names()[name].words[-1] for name in seed.counted)
    others = [script for script in examples if script.goal.object not in seed.counted]
    levels = derive(others[0])
    after = levels[3] if rule == RETAIN else levels[6]
    example = "\n\n".join(
        show([utterance.text for utterance in episode.dialogue.utterances])
        for episode in (levels[0], after)
    )
    return REPLACEMENT.format(
        words=words,
        request=turns[-1],
        retain=rule.format(words=words),
        example=example,
        dialogue=show(turns),
    )
