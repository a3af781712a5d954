"""An analysis as lines of text."""

from collections.abc import Mapping
from typing import Any


def lines(found: Mapping[str, Any]) -> list[str]:
    """Return an analysis as text."""
    who = ", ".join(f"{number} {state}" for state, number in found["states"].items() if number)
    told = [
        f"{found['study']}: {found['people']} people ({who}), {found['trials']} finished trials"
    ]
    for title, key in (("all", "overall"), ("by level", "by_level"), ("by type", "by_task_type")):
        told.append(f"success {title}:")
        for row in found[key]:
            label = row[{"overall": "all", "by_level": "level", "by_task_type": "task_type"}[key]]
            told.append(
                f"  {label:<34} {row['success']:>4} of {row['episodes']:<4}"
                f" {_percent(row['success_rate'])} [{_percent(row['success_low'])},"
                f" {_percent(row['success_high'])}]  object omission {row['object_omission']},"
                f" execution error {row['execution_error']}"
            )
    for key in ("seconds_a_step", "steps_per_expert_step"):
        spread = found[key]
        if spread["number"]:
            told.append(
                f"{key.replace('_', ' ')}: median {spread['median']:.2f}"
                f" (quartiles {spread['low']:.2f} to {spread['high']:.2f})"
            )
    same = found["agreement"]
    if same["pairs"]:
        told.append(f"two people on one episode agree: {same['same']} of {same['pairs']} pairs")
    if found["meant"]:
        told.append("named the object that was meant:")
    told += [
        f"  {row['reference']:<34} {row['right']:>4} of {row['asked']:<4}"
        f" {_percent(row['right'] / row['asked'])} [{_percent(row['low'])},"
        f" {_percent(row['high'])}]"
        for row in found["meant"]
    ]
    for one, fit in zip(found["versus"], found["model"], strict=True):
        told += _versus_lines(one, fit)
    return told


def _versus_lines(one: Mapping[str, Any], fit: Mapping[str, Any]) -> list[str]:
    if not one["trials"]:
        return [f"people and {one['planner']} ({one['run']}) share no episode"]
    told = [
        f"people against {one['planner']} ({one['run']}), {one['trials']} trials on"
        f" {one['episodes']} episodes: {_percent(one['person'])} and {_percent(one['other'])},"
        f" {one['only_person']} : {one['only_other']}, McNemar p = {one['p']:.3g},"
        f" difference {100 * one['difference']:+.1f} points"
        f" [{100 * one['low']:+.1f}, {100 * one['high']:+.1f}]"
    ]
    if "note" in fit:
        return [*told, f"  mixed-effects model: {fit['note']}"]
    return [
        *told,
        f"  mixed-effects logistic model: log odds of a person {fit['person_log_odds']:+.2f}"
        f" [{fit['low']:+.2f}, {fit['high']:+.2f}]",
    ]


def _percent(value: float) -> str:
    return f"{100 * value:.1f}%"
