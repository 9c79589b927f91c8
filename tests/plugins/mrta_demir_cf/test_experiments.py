"""The benchmark ``demir_cf``: its missions, and reports that hold together."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from typing import Iterator, List, Sequence, Tuple

import pytest
from mrta_demir_cf.experiments.benchmark import PARTS, add_arguments, measure
from mrta_demir_cf.experiments.part import Options
from mrta_demir_cf.experiments.point_team import PointTeam
from mrta_demir_cf.experiments.points import COLUMNS, carry_out, random_team, row
from mrta_demir_cf.experiments.simulated import COLUMNS as SIMULATED_COLUMNS
from mrta_demir_cf.experiments.simulated import SimulatedMission, summed_up
from mrta_demir_cf.experiments.simulated import row as simulated_row

from rqt_mrta_py.hooks import Experiment, Trial
from rqt_mrta_py.model import MapKnowledge, MissionRecord, RobotRecord, TaskInterval, TaskRecord, TaskState, Taxonomy

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


def record(done: Sequence[float], waiting: int, travelled: float) -> MissionRecord:
    tasks = [
        TaskRecord(
            f"t{number}",
            (TaskInterval(TaskState.WAITING, 1.0, moment), TaskInterval(TaskState.DONE, moment, 99.0)),
        )
        for number, moment in enumerate(done)
    ]
    tasks += [TaskRecord(f"w{number}", (TaskInterval(TaskState.WAITING, 1.0, 99.0),)) for number in range(waiting)]
    robots = tuple(RobotRecord(f"r{number}", ()) for number in range(2))
    statistics = {"travel": {"team": travelled, "robots": {}}, "reallocations": 2}
    taxonomy = Taxonomy.parse("ST-SR-IA")
    return MissionRecord(None, None, taxonomy, 0, 1.0, 99.0, robots, tuple(tasks), (), (), (), statistics)


class ScriptedLaboratory:
    """Gives the same record for every experiment and remembers them."""

    def __init__(self, record: MissionRecord) -> None:
        self.record = record
        self.asked: List[Experiment] = []

    def trials(self, experiments: Sequence[Experiment]) -> Iterator[Trial]:
        self.asked += experiments
        said = {"demir_cf_msgs/Request": 3, "demir_cf_msgs/Hello": 50, "demir_cf_msgs/Unachievability": 1, "tf/tf": 9}
        for experiment in experiments:
            yield Trial(experiment, self.record, said)


def test_a_simulated_mission_is_summed_up_from_its_record() -> None:
    """Two targets, the later one 30 s after the start; requests and announcements count, signs of life do not."""
    trial = next(ScriptedLaboratory(record([11.0, 31.0], 1, 7.5)).trials([Experiment("any", 0)]))
    mission = summed_up(trial, wanted=3)
    assert mission == SimulatedMission(2, 3, 30.0, 7.5, messages=4, reallocations=2, unreachable=1)
    cells = dict(zip(SIMULATED_COLUMNS, simulated_row([mission])))
    assert (cells["all visited"], cells["time [s]"]) == ("0 of 1", None)


def test_in_simulation_robots_get_the_targets_that_can_be_reached_and_one_is_lost_half_way() -> None:
    laboratory = ScriptedLaboratory(record([11.0, 31.0], 1, 7.5))
    report = PARTS["simulation"].measure(QUICK, laboratory)  # type: ignore[arg-type]
    assert [row[0] for row in report.tables[0].rows] == ["2", "2, one lost half-way"]
    first, *whole = laboratory.asked[:3]
    assert first.tasks is None
    assert [(each.tasks, each.robots, each.seed) for each in whole] == [(("t0", "t1"), 2, 0), (("t0", "t1"), 2, 1)]
    stops = [each.events for each in laboratory.asked[3:]]
    assert [[(event.time, event.robot) for event in each or ()] for each in stops] == [[(15.0, "r0")], [(15.0, "r1")]]


def test_maps_are_known_and_unknown_to_three_robots_with_all_targets() -> None:
    laboratory = ScriptedLaboratory(record([11.0], 0, 7.5))
    report = PARTS["map"].measure(QUICK, laboratory)  # type: ignore[arg-type]
    assert [row[0] for row in report.tables[0].rows] == ["known", "unknown"]
    asked = [(each.map, each.tasks, each.robots) for each in laboratory.asked[1:]]
    assert asked == [(MapKnowledge.KNOWN, None, 3)] * 2 + [(MapKnowledge.UNKNOWN, None, 3)] * 2
