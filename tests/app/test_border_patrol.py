"""The example mission: what its scenario and its parameters promise."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Outputs

TAU = 5.0
THETA = 30.0
SPIN_RATE = 5.0
FAST_RATE_OF_SLOWEST_SPARE = 0.5


def allocations_of(outputs: Outputs, task: str) -> List[Dict[str, Any]]:
    return [allocation for allocation in outputs.summary["allocations"] if allocation["task"] == task]


def test_three_robots_work_and_two_are_spare_before_anything_happens(patrol: Outputs) -> None:
    held = {
        allocation["task"]: allocation["robot"]
        for allocation in patrol.summary["allocations"]
        if patrol.mission_seconds(allocation["from"]) < 59 < patrol.mission_seconds(allocation["to"])
    }
    assert held == {"wander": "robot1", "border_protection": "robot3", "report": "robot2"}


def test_the_lost_robots_allocation_ends_as_lost_when_its_silence_falls_due(patrol: Outputs) -> None:
    first = allocations_of(patrol, "border_protection")[0]
    assert (first["robot"], first["outcome"]) == ("robot3", "lost")
    # Last heard one tick before it stops at 60 s; the idle and busy timeouts are 2 s.
    assert patrol.mission_seconds(first["to"]) == pytest.approx(61.95, abs=0.051)


def test_another_robot_takes_over_within_what_the_parameters_promise(patrol: Outputs) -> None:
    second = allocations_of(patrol, "border_protection")[1]
    promised = TAU + THETA / (FAST_RATE_OF_SLOWEST_SPARE * SPIN_RATE) + 1 / SPIN_RATE
    assert second["robot"] in ("robot4", "robot5")
    assert 60 < patrol.mission_seconds(second["from"]) <= 60 + promised


def test_a_robot_that_was_away_is_replaced_and_on_its_return_one_of_the_two_yields(patrol: Outputs) -> None:
    """Both have been active for longer than the yielding delay by then, so whoever hears the other first lets go."""
    away, taken, back = allocations_of(patrol, "report")
    assert (away["robot"], away["outcome"]) == ("robot2", "lost")
    assert (taken["robot"], back["robot"]) == ("robot5", "robot2")
    assert 100 < patrol.mission_seconds(taken["from"]) < 135
    assert patrol.mission_seconds(back["from"]) == pytest.approx(135, abs=0.3)
    assert sorted([taken["outcome"], back["outcome"]]) == ["open", "yielded"]
    both = min(taken["to"], back["to"]) - back["from"]
    assert both <= 0.5, "no longer together than one broadcast period"


def test_a_robot_that_tried_for_too_long_gives_up_and_the_task_is_taken_again(patrol: Outputs) -> None:
    first, second = allocations_of(patrol, "wander")
    giving_up_delay = 100.0
    assert (first["robot"], first["outcome"]) == ("robot1", "gave_up")
    assert first["to"] - first["from"] == pytest.approx(giving_up_delay + 1 / SPIN_RATE, abs=1e-6)
    assert second["from"] - first["to"] <= THETA / (1.5 * SPIN_RATE) + 1e-6


def test_a_stopped_robot_is_offline_until_it_returns(patrol: Outputs) -> None:
    states = {robot["id"]: robot["states"] for robot in patrol.summary["robots"]}
    last = states["robot3"][-1]
    assert (last["state"], last["to"]) == ("offline", patrol.summary["time"]["end"])
    away = [state for state in states["robot2"] if state["state"] == "offline"][-1]
    # Its last announcement is at most one broadcast period old when it stops at 100 s, and stays fresh for 2 s.
    assert 100 - 0.5 + 2 <= patrol.mission_seconds(away["from"]) <= 100 + 2
    assert patrol.mission_seconds(away["to"]) == pytest.approx(135, abs=0.3)


def test_a_silent_robot_with_a_task_is_an_incident_with_evidence_that_can_be_looked_up(patrol: Outputs) -> None:
    from rqt_mrta_py.transport import read_bag

    incidents = [incident for incident in patrol.summary["incidents"] if "robot3" in incident["robots"]]
    assert [incident["rule"] for incident in incidents] == ["robot_silent_with_task"]
    (incident,) = incidents
    assert incident["severity"] == "error"
    assert incident["tasks"] == ["border_protection"]
    assert incident["to"] == patrol.summary["time"]["end"]
    for evidence in incident["evidence"]:
        stamps = [stamped.receipt_ns for stamped in read_bag(patrol.bag, topics=[evidence["topic"]])]
        assert stamps[evidence["index"]] == pytest.approx(evidence["stamp"] * 1e9, abs=1e3)
    before, last, taken_over = incident["evidence"]
    assert before["topic"] == taken_over["topic"] == "/alliance/inter_robot_communication"
    assert before["stamp"] <= last["stamp"]
    assert patrol.mission_seconds(last["stamp"]) <= 60 < patrol.mission_seconds(taken_over["stamp"])


def test_a_stopped_robot_says_nothing_on_any_topic(patrol: Outputs) -> None:
    from rqt_mrta_py.transport import read_bag

    silent_from = round((float(patrol.summary["time"]["start"]) + 60) * 1e9)
    said = {
        stamped.connection.topic
        for stamped in read_bag(patrol.bag)
        if stamped.receipt_ns >= silent_from
        and (stamped.connection.topic.startswith("/robot3/") or stamped.connection.caller.startswith("/robot3/"))
    }
    assert said == set()


def test_pictures_of_the_mission_are_drawn(patrol: Outputs) -> None:
    pictures = sorted(path.name for path in (patrol.folder / "monitor").iterdir())
    assert pictures[0] == "000000.000.png"
    assert pictures[-1] == "000150.000.png"
    assert len(pictures) == 16
    assert (patrol.folder / "dashboard.png").read_bytes().startswith(b"\x89PNG")


def holder_at_60_s(folder: Path, seed: int) -> List[str]:
    arguments = ["--seed", str(seed), "--duration", "61", "--pictures", "0", "--out", str(folder), "-q"]
    assert main(["run", "border_patrol", *arguments]) == 0
    outputs = Outputs(folder)
    return [
        allocation["robot"]
        for allocation in allocations_of(outputs, "border_protection")
        if outputs.mission_seconds(allocation["from"]) < 60 <= outputs.mission_seconds(allocation["to"])
    ]


def test_robot3_protects_the_border_when_it_stops_under_a_large_seed_too(tmp_path: Path) -> None:
    assert holder_at_60_s(tmp_path / "run", 2**62) == ["robot3"]


@pytest.mark.long
@pytest.mark.parametrize("seed", [1, *range(100, 150)])
def test_robot3_protects_the_border_when_it_stops_under_many_seeds(tmp_path: Path, seed: int) -> None:
    assert holder_at_60_s(tmp_path / "run", seed) == ["robot3"]
