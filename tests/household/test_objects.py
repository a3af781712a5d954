import pytest

from reibench.errors import UnknownName
from reibench.household.objects import object_type, object_types, type_of


def test_every_type_of_the_skill_list_is_known():
    from reibench.skill import FINDABLE

    assert not [name for name in FINDABLE if name not in object_types()]


def test_an_unknown_type_is_told_with_the_nearest_known_one():
    with pytest.raises(UnknownName, match="Did you mean 'Fridge'"):
        object_type("Frigde")


def test_an_apple_can_be_picked_up_and_sliced_but_holds_nothing():
    traits = object_type("Apple").traits
    assert {"pickupable", "sliceable"} <= traits
    assert "receptacle" not in traits


def test_a_tomato_in_the_microwave_is_alfreds_idea_and_not_ai2_thors():
    tomato = object_type("Tomato")
    assert not tomato.may_go("Microwave")
    assert tomato.belongs("Microwave")


@pytest.mark.parametrize(
    ("object_id", "kind"),
    [
        ("Apple|+00.10|+00.90|-01.00", "Apple"),
        ("Sink|+00.10|+00.90|-01.00|SinkBasin", "SinkBasin"),
        ("Apple|+00.10|+00.90|-01.00|AppleSliced_3", "AppleSliced"),
        ("Egg|+00.10|+00.90|-01.00|EggCracked_0", "EggCracked"),
    ],
)
def test_an_id_tells_the_type(object_id, kind):
    assert type_of(object_id) == kind


def test_only_enclosing_types_have_to_be_open():
    assert object_type("Fridge").encloses
    assert not object_type("Book").encloses
