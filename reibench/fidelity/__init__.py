"""Fidelity: how much of ALFRED's trials the embedded world restores, and how many it can solve."""

from reibench.fidelity.report import fidelity_report

__all__ = ["fidelity_report"]
