"""Where a study stands: people by what became of them, cells by how full they are."""

from collections import Counter
from typing import Any

from study.enrolment import Enrolment


def status_of(enrolment: Enrolment, name: str, *, simulated: bool = False) -> dict[str, Any]:
    """Return a study's people by state, real or simulated, and the trials held at each level."""
    study = enrolment.study(name)
    [about] = [row for row in enrolment.studies() if row["name"] == name]
    people = enrolment.store.query(
        "select state, count(*) as number from participants where study = ? and simulated = ?"
        " group by state",
        [name, simulated],
    )
    filled = enrolment.filled(study, simulated=simulated)
    levels: Counter[str] = Counter({str(episode.vagueness): 0 for episode in study.chosen()})
    for episode, number in filled.items():
        levels[episode.rpartition(".")[2]] += number
    return {
        "study": name,
        "version": about["version"],
        "state": about["state"],
        "planned": study.people,
        "people": {row["state"]: row["number"] for row in people},
        "cells": dict(levels),
    }


def overview(enrolment: Enrolment) -> list[dict[str, Any]]:
    """Return every study with its state and how many people it has."""
    return enrolment.store.query(
        "select name, s.version, s.state, s.created,"
        " coalesce(sum(p.state = 'active' and not simulated), 0) as active,"
        " coalesce(sum(p.state = 'finished' and not simulated), 0) as finished,"
        " coalesce(sum(simulated), 0) as simulated"
        " from studies as s left join participants as p on p.study = name group by name"
        " order by name"
    )
