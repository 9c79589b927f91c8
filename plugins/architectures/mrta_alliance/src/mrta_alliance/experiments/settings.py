"""Parameters of all behaviour sets of all robots alike, as an experiment takes them."""

from __future__ import annotations

from typing import Tuple

from mrta_alliance.parameters import BehaviourSetParameters

__all__ = ["UNTUNED", "every_set"]

_PATHS = {
    "task_expected_duration": "task_expected_duration",
    "threshold": "motivational_behaviour/threshold",
    "yielding_delay": "motivational_behaviour/acquiescence/yielding_delay",
    "giving_up_delay": "motivational_behaviour/acquiescence/giving_up_delay",
    "fast_rate": "motivational_behaviour/impatience/fast_rate",
    "head_start": "motivational_behaviour/impatience/head_start",
    "fairness": "motivational_behaviour/impatience/fairness",
}


def every_set(**values: float) -> Tuple[str, ...]:
    """Give settings for every behaviour set of every robot.

    Args:
        values: by attribute of BehaviourSetParameters.
    """
    return tuple(f"behaviour_sets/behaviour_set@index@/{_PATHS[name]}={value!r}" for name, value in values.items())


_DEFAULTS = BehaviourSetParameters("any")

UNTUNED: Tuple[str, ...] = every_set(
    task_expected_duration=_DEFAULTS.task_expected_duration,
    threshold=_DEFAULTS.threshold,
    yielding_delay=_DEFAULTS.yielding_delay,
    giving_up_delay=_DEFAULTS.giving_up_delay,
    fast_rate=_DEFAULTS.fast_rate,
    head_start=0.5,
)
"""ALLIANCE as its template has it, whatever the application's file says: all robots and tasks alike."""
