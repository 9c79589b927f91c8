"""The benchmark ``demir_cf``: its missions, and reports that hold together."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from typing import Tuple

import pytest
from mrta_demir_cf.experiments.benchmark import PARTS, add_arguments, measure
from mrta_demir_cf.experiments.part import Options
from mrta_demir_cf.experiments.point_team import PointTeam
from mrta_demir_cf.experiments.points import COLUMNS, carry_out, random_team, row

QUICK = Options(seeds=2, quick=True)
ON_MESSAGE_LEVEL = ("team_size", "contingency", "failure", "online")


def told(*arguments: str) -> Namespace:
    parser = ArgumentParser()
    add_arguments(parser)
    return parser.parse_args(arguments)


@pytest.mark.parametrize("part", ON_MESSAGE_LEVEL)
def test_every_part_makes_tables_whose_rows_fit_and_in_which_all_is_visited(part: str) -> None:
    report = PARTS[part].measure(QUICK, None)  # type: ignore[arg-type]
    for table in report.tables:
        assert {len(each) for each in table.rows} == {len(table.columns)}
        assert {each[table.columns.index("all visited")] for each in table.rows} == {"2 of 2"}


def test_parts_are_measured_in_their_order_whatever_is_asked_first() -> None:
    report = measure(told("--quick", "--seeds", "1", "--parts", "failure,team_size"), None)  # type: ignore[arg-type]
    assert [figure.name for figure in report.figures] == ["demir_cf_team_size", "demir_cf_failure"]


def test_a_row_tells_how_many_missions_were_completed() -> None:
    """By hand: one robot, 1 m to its only target at 0.1 m/s; another mission in which there is nobody to go."""
    done = PointTeam({"r": (0.0, 0.0)}, {"t": (1.0, 0.0)}).run(100.0)
    never = PointTeam({"r": (0.0, 0.0)}, {"t": (1.0, 0.0)})
    never.stopped.add("r")
    cells = dict(zip(COLUMNS, row([done, never.run(20.0)])))
    assert (cells["missions"], cells["all visited"]) == (2, "1 of 2")
    assert done.path == pytest.approx(1.0)
    assert cells["time [s]"] == f"{done.time:.0f} [{done.time:.0f}, {done.time:.0f}]"


def test_places_depend_on_size_and_seed_alone() -> None:
    one, same = random_team(3, 5), random_team(3, 5, loss=0.5, parameters={"handling": False})
    assert (one.places, one.targets) == (same.places, same.targets)
    assert one.places != random_team(3, 6).places


def test_a_target_that_turns_up_is_not_visited_before() -> None:
    team = random_team(2, 0, targets=2, later=(1,))
    while not team.visited:
        team.step()
    for _ in range(20):
        team.step()
    assert not team.mission.visits["t01"]
    appeared = team.now
    team.appear("t01")
    mission = team.run(300.0)
    assert mission.visits["t01"][0][1] > appeared
    assert mission.time < math.inf


def test_a_lost_robot_visits_nothing_more() -> None:
    team = random_team(3, 1)
    mission = carry_out(team, lost="r1")
    halfway = sorted(moment for visits in mission.visits.values() for _, moment in visits)[4]
    late = [robot for visits in mission.visits.values() for robot, moment in visits if moment > halfway + 1.0]
    assert "r1" not in late
    assert team.visited == 10


@pytest.mark.parametrize("arguments", [("--parts", "size"), ("--seeds", "0"), ("--duration", "-1")])
def test_wrong_usage_is_refused(arguments: Tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        told(*arguments)
    assert arguments[1] in capsys.readouterr().err.splitlines()[-1]
