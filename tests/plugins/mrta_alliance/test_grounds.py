"""What moved motivations, told from messages written by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List, Tuple

import pytest
from mrta_alliance.grounds import AllianceGrounds

from rqt_mrta_py.hooks import GroundsSetup, Heard
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Ground, Mission, Task, Taxonomy
from tests.plugins.mrta_alliance.team import announced, behaviour_set, nested

FOREIGN = Mission(ApplicationSpec("", ""), ArchitectureSpec("mrta_alliance", "ALLIANCE", Taxonomy()), ())
YARD = replace(
    FOREIGN,
    application=ApplicationSpec("yard", "Yard", robots=(ApplicationRobot("one"),)),
    tasks=(Task("patrol", "patrol"),),
    parameters={"one": nested(behaviour_set("patrol"))},
)


def felt(receipt: float, task: str = "patrol", robot: str = "one", **given: Any) -> Heard:
    fields: Dict[str, Any] = {
        "header/frame_id": f"/{robot}",
        "task_id": task,
        "impatience": 1.0,
        "acquiescent": False,
        "suppressed": False,
        "resetted": False,
        "applicable": True,
        "motivation": 0.0,
        "threshold": 30.0,
        "active": False,
        **given,
    }
    return Heard(f"/{robot}/alliance/motivation/{task}", "alliance_msgs/Motivation", receipt, fields, robot, task)


def told(*messages: Heard, mission: Mission = FOREIGN) -> List[Ground]:
    reader = AllianceGrounds(GroundsSetup(mission))
    return [ground for message in messages for ground in reader.hear(message)]


def texts(*messages: Heard, mission: Mission = FOREIGN) -> List[Tuple[float, str]]:
    return [(ground.time, ground.text) for ground in told(*messages, mission=mission)]


GROWS = (0.2, "motivation grows by 1 a cycle towards the threshold 30")


def test_a_motivation_that_grows_as_before_is_told_once() -> None:
    assert texts(felt(0.2, motivation=1.0), felt(0.4, motivation=2.0), felt(0.6, motivation=3.0)) == [GROWS]


def test_a_set_that_becomes_active_says_how_long_its_motivation_grew() -> None:
    (_, ground) = told(felt(0.2, motivation=1.0), felt(3.0, motivation=29.0), felt(6.0, motivation=30.0, active=True))
    assert ground == Ground(
        6.0,
        "patrol",
        "motivation reached the threshold 30 after 5.8 s: becomes active",
        "one",
        {"motivation": 30.0, "threshold": 30.0, "impatience": 1.0},
    )


def test_growth_counts_from_the_last_fall() -> None:
    messages = (
        felt(0.2, motivation=20.0),
        felt(2.0, motivation=0.0),
        felt(4.0, motivation=1.0),
        felt(9.0, motivation=30.0, active=True),
    )
    assert texts(*messages)[-1][1] == "motivation reached the threshold 30 after 5.0 s: becomes active"


def test_impatience_that_falls_and_rises_is_told_with_who_announces_the_task() -> None:
    """By equation 3.7 it falls while another robot is heard on the task, and rises once that has had its time."""
    messages = (
        felt(0.2),
        announced("two", "patrol", 4.1),
        felt(4.2, impatience=0.5),
        felt(10.0, impatience=1.0),
        announced("two", "patrol", 20.0),
        felt(20.2, impatience=0.5),
        announced("two", "patrol", 30.0),
        felt(30.2, impatience=1.0),
    )
    assert texts(*messages)[1:] == [
        (4.2, "impatience falls from 1 to 0.5 a cycle, while two announces it"),
        (10.0, "impatience rises from 0.5 to 1 a cycle: nobody else announces it"),
        (20.2, "impatience falls from 1 to 0.5 a cycle, while two announces it"),
        (30.2, "impatience rises from 0.5 to 1 a cycle, though two announces it"),
    ]


def test_impatience_that_changes_little_by_little_is_told_when_it_has_changed_by_a_tenth() -> None:
    rates = (1.0, 1.05, 1.09, 1.12, 1.15, 1.2)
    assert [time for time, _ in texts(*(felt(float(n), impatience=rate) for n, rate in enumerate(rates)))] == [0.0, 3.0]


def test_a_reset_names_who_announced_the_task() -> None:
    messages = (felt(0.2), announced("two", "patrol", 0.3), felt(0.4, resetted=True), felt(0.6, resetted=True))
    assert texts(*messages) == [GROWS, (0.4, "reset to 0: two has announced it")]


@pytest.mark.parametrize("active_first", [True, False])
def test_a_suppressed_set_names_the_one_that_suppresses_it_though_that_be_said_later(active_first: bool) -> None:
    patrol = felt(3.6, motivation=30.0, active=True)
    inspect = felt(3.6, "inspect", suppressed=True)
    pair = (patrol, inspect) if active_first else (inspect, patrol)
    messages = (felt(3.4, motivation=29.0), felt(3.4, "inspect"), *pair)
    (ground,) = [each for each in told(*messages) if each.task == "inspect" and each.time == 3.6]
    assert ground.text == "suppressed by its patrol"


def test_a_suppressed_set_of_whose_suppressor_nothing_is_heard_is_told_all_the_same() -> None:
    messages = (felt(0.2), felt(0.4, suppressed=True), felt(1.0, suppressed=True), felt(1.6, suppressed=True))
    assert texts(*messages) == [GROWS, (0.4, "suppressed by another behaviour set")]


def test_a_set_that_is_free_again_says_so() -> None:
    messages = (felt(0.1, "inspect", active=True), felt(0.2, suppressed=True), felt(5.0, "inspect"), felt(5.2))
    assert texts(*messages)[-1] == (5.2, "no longer suppressed")


@pytest.mark.parametrize(
    ("announces", "mission", "text"),
    [
        ((), FOREIGN, "acquiescent: gives it up after 40.0 s"),
        ((), YARD, "acquiescent: gives it up after 40.0 s (lambda 40 s)"),
        (("two",), FOREIGN, "acquiescent: yields to two after 40.0 s"),
        (("two",), YARD, "acquiescent: yields to two after 40.0 s (psi 20 s)"),
    ],
)
def test_acquiescence_tells_after_what_time_and_by_which_delay(
    announces: Tuple[str, ...], mission: Mission, text: str
) -> None:
    """Delays psi and lambda are those of the recording of the original nodes."""
    others = [announced(robot, "patrol", 49.9) for robot in announces]
    messages = (felt(10.0, active=True), *others, felt(50.0, acquiescent=True))
    assert texts(*messages, mission=mission)[-1] == (50.0, text)


def test_sensors_that_change_their_mind_are_told() -> None:
    messages = (felt(0.2), felt(1.0, applicable=False), felt(1.2, applicable=False), felt(2.0))
    assert texts(*messages) == [
        GROWS,
        (1.0, "the sensors do not find it applicable"),
        (2.0, "the sensors find it applicable"),
    ]


def test_a_set_that_is_let_go_without_a_sign_says_that_there_is_none() -> None:
    assert texts(felt(0.2, active=True), felt(5.0))[-1] == (5.0, "no longer active, and no reason is told")


def test_a_value_that_is_no_number_is_left_out() -> None:
    (ground,) = told(felt(0.2, motivation=float("nan")))
    assert ground.values == {"threshold": 30.0, "impatience": 1.0}
