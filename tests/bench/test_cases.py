"""The bench of the case pages fills a database and times real answers."""

import json

from reibench.__main__ import main


def test_it_counts_what_it_made_and_times_every_kind_of_answer(capsys):
    assert main(["bench", "cases", "--records", "300", "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert result["records"] == 300
    assert result["steps"] > 300
    timed = {name: value for name, value in result.items() if name.endswith("_ms")}
    assert len(timed) == 7
    assert all(value > 0 for value in timed.values())


def test_many_more_records_make_a_filter_little_slower(capsys):
    medians = []
    for records in ("300", "2400"):
        main(["bench", "cases", "--records", records, "--json"])
        result = json.loads(capsys.readouterr().out)
        medians.append(result["filter_change_median_ms"])
    assert medians[1] < 10 * medians[0]


def test_an_empty_database_is_no_bench(capsys):
    assert main(["bench", "cases", "--records", "0"]) == 2
    assert "--records 0" in capsys.readouterr().err
