"""The part ``teams`` of the benchmark, on missions whose outcome is known beforehand."""

from __future__ import annotations

import math
import time
from types import SimpleNamespace

import pytest
from block_construction.experiments import teams
from block_construction.experiments.part import Options
from block_construction.experiments.teams import measure_teams
from block_construction.experiments.undisturbed import Undisturbed
from block_construction.team.speed_up import Job

from rqt_mrta_py.model import ScenarioEventKind, TaskState

pytest.importorskip("scipy", reason="SciPy finds ways")
pytest.importorskip("ortools", reason="OR-tools finds the diagrams")


class Teams:
    """A laboratory in which one robot takes 600 s for six blocks, two take 400 s, and who loses one places five."""

    def __init__(self):
        self.experiments = []

    def trials(self, experiments):
        for experiment in experiments:
            self.experiments.append(experiment)
            lost = bool(experiment.events)
            end = 600.0 if experiment.robots == 1 else 400.0
            build = {
                "blocks": 6,
                "placed": 5 if lost else 6,
                "fetching": {"seconds": 200.0, "metres": 3.0},
                "placing": {"seconds": 400.0, "metres": 6.0},
                "waiting": 30.0,
                "nearest": None if experiment.robots == 1 else 0.41,
                "collisions": 0,
            }
            tasks = [
                SimpleNamespace(state=TaskState.DONE, history=(SimpleNamespace(start=1.0 + end),)) for _ in range(6)
            ]
            robots = [f"robot{number + 1}" for number in range(experiment.robots)]
            record = SimpleNamespace(statistics={"build": build}, tasks=tasks, start=1.0, robots=robots)
            yield SimpleNamespace(record=record, experiment=experiment)


def six_blocks(structure, robots):
    """Give six blocks, each 0.3 m from a supply place of its own, which all lie where robots begin; 0.03 m/s."""
    jobs = {number: Job((), (0.3, 0.0), ((number, (0.0, 0.0)),)) for number in range(1, 7)}
    return Undisturbed(jobs, ((0.0, 0.0),) * robots, lambda one, other, _: math.dist(one, other), 0.03)


def test_teams_are_held_against_one_robot_and_against_what_interference_cannot_explain(monkeypatch):
    """600 s / 400 s = 1.5; each of two is idle for 400 s - 600 s / 2 = 100 s; they drive 9 m for 6 blocks.

    Without interference one robot drives 6 times 0.3 m and 5 times back, 3.3 m in 110 s, so that a block takes
    (600 s - 110 s) / 6 = 81.7 s beside; of these, as it drives back for 50 s, (200 s - 50 s) / 6 = 25 s at its supply
    place. Two drive 2 times 1.5 m and need 50 s + 245 s = 295 s: 2.034 times as fast, of which 1.5 is 74 %. Their way
    is 0.05 m a block shorter than that of one; as both really drive 1.5 m a block, so much is detour, 1.7 s.
    """
    monkeypatch.setattr(teams, "undisturbed", six_blocks)
    whole, lost = measure_teams(Options(time.process_time, quick=True), Teams()).tables
    rows = {(row[0], row[1]): dict(zip(whole.columns, row)) for row in whole.rows}
    assert list(rows) == [("mrta_demir_cf", 1), ("mrta_demir_cf", 2), ("mrta_alliance", 2)]
    two = rows["mrta_demir_cf", 2]
    assert (two["whole builds"], two["blocks not in slots"], two["nearest [m]"], two["collisions"]) == (
        "1 of 1",
        0,
        0.41,
        0,
    )
    assert two["speed-up"].startswith("1.50 ")
    assert (two["without interference"], two["of it [%]"]) == (2.03, 74.0)
    assert two["idle [s/robot]"].startswith("100 ")
    assert two["way [m/block]"].startswith("1.50 ")
    assert two["waiting [s/block]"].startswith("5.0 ")
    assert two["detour [m/block]"].startswith("0.05 ")
    assert two["detour [s/block]"].startswith("1.7 ")
    one = rows["mrta_demir_cf", 1]
    assert (one["without interference"], one["detour [m/block]"]) == (1.0, None)
    assert "25 s at its supply place and 57 s elsewhere" in whole.notes[0]
    assert [row[1:3] for row in lost.rows] == [("removed after 60 s", "0 of 1"), ("stays where it is", "0 of 1")]
    assert lost.rows[0][3].startswith("83.3 ")


def test_a_robot_stops_at_a_moment_of_its_own_in_each_seed_and_is_removed_a_minute_later():
    laboratory = Teams()
    measure_teams(Options(time.process_time, seeds=2, quick=True), laboratory)
    losses = [experiment.events for experiment in laboratory.experiments if experiment.events]
    assert [[event.kind for event in events] for events in losses] == [
        *[[ScenarioEventKind.ROBOT_STOPS, ScenarioEventKind.ROBOT_REMOVED]] * 2,
        *[[ScenarioEventKind.ROBOT_STOPS]] * 2,
    ]
    assert [events[0].robot for events in losses] == ["robot1", "robot2"] * 2
    stop, removed = losses[0]
    assert 100.0 <= stop.time <= 600.0
    assert removed.time - stop.time == pytest.approx(60.0)
    assert losses[0][0] == losses[2][0]
    assert losses[0][0].time != losses[1][0].time
