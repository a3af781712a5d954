"""Grammar that a program can see: doubled words, a and an, capitals, and number."""

import re
from collections.abc import Iterator

from reibench.dataset.forms import is_plural, unnamed_form

SINGULAR = frozenset(("it", "its", "this", "that", "one", "one of those", "one of these"))
PLURAL = frozenset(("they", "them", "their", "these", "those", "both", "some"))
TWICE = frozenset("bye had is knock long no now so that very yes".split())
"""Words that may stand twice in a row."""
_SILENT_H = ("hour", "honest", "honour", "honor", "heir")
_LIKE_Y = ("one", "once", "uni", "use", "usu", "eu", "ewe", "u-")
_LETTERS = re.compile(r"[AEFHILMNORSX](?:[A-Z]|\b)")
_SMALL_START = re.compile(r"(?:^|(?<!Mr|Ms|Dr|St)(?<!Mrs)[.!?] )([a-z]\w*)")


def text_problems(text: str) -> Iterator[str]:
    """Yield what is wrong with a text's letters and words, however it came about."""
    for found in re.finditer(r"\b(\w+) \1\b", text, re.IGNORECASE):
        if found[1].lower() not in TWICE:
            yield f"{found[0]!r} is doubled"
    for found in re.finditer(r"\b(an?) ([\w-]+)", text, re.IGNORECASE):
        if (found[1].lower() == "an") != _sounds_like_a_vowel(found[2]):
            yield f"{found[0]!r}: a or an"
    for found in _SMALL_START.finditer(text):
        yield f"{found[1]!r} begins a sentence small"
    if odd := re.search(r" [,.;:!?]|\s\s|[“”’‘]|\.\.(?!\.)", text):
        yield f"{odd[0]!r} is odd spacing or a curly quote"


def article(word: str) -> str:
    """Return `a` or `an`, whichever stands before `word`."""
    return "an" if _sounds_like_a_vowel(word) else "a"


def _sounds_like_a_vowel(word: str) -> bool:
    low = word.lower()
    if low.startswith((*_SILENT_H, "8", "11-", "18-")) or low in ("11", "18"):
        return True
    if _LETTERS.match(word) and len(word) <= 3 and word.isupper():
        return True
    return low[0] in "aeiou" and not low.startswith(_LIKE_Y)


def agrees(unnamed: str, named: str, referent: str) -> bool:
    """Whether a pronoun has the number of the named mention it stands for."""
    word = unnamed.lower()
    if unnamed_form(word) != "pronoun":
        return True
    return word not in (SINGULAR if is_plural(named, referent) else PLURAL)
