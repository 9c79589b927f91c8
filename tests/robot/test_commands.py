"""What a robot is told to drive, tick by tick."""

from __future__ import annotations

import math
from typing import Dict, List, Sequence, Tuple

import pytest

from rqt_mrta_py.hooks import Command
from rqt_mrta_py.model import Twist
from rqt_mrta_py.robot.commands import Commander

ON = (Command("base", Twist(0.4, 0.0, 0.0)), Command("arm", 0.7))


def said(commander: Commander, commands: Sequence[Command]) -> List[Tuple[str, Dict[str, object]]]:
    return [(message.topic, dict(message.fields)) for message in commander.publish(commands)]


DRIVING = [("cmd_vel", {"linear": {"x": 0.4, "y": 0.0}, "angular": {"z": 0.0}}), ("arm/command", {"data": 0.7})]
STILL = [("cmd_vel", {"linear": {"x": 0.0, "y": 0.0}, "angular": {"z": 0.0}}), ("arm/command", {"data": 0.0})]


def test_commands_that_are_repeated_are_said_at_every_tick() -> None:
    commander = Commander()
    assert [said(commander, ON) for _ in range(3)] == [DRIVING] * 3


def test_what_is_commanded_no_more_is_stopped_once_and_goes_on_when_it_is_commanded_anew() -> None:
    commander = Commander()
    assert [said(commander, each) for each in (ON, ON, (), (), ON)] == [DRIVING, DRIVING, STILL, [], DRIVING]


def test_an_actuator_that_is_left_out_is_stopped_once_though_the_others_repeat() -> None:
    commander = Commander()
    base = ON[:1]
    assert [said(commander, each) for each in (ON, base, base)] == [DRIVING, [DRIVING[0], STILL[1]], [DRIVING[0]]]


def test_a_list_that_a_behaviour_fills_anew_is_read_anew() -> None:
    commander = Commander()
    commands = list(ON)
    assert said(commander, commands) == DRIVING
    commands[0] = Command("base", Twist())
    assert said(commander, commands) == [STILL[0], DRIVING[1]]


def test_a_repetition_after_a_refusal_is_refused_too() -> None:
    commander = Commander()
    twice = (ON[1], ON[1])
    for _ in range(2):
        with pytest.raises(ValueError, match=r"^two commands to 'arm' in one tick; at most one is accepted$"):
            commander.publish(twice)


def test_commands_that_change_at_every_tick_are_said_as_they_are() -> None:
    commander = Commander()
    # Finite each, though their sum is not.
    fast = (Command("base", Twist(1e308, 1e308, 0.0)),)
    slow = [Command("base", Twist(0.1, 0.0, -0.2))]
    assert said(commander, fast) == [("cmd_vel", {"linear": {"x": 1e308, "y": 1e308}, "angular": {"z": 0.0}})]
    assert said(commander, slow) == [("cmd_vel", {"linear": {"x": 0.1, "y": 0.0}, "angular": {"z": -0.2}})]


@pytest.mark.parametrize("twist", [Twist(math.nan), Twist(vy=math.inf), Twist(wz=-math.inf)])
def test_a_velocity_that_is_not_finite_in_any_part_is_refused(twist: Twist) -> None:
    with pytest.raises(ValueError, match=r"^a command to 'base' of Twist\(.*\); only finite numbers are accepted$"):
        Commander().publish((Command("base", twist),))
