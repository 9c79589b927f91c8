"""Behaviour sets whose parameters change on the way."""

from __future__ import annotations

import dataclasses

from tests.plugins.mrta_alliance.team import agent, announced, behaviour_set, motivations, nested, step


def test_a_retuned_behaviour_set_goes_on_from_its_motivation_at_its_new_rate() -> None:
    """Two cycles of 1, then one of 4, and of 30 / 120 once robot9 has been heard and has reset it."""
    one = agent(
        "robot1", nested(behaviour_set("patrol"), behaviour_set("inspect", fast_rate=2.0)), ["patrol", "inspect"]
    )
    step(one, 1.0)
    step(one, 1.2)
    one.retune(dataclasses.replace(one.behaviour_sets["patrol"], fast_rate=4.0, task_expected_duration=90.0))
    said = motivations(step(one, 1.4))
    assert (said["patrol"]["motivation"], said["inspect"]["motivation"]) == (6.0, 6.0)
    step(one, 1.6, [announced("robot9", "patrol", 1.6, expected=120.0)])
    assert motivations(step(one, 1.8))["patrol"]["motivation"] == 0.25


def test_retuning_does_not_forget_who_was_heard() -> None:
    """A second announcement resets nothing; the first one was before the parameters changed."""
    one = agent("robot1", nested(behaviour_set("patrol")), ["patrol"])
    assert motivations(step(one, 1.0, [announced("robot9", "patrol", 1.0)]))["patrol"]["resetted"]
    one.retune(dataclasses.replace(one.behaviour_sets["patrol"], yielding_delay=5.0))
    assert not motivations(step(one, 1.2, [announced("robot9", "patrol", 1.2)]))["patrol"]["resetted"]
    assert one.behaviour_sets["patrol"].yielding_delay == 5.0
