"""The reward of an automaton, from what it remembers."""

from __future__ import annotations

__all__ = ["reward"]


def reward(mean: float, least: float, cost: float) -> float:
    """Tell how much better a run was than an automaton's recent ones: equation 5.6.

        b = min(max(0, (J_med - J(t)) / (J_med - J_min)), 1)

    Args:
        mean: J_med, of the costs it remembers, this run's included.
        least: J_min, the least of them.
        cost: J(t), of this run.

    Returns:
        b, from 0 to 1; 0 where all that is remembered cost the same.

    Dantas (2017), equation 5.6.
    """
    spread = mean - least
    if spread <= 0.0:
        return 0.0
    return min(max(0.0, (mean - cost) / spread), 1.0)
