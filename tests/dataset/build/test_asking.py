"""Asking: answers are kept, so that a killed run goes on for nothing."""

import json

import pytest

from reibench.backends.scripted import ScriptedBackend
from reibench.dataset.build.asking import Asker, Unfit


def word(answer):
    if " " in answer:
        raise Unfit("several words", "One word only.")
    return answer


def test_an_answer_that_is_there_is_not_asked_for_again(tmp_path):
    first = Asker(ScriptedBackend(["yes"]), tmp_path)
    assert first.ask("Well?", word) == "yes"
    again = Asker(ScriptedBackend([]), tmp_path)
    assert again.ask("Well?", word) == "yes"
    assert (first.asked, first.from_cache, again.asked, again.from_cache) == (1, 0, 0, 1)


def test_unfit_answers_are_kept_too_so_that_a_resumed_run_takes_the_same_path(tmp_path):
    assert Asker(ScriptedBackend(["oh no", "yes"]), tmp_path).ask("Well?", word) == "yes"
    again = Asker(ScriptedBackend([]), tmp_path)
    assert again.ask("Well?", word) == "yes"
    assert again.from_cache == 2


def test_another_model_another_question_and_another_length_are_asked_anew(tmp_path):
    Asker(ScriptedBackend(["yes"]), tmp_path).ask("Well?", word)
    other = Asker(ScriptedBackend(["no"], name="scripted:other"), tmp_path)
    assert other.ask("Well?", word) == "no"
    assert Asker(ScriptedBackend(["hm"]), tmp_path).ask("Really?", word) == "hm"
    assert Asker(ScriptedBackend(["longer"]), tmp_path, max_tokens=5).ask("Well?", word) == "longer"
    assert len(list(tmp_path.glob("*.json"))) == 4


def test_what_is_kept_says_who_was_asked_what(tmp_path):
    Asker(ScriptedBackend(["yes"]), tmp_path).ask("Well?", word)
    [path] = tmp_path.iterdir()
    kept = json.loads(path.read_text())
    assert (kept["backend"], kept["prompt"], kept["answer"]) == ("scripted:list", "Well?", "yes")


def test_after_the_last_retry_the_last_complaint_is_raised():
    with pytest.raises(Unfit, match="One word only"):
        Asker(ScriptedBackend(["a b", "c d"]), retries=1).ask("Well?", word)
