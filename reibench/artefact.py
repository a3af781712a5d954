"""Artefacts: what a method or planner made on its way, kept so that people can look at it."""

from dataclasses import dataclass
from typing import Literal

Kind = Literal["note", "prompt", "answer", "graph", "memory", "pddl", "plan"]


@dataclass(frozen=True)
class Artefact:
    """One thing that was made: a graph of sub-tasks, a memory, a PDDL goal, a further prompt."""

    kind: Kind
    """note: plain words, e.g. which pattern a gate found. prompt, answer: a question to the model
    beside the one that chose the skill. graph: JSON, see `planners.dag_plan`. memory: one line an
    entry. pddl: problem or goal. plan: one action a line."""
    title: str
    text: str
