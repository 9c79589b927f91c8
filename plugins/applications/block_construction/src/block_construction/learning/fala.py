"""The finite action-set learning automaton (FALA): probabilities of actions are what is learned.

Symbols: p_i probability of action i, k number of actions, b reward from 0 to 1, l1 rate of reward, l2 rate of penalty.
L_R-P has l1 = l2; L_R-eps-P a small l2; L_R-I l2 = 0, with which 2.1 and 2.2 become 2.3 and 2.4; L_I-P l1 = 0.
"""

from __future__ import annotations

__all__ = ["chosen_probability", "other_probability"]


def chosen_probability(p: float, b: float, l1: float, l2: float) -> float:
    """Give the new probability of the action that was chosen.

        p_i <- p_i + l1 b (1 - p_i) - l2 (1 - b) p_i

    Dantas (2017), equation 2.1; with l2 = 0 equation 2.3.
    """
    return p + l1 * b * (1.0 - p) - l2 * (1.0 - b) * p


def other_probability(p: float, b: float, l1: float, l2: float, k: int) -> float:
    """Give the new probability of an action that was not chosen, of k > 1.

        p_i <- p_i - l1 b p_i + l2 (1 - b) (1 / (k - 1) - p_i)

    Dantas (2017), equation 2.2; with l2 = 0 equation 2.4.
    """
    return p - l1 * b * p + l2 * (1.0 - b) * (1.0 / (k - 1) - p)
