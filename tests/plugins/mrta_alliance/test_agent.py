"""The agent in scripted situations, cycle numbers and values calculated by hand."""

from __future__ import annotations

from typing import Dict

import pytest

from rqt_mrta_py.hooks import TaskReport
from rqt_mrta_py.model import Progress
from tests.plugins.mrta_alliance.team import (
    CYCLE,
    Team,
    agent,
    announced,
    announcements,
    behaviour_set,
    motivations,
    nested,
    step,
    time_of,
)

TASKS = ("patrol", "inspect")


def recorded_team() -> Team:
    """Two robots with the parameters of the recording of the original nodes."""
    rates: Dict[str, tuple] = {"robot1": (1.5, 1.0), "robot2": (1.0, 1.25)}
    return Team(
        {
            robot: agent(
                robot,
                nested(behaviour_set("patrol", patrol), behaviour_set("inspect", inspect)),
                TASKS,
                tuple(rates),
            )
            for robot, (patrol, inspect) in rates.items()
        },
        TASKS,
    )


def pair_on_one_task(expected: float) -> Team:
    return Team(
        {
            "robot1": agent("robot1", nested(behaviour_set("patrol", 1.5, expected)), ["patrol"]),
            "robot2": agent("robot2", nested(behaviour_set("patrol", 1.0, expected)), ["patrol"]),
        },
        ["patrol"],
    )


def test_agent_spins_at_its_spin_rate() -> None:
    assert agent("robot1", nested(behaviour_set("patrol"), spin_rate=8.0), ["patrol"]).rate == 8.0


def test_first_robot_becomes_active_in_cycle_20_and_says_so_at_once() -> None:
    """20 x 1.5 = 30; its inspect has grown to 19 x 1.0 and is suppressed in the same cycle."""
    team = recorded_team()
    before = motivations(team.step_to(19)["robot1"])
    assert (before["patrol"]["motivation"], before["inspect"]["motivation"]) == (28.5, 19.0)
    decision = team.step_to(20)["robot1"]
    said = motivations(decision)
    assert decision.task == "patrol"
    assert (said["patrol"]["motivation"], said["patrol"]["active"]) == (30.0, True)
    assert (said["inspect"]["motivation"], said["inspect"]["suppressed"]) == (0.0, True)
    (message,) = announcements(decision)
    assert message.fields == {
        "header": {"stamp": time_of(20), "frame_id": "/robot1"},
        "task_id": "patrol",
        "expected_duration": 60.0,
    }


def test_second_robot_is_reset_once_then_slow_then_takes_the_other_task() -> None:
    """Heard in cycle 21: patrol reset, then 30 / 60 = 0.5 a cycle; inspect 24 x 1.25 = 30 in cycle 24."""
    team = recorded_team()
    patrol = [motivations(team.step_to(cycle)["robot2"])["patrol"] for cycle in range(20, 26)]
    assert [said["motivation"] for said in patrol] == [20.0, 0.0, 0.5, 1.0, 1.5, 0.0]
    assert [said["impatience"] for said in patrol] == [1.0, 0.5, 0.5, 0.5, 0.5, 0.5]
    assert [said["resetted"] for said in patrol] == [False, True, False, False, False, False]
    assert [said["suppressed"] for said in patrol] == [False] * 5 + [True]
    assert team.decisions["robot2"].task == "inspect"
    other = motivations(team.decisions["robot1"])["inspect"]
    assert (other["impatience"], other["resetted"], other["suppressed"]) == (0.5, True, True)


def test_announcements_keep_their_period_though_cycles_do_not_meet_it() -> None:
    """Due at 4.8, 5.3, 5.8, ...: cycles of 0.2 s meet 4.8, 5.4, 5.8, 6.4, 6.8 (gaps 0.6 and 0.4, as recorded)."""
    team = recorded_team()
    spoken = [cycle for cycle in range(1, 32) if announcements(team.step()["robot1"])]
    assert [round(time_of(cycle), 9) for cycle in spoken] == [4.8, 5.4, 5.8, 6.4, 6.8]


def test_robot_gives_up_after_lambda_and_begins_anew() -> None:
    """Active since 4.8 (cycle 20): 44.8 is not more than 40 s later, 45.0 (cycle 221) is; 20 cycles later again."""
    team = recorded_team()
    assert team.step_to(220)["robot1"].task == "patrol"
    decision = team.step_to(221)["robot1"]
    said = motivations(decision)
    assert decision.task is None
    assert announcements(decision) == []
    assert (said["patrol"]["acquiescent"], said["patrol"]["motivation"]) == (True, 0.0)
    # robot2 is on inspect, heard for the first time 40 s ago (less than 60): 30 / 60 from 0.
    assert (said["inspect"]["suppressed"], said["inspect"]["motivation"]) == (False, 0.5)
    assert motivations(team.step_to(222)["robot1"])["patrol"]["motivation"] == 1.5
    assert team.step_to(240)["robot1"].task is None
    assert team.step_to(241)["robot1"].task == "patrol"


def test_impatience_is_fast_again_once_phi_has_passed() -> None:
    """robot1 heard first at 4.8 (cycle 20): 60 s later is cycle 320; from then on robot2's patrol grows by 1.0."""
    team = recorded_team()
    impatience = [motivations(team.step_to(cycle)["robot2"])["patrol"]["impatience"] for cycle in (319, 320)]
    assert impatience == [0.5, 1.0]


def test_silent_robot_is_replaced_within_tau_and_the_time_of_growth() -> None:
    """robot1 speaks last in cycle 40, at 8.8, and stops.

    Slow rate 30 / 6000 = 0.005 in cycles 22 to 49 makes 0.14. At 10.8 (cycle 50) it has been silent for tau = 2 s;
    0.14 + 30 x 1.0 reaches 30 in cycle 79, at 16.6; promised is 8.8 + 2 + 30 / (1.0 x 5) + 0.2 = 17.0.
    """
    team = pair_on_one_task(expected=6000.0)
    assert len(announcements(team.step_to(40)["robot1"])) == 1
    team.stopped.append("robot1")
    assert motivations(team.step_to(49)["robot2"])["patrol"]["motivation"] == pytest.approx(0.14)
    assert motivations(team.step_to(50)["robot2"])["patrol"]["motivation"] == pytest.approx(1.14)
    assert team.step_to(78)["robot2"].task is None
    assert team.step_to(79)["robot2"].task == "patrol"
    assert time_of(79) <= time_of(40) + 2.0 + 30.0 / (1.0 * 5.0) + CYCLE


@pytest.mark.parametrize("tau", [0.7, 1.0, 1.23, 2.0, 3.1])
@pytest.mark.parametrize("fast_rate", [0.7, 1.0, 1.3])
@pytest.mark.parametrize("stop", [30, 31, 32, 33])
def test_silent_robot_is_replaced_in_time_whatever_its_parameters(tau: float, fast_rate: float, stop: int) -> None:
    told = nested(behaviour_set("patrol", fast_rate, 6000.0), timeout_duration=tau)
    quick = nested(behaviour_set("patrol", 1.5, 6000.0), timeout_duration=tau)
    team = Team({"one": agent("one", quick, ["patrol"]), "two": agent("two", told, ["patrol"])}, ["patrol"])
    last = 0.0
    for cycle in range(1, stop + 1):
        if announcements(team.step()["one"]):
            last = time_of(cycle)
    team.stopped.append("one")
    while team.step()["two"].task is None:
        assert team.cycle < 1000
    assert time_of(team.cycle) <= last + tau + 30.0 / (fast_rate * 5.0) + CYCLE


def test_impatient_robot_takes_over_by_one_reset_and_the_other_yields_after_psi() -> None:
    """Slow rate 0.5 from the reset in cycle 21: 60 cycles later, in cycle 81, robot2 is active.

    robot1 hears it for the first time in cycle 82 and is reset, grows by 0.5 and is active again in cycle 142.
    It resets robot2 no more, for robot2 heard it before. robot2, active since 17.0 (cycle 81), is so for more than
    psi = 20 s in cycle 182 (37.2) and yields.
    """
    team = pair_on_one_task(expected=60.0)
    assert team.step_to(80)["robot2"].task is None
    assert team.step_to(81)["robot2"].task == "patrol"
    said = motivations(team.step_to(82)["robot1"])["patrol"]
    assert (said["resetted"], said["active"]) == (True, False)
    assert team.step_to(141)["robot1"].task is None
    assert team.step_to(142)["robot1"].task == "patrol"
    assert motivations(team.step_to(143)["robot2"])["patrol"]["resetted"] is False
    assert team.step_to(181)["robot2"].task == "patrol"
    yielded = motivations(team.step_to(182)["robot2"])["patrol"]
    assert (yielded["acquiescent"], yielded["active"]) == (True, False)
    assert team.decisions["robot1"].task == "patrol"


def test_each_of_two_others_resets_once() -> None:
    """The original resets once in a life, for the first robot heard only."""
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    heard = {3: "two", 4: "two", 6: "three", 7: "two", 8: "three"}
    resets = []
    for cycle in range(1, 10):
        messages = [announced(heard[cycle], "patrol", time_of(cycle))] if cycle in heard else []
        if motivations(step(one, time_of(cycle), messages))["patrol"]["resetted"]:
            resets.append(cycle)
    assert resets == [3, 6]


def test_reset_zeroes_an_active_set() -> None:
    one = agent("one", nested(behaviour_set("patrol", 1.5)), ["patrol"])
    for cycle in range(1, 21):
        decision = step(one, time_of(cycle))
    assert decision.task == "patrol"
    decision = step(one, time_of(21), [announced("two", "patrol", time_of(21))])
    assert (decision.task, motivations(decision)["patrol"]["motivation"]) == (None, 0.0)


def test_one_active_set_suppresses_two_others() -> None:
    """The original's flag is toggled by each of the others and goes wrong with two."""
    told = nested(behaviour_set("patrol", 1.0), behaviour_set("inspect", 3.0), behaviour_set("report", 1.0))
    one = agent("one", told, ["patrol", "inspect", "report"])
    for cycle in range(1, 41):
        said = motivations(step(one, time_of(cycle)))
        if cycle > 10:
            suppressed = [said[task]["suppressed"] for task in ("patrol", "inspect", "report")]
            assert suppressed == [True, False, True]


def test_earlier_set_wins_a_tie() -> None:
    told = nested(behaviour_set("inspect", 1.5), behaviour_set("patrol", 1.5))
    one = agent("one", told, TASKS)
    decision = [step(one, time_of(cycle)) for cycle in range(1, 21)][-1]
    assert decision.task == "inspect"
    assert motivations(decision)["patrol"]["motivation"] == 0.0


def test_own_announcements_are_passed_over_with_or_without_a_slash() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    echo = announced("one", "patrol", 1.0)
    bare = echo._replace(fields={**echo.fields, "header/frame_id": "one"})
    said = motivations(step(one, 1.0, [echo, bare]))["patrol"]
    assert (said["resetted"], said["impatience"]) == (False, 1.0)


def test_announcement_of_an_unknown_task_is_passed_over() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    said = motivations(step(one, 1.0, [announced("two", "cook", 1.0)]))["patrol"]
    assert (said["resetted"], said["impatience"]) == (False, 1.0)


@pytest.mark.parametrize("progress", [Progress.DONE, Progress.FAILED, Progress.WITHDRAWN, Progress.UNREACHABLE])
def test_task_that_is_over_is_dropped_at_once_and_for_good(progress: Progress) -> None:
    """In the same cycle the other set is free to grow, though it stands earlier in the file."""
    told = nested(behaviour_set("inspect", 1.0), behaviour_set("patrol", 1.5))
    one = agent("one", told, TASKS)
    for cycle in range(1, 26):
        decision = step(one, time_of(cycle))
    assert decision.task == "patrol"
    decision = step(one, time_of(26), reports=[TaskReport("patrol", progress)])
    said = motivations(decision)
    assert decision.task is None
    assert (said["patrol"]["applicable"], said["patrol"]["active"]) == (False, False)
    assert (said["inspect"]["suppressed"], said["inspect"]["motivation"]) == (False, 1.0)
    later = [step(one, time_of(cycle)) for cycle in range(27, 60)]
    assert {decision.task for decision in later} == {None, "inspect"}


def test_task_that_appears_again_is_open_again() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    step(one, 1.0, reports=[TaskReport("patrol", Progress.DONE)])
    said = motivations(step(one, 1.2, reports=[TaskReport("patrol", Progress.APPEARED)]))["patrol"]
    assert (said["applicable"], said["motivation"]) == (True, 1.0)


def test_running_task_changes_nothing() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    said = motivations(step(one, 1.0, reports=[TaskReport("patrol", Progress.RUNNING)]))["patrol"]
    assert (said["applicable"], said["motivation"]) == (True, 1.0)


def test_task_that_the_robot_could_not_carry_out_now_does_not_grow() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    values = []
    for cycle, impossible in enumerate(([], [], ["patrol"], [], []), start=1):
        said = motivations(step(one, time_of(cycle), impossible=impossible))["patrol"]
        values.append((said["applicable"], said["motivation"]))
    assert values == [(True, 1.0), (True, 2.0), (False, 0.0), (True, 1.0), (True, 2.0)]


def test_robot_that_returns_after_a_stop_does_not_catch_up_on_announcements() -> None:
    """Active since 4.8, stopped after it, back at 24.8: one announcement then, the next half a second later."""
    one = agent("one", nested(behaviour_set("patrol", 1.5)), ["patrol"])
    for cycle in range(1, 21):
        step(one, time_of(cycle))
    spoken = [cycle for cycle in range(120, 129) if announcements(step(one, time_of(cycle)))]
    assert spoken == [120, 123, 125, 128]


def test_robot_that_returns_to_a_task_taken_over_is_reset_by_the_new_holder() -> None:
    team = pair_on_one_task(expected=6000.0)
    team.step_to(40)
    team.stopped.append("robot1")
    assert team.step_to(100)["robot2"].task == "patrol"
    team.stopped.clear()
    held = [team.step_to(cycle) and team.holders()["patrol"] for cycle in range(101, 110)]
    assert held[-1] == ("robot2",)


def test_agent_is_deterministic() -> None:
    def story() -> list:
        team = recorded_team()
        return [team.step() for _ in range(300)]

    assert story() == story()
