"""What commands print can be read by whoever asked for it."""

import json

from reibench.commands.output import say_json


def refuse(name):
    raise AssertionError(f"{name} is no JSON")


def test_a_number_that_is_none_is_null_in_json(capsys):
    none = float("nan")
    say_json({"low": none, "all": [1.5, -float("inf"), (none, {"p": none, "n": 3})], "of": "NaN"})
    written = json.loads(capsys.readouterr().out, parse_constant=refuse)
    assert written == {"low": None, "all": [1.5, None, [None, {"p": None, "n": 3}]], "of": "NaN"}
