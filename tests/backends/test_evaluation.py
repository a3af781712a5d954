"""What is kept of earlier prompts saves work and changes no answer, whatever model it is."""

import pytest

from reibench.backends.transformers.evaluation import Evaluator
from tests.backends.tiny import FAMILIES, network

A, B = list(range(10, 34)), list(range(40, 64))
ASKED = [A[:16], A, [*A[:20], 7, 8, 9], A[:8], A[:8], B, [*A, 5], [*B, 5, 6], A[:12], [*B[:4], 9]]
"""Longer, parting, shorter, the same again, another, and back to what may be kept or not."""


@pytest.mark.parametrize("family", FAMILIES)
def test_scores_are_those_of_evaluating_everything(family):
    import torch

    model = network(family, vocab_size=80).eval()
    evaluator = Evaluator(model, slots=2)
    for tokens in ASKED:
        with torch.inference_mode():
            whole = model(torch.tensor([tokens]), use_cache=False).logits[0, -1]
        assert torch.allclose(evaluator.scores(tokens), whole, atol=1e-3)
    assert whole.std() > 1  # weights large enough that answers hang on what was said


@pytest.mark.parametrize("family", FAMILIES)
def test_what_goes_on_from_a_kept_prompt_is_all_that_is_evaluated(family):
    evaluator = Evaluator(network(family, vocab_size=80).eval(), slots=2)
    evaluator.scores(A[:16])
    assert evaluator.evaluated == 16
    evaluator.scores(A)
    assert evaluator.evaluated == len(A)


def test_a_prompt_that_parts_from_a_kept_one_is_evaluated_from_there():
    evaluator = Evaluator(network("llama", vocab_size=80).eval(), slots=2)
    evaluator.scores(A)
    for tokens, new in (([*A[:20], 7], 1), ([*A[:6], 8, 9], 2), (A[:20], 1)):
        before = evaluator.evaluated
        evaluator.scores(tokens)
        assert evaluator.evaluated - before == new
