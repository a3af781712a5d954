"""The lexicon: what it holds, and how a part of it is held out."""

import pytest

from reibench.dataset.forms import names, says
from reibench.dataset.lexicon import LEAST, expressions, held_out
from reibench.dataset.seeds import kind_of
from reibench.errors import ReibenchError
from reibench.household.objects import object_types


def test_every_type_has_enough_expressions_and_none_twice():
    for name in names():
        mine = [each.text for each in expressions()[name]]
        assert len(mine) >= LEAST, name
        assert len(mine) == len(set(mine)), name


def test_every_task_object_has_enough_that_anybody_may_say():
    for name in names():
        try:
            kind_of(name)
        except KeyError:
            continue  # only ever a distractor
        assert sum(each.is_free for each in expressions()[name]) >= LEAST, name


def test_expressions_never_name_their_object_unless_they_are_nearly_names():
    for name, mine in expressions().items():
        for each in mine:
            if each.is_free and name in names():
                assert not any(says(each.text, word) for word in names()[name].words), each


def test_what_else_an_expression_fits_are_other_object_types():
    for name, mine in expressions().items():
        for each in mine:
            assert each.also_fits <= set(object_types()), each
            assert name not in each.also_fits, each


def test_held_out_and_kept_are_all_there_is_and_share_nothing():
    kept, out = held_out(0.3, seed=4)
    for name, mine in expressions().items():
        assert {*kept[name], *out[name]} == set(mine)
        assert not {*kept[name]} & {*out[name]}
        assert len(out[name]) == max(1, round(0.3 * len(mine)))
    assert (kept, out) == held_out(0.3, seed=4)
    assert kept != held_out(0.3, seed=5)[0]


def test_nothing_is_held_out_by_default_and_not_everything_can_be():
    assert held_out(0) == (expressions(), {})
    with pytest.raises(ReibenchError, match=r"from 0 up to, not including, 1.*1\.5"):
        held_out(1.5)
