"""The study's bench counts everybody, and people who think are no load at all times."""

import json

from study.__main__ import main


def test_everybody_is_accounted_for(capsys):
    assert main(["bench", "--participants", "3", "--pause", "0.02", "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert (result["participants"], result["accounted_for"]) == (3, 3)
    assert result["finished"] <= 3
    assert result["steps"] > 3
    assert result["step_p50_ms"] <= result["step_p99_ms"]


def test_an_odd_pause_is_refused(capsys):
    assert main(["bench", "--pause", "-1"]) == 2
    assert "--pause" in capsys.readouterr().err
