"""The experiments of ``mrta bench alliance``, on records made by hand."""

from __future__ import annotations

from argparse import ArgumentParser
from typing import Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple

import numpy as np
import pytest
from mrta_alliance.agent import AllianceAgent
from mrta_alliance.experiments.benchmark import PARTS, add_arguments, measure, options_of
from mrta_alliance.experiments.completion import measure_completion
from mrta_alliance.experiments.cost import idle_team, measure_cost
from mrta_alliance.experiments.heterogeneous import measure_heterogeneous, slowed
from mrta_alliance.experiments.learning import measure_learning
from mrta_alliance.experiments.loss import measure_loss
from mrta_alliance.experiments.measures import done_at, double_holdings, holder_at, takeover_time
from mrta_alliance.experiments.part import Options
from mrta_alliance.experiments.settings import UNTUNED, every_set
from mrta_alliance.experiments.shares import measure_shares
from mrta_alliance.experiments.stops import alone, random_stops
from mrta_alliance.experiments.takeover import bound_on_takeover, measure_takeover

from rqt_mrta_py.hooks import AgentSetup, Experiment, IdleTeam, TeamCost, Trial
from rqt_mrta_py.model import (
    Allocation,
    MissionRecord,
    Outcome,
    RobotRecord,
    ScenarioEventKind,
    Task,
    TaskInterval,
    TaskRecord,
    TaskState,
    Taxonomy,
)

ROBOTS = ("robot1", "robot2", "robot3")

Holding = Tuple[str, str, float, float]


def record(
    done: Mapping[str, Optional[float]] = {},
    holdings: Sequence[Holding] = (),
    end: float = 101.0,
    coverage: Mapping[str, float] = {},
) -> MissionRecord:
    """Make a record that begins at 1 s.

    Args:
        done: when each task was done, since the beginning; None if never [s].
        holdings: task, robot, from and to, since the beginning [s].
        end: on the stream's clock [s].
        coverage: by task.
    """
    tasks = tuple(
        TaskRecord(task, (TaskInterval(TaskState.WAITING, 1.0, end),))
        if at is None
        else TaskRecord(
            task, (TaskInterval(TaskState.WAITING, 1.0, 1.0 + at), TaskInterval(TaskState.DONE, 1.0 + at, end))
        )
        for task, at in done.items()
    )
    allocations = tuple(Allocation(task, robot, 1.0 + a, 1.0 + b, Outcome.OPEN) for task, robot, a, b in holdings)
    robots = tuple(RobotRecord(robot, ()) for robot in ROBOTS)
    taxonomy, statistics = Taxonomy.parse("ST-SR-IA"), {"coverage": dict(coverage)}
    return MissionRecord("app", "arch", taxonomy, 1, 1.0, end, robots, tasks, allocations, (), (), statistics)


class Bench:
    """A laboratory in which nothing is simulated: a function says what comes of an experiment."""

    def __init__(self, outcome: Callable[[Experiment], MissionRecord]) -> None:
        self.asked: List[Experiment] = []
        self._outcome = outcome

    def trials(self, experiments: Sequence[Experiment]) -> Iterator[Trial]:
        for experiment in experiments:
            self.asked.append(experiment)
            yield Trial(experiment, self._outcome(experiment))

    def costs(self, teams: Sequence[IdleTeam]) -> Iterator[TeamCost]:
        """A millisecond a robot and second, and as many messages as there are tasks."""
        for team in teams:
            share = len(team.parameters) * team.duration
            yield TeamCost(team, {"a/B": round(share * len(team.tasks)), "a/C": round(share)}, 0.001 * share)


def stopped(experiment: Experiment) -> Dict[str, float]:
    events = experiment.events or ()
    return {e.robot: e.time for e in events if e.robot and e.kind is ScenarioEventKind.ROBOT_STOPS}


def test_tasks_are_done_when_their_last_state_begins() -> None:
    assert done_at(record({"a": 12.0, "b": None})) == {"a": 12.0}


def test_holdings_of_one_task_by_two_robots_overlap_pair_by_pair() -> None:
    found = double_holdings(
        record(
            holdings=[
                ("a", "robot1", 0.0, 10.0),
                ("a", "robot2", 8.0, 20.0),
                ("a", "robot3", 9.0, 9.5),
                ("b", "robot3", 0.0, 50.0),
                ("a", "robot2", 20.0, 30.0),
                ("a", "robot1", 30.0, 31.0),
            ]
        )
    )

    assert found == pytest.approx([2.0, 0.5, 0.5])


def test_a_holder_holds_until_just_before_the_end() -> None:
    allocations = record(holdings=[("a", "robot1", 0.0, 5.0), ("a", "robot2", 5.0, 9.0)]).allocations

    assert [getattr(holder_at(allocations, "a", at), "robot", None) for at in (1.0, 5.9, 6.0, 10.0)] == [
        "robot1",
        "robot1",
        "robot2",
        None,
    ]


def test_a_takeover_is_the_first_allocation_to_another_robot_after_the_loss() -> None:
    mission = record(
        holdings=[
            ("a", "robot2", 2.0, 4.0),
            ("a", "robot1", 5.0, 9.0),
            ("a", "robot1", 11.0, 12.0),
            ("b", "robot2", 11.5, 20.0),
            ("a", "robot3", 13.5, 20.0),
        ]
    )

    assert takeover_time(mission, "a", "robot1", 10.0) == pytest.approx(3.5)
    assert takeover_time(mission, "b", "robot2", 12.0) is None


def test_the_bound_on_takeovers_adds_up() -> None:
    # tau 3, 30 / (1.5 x 5) = 4 s of growth, two cycles of 0.2 s, a period of 0.5 s.
    assert bound_on_takeover(3.0, 30.0, 1.5, 5.0, 2.0) == pytest.approx(7.9)


def test_whoever_stops_among_few_stops_among_more_at_the_same_moment() -> None:
    few, more = (
        {e.robot: e.time for e in random_stops(["a", "b", "c", "d"], number, 50.0, seed=3)} for number in (1, 3)
    )

    assert len(few) == 1
    assert len(more) == 3
    assert few.items() <= more.items()
    assert all(0.0 <= time <= 50.0 for time in more.values())
    assert len({tuple(e.robot for e in random_stops(["a", "b", "c", "d"], 2, 50.0, seed)) for seed in range(20)}) > 3


def test_a_robot_is_alone_if_all_others_stop_at_once() -> None:
    assert [(event.robot, event.time) for event in alone(ROBOTS, "robot2")] == [("robot1", 0.0), ("robot3", 0.0)]


def test_robots_are_slowed_alike_for_every_degree() -> None:
    half, all_of_it = ([e.parameters["factor"] for e in slowed(ROBOTS, degree, 4)] for degree in (0.4, 0.8))

    assert [1.0 - factor for factor in all_of_it] == pytest.approx([2.0 * (1.0 - factor) for factor in half])
    assert all(0.6 < factor <= 1.0 for factor in half)
    assert [e.parameters["factor"] for e in slowed(ROBOTS, 0.0, 4)] == [1.0] * 3


def test_settings_name_every_behaviour_set() -> None:
    assert every_set(fast_rate=1.5) == (
        "behaviour_sets/behaviour_set@index@/motivational_behaviour/impatience/fast_rate=1.5",
    )
    assert len(UNTUNED) == 6


def test_completion_asks_only_for_what_those_left_alive_can_do() -> None:
    """robot1 alone does all, the others only the light task: a mission without robot1 need not do the heavy one."""

    def outcome(experiment: Experiment) -> MissionRecord:
        lost = stopped(experiment)
        return record({"light": 20.0 + 10.0 * len(lost), "heavy": None if "robot1" in lost else 40.0})

    bench = Bench(outcome)
    report = measure_completion(Options(seeds=8), bench)
    (table,) = report.tables

    assert [row[0] for row in table.rows] == [0, 1, 2]
    assert [row[2] for row in table.rows] == ["100 % [68, 100]"] * 3
    assert table.rows[0][4] == "40.0 [40.0, 40.0]"
    assert table.rows[0][3] == "100 % [68, 100]"
    assert table.rows[2][3] != "100 % [68, 100]"
    # Undisturbed, one alone for each robot, then one and two lost.
    assert [len(stopped(each)) for each in bench.asked] == [0] * 8 + [2] * 3 + [1] * 8 + [2] * 8
    assert [figure.name for figure in report.figures] == ["alliance_completion"]


def test_completion_tells_of_missions_in_which_somebody_able_left_work_undone() -> None:
    def outcome(experiment: Experiment) -> MissionRecord:
        lost = stopped(experiment)
        alone_from_the_start = len(lost) == 2 and set(lost.values()) == {0.0}
        return record({"light": 20.0 if alone_from_the_start or not lost else None})

    (table,) = measure_completion(Options(seeds=4), Bench(outcome)).tables

    assert [row[2] for row in table.rows] == ["100 % [51, 100]", "0 % [0, 49]", "0 % [0, 49]"]
    assert table.rows[1][4] is None


def test_takeover_stops_a_robot_while_it_holds_a_task_and_sees_who_comes() -> None:
    def outcome(experiment: Experiment) -> MissionRecord:
        lost = stopped(experiment)
        holdings: List[Holding] = [("a", "robot1", 5.0, 90.0)]
        if lost:
            holdings = [("a", "robot1", 5.0, lost["robot1"] + 2.0), ("a", "robot2", lost["robot1"] + 4.25, 90.0)]
        return record({"a": None, "b": None}, holdings)

    bench = Bench(outcome)
    by_tau, by_phi = measure_takeover(Options(seeds=3), bench).tables

    assert [row[0] for row in by_tau.rows] == [2.0, 3.0, 5.0, 8.0]
    assert [row[1:3] for row in (*by_tau.rows, *by_phi.rows)] == [(3, 3)] * 8
    assert [row[3] for row in by_tau.rows] == ["4.25 [4.25, 4.25]"] * 4
    assert [row[8] for row in by_tau.rows] == ["3 of 3"] * 4
    moments = [time for each in bench.asked for time in stopped(each).values()]
    assert len(moments) == 24
    assert all(20.0 <= moment <= 35.0 for moment in moments)


def test_a_task_that_nobody_takes_over_is_counted_as_such() -> None:
    (by_tau, _) = measure_takeover(
        Options(seeds=2), Bench(lambda experiment: record({"a": None}, [("a", "robot1", 5.0, 90.0)]))
    ).tables

    assert by_tau.rows[0][1:5] == (2, 0, None, None)
    assert by_tau.rows[0][8] == "0 of 2"


def test_loss_counts_what_is_held_doubly() -> None:
    def outcome(experiment: Experiment) -> MissionRecord:
        loss = experiment.radio.parameters["loss"] if experiment.radio else 0.0
        overlap = 10.0 * loss
        holdings: List[Holding] = [("a", "robot1", 0.0, 20.0), ("a", "robot2", 20.0 - overlap, 40.0)]
        return record({"a": 40.0 + overlap}, holdings)

    report = measure_loss(Options(seeds=2), Bench(outcome))
    missions, takeovers = report.tables

    assert [row[0] for row in missions.rows] == [0, 10, 20, 30, 40, 50]
    assert [row[3] for row in missions.rows][-1] == "45.0 [45.0, 45.0]"
    assert [row[6] for row in missions.rows] == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]
    # By then robot2 alone holds the task, and nobody replaces it.
    assert [row[2] for row in takeovers.rows] == [0] * 6
    assert report.figures[1].charts[0].lines[0].y == (0.0,)


def test_unequal_robots_are_compared_with_an_allocation_that_never_changes() -> None:
    bench = Bench(lambda e: record({"a": 50.0 if e.architecture == "mrta_baselines" else 30.0}))

    (table,) = measure_heterogeneous(Options(seeds=2), bench).tables

    assert [row[4] for row in table.rows] == ["30.0 [30.0, 30.0]"] * 4 + ["50.0 [50.0, 50.0]"] * 4
    assert {each.settings for each in bench.asked if each.architecture == "mrta_baselines"} == {("rule=fixed",)}


def test_learning_holds_every_rival_against_tuned_and_untuned() -> None:
    """Untuned takes 100 s, tuned 80, who has learned 60 plus one for each task it knows nothing of."""

    def outcome(experiment: Experiment) -> MissionRecord:
        if experiment.settings == UNTUNED:
            return record({"a": 100.0})
        if experiment.architecture == "mrta_l_alliance":
            return record({"a": 60.0}, [("a", "robot1", 0.0, 60.0)])
        return record({"a": 80.0} if experiment.architecture == "mrta_alliance" else {"a": None})

    bench = Bench(outcome)
    (table,) = measure_learning(Options(seeds=3, courses=2, lessons=4), bench).tables
    rows = {row[0]: row for row in table.rows}

    assert rows["L-ALLIANCE, trained"][4:] == ("0.600 [0.600, 0.600]", "0.750 [0.750, 0.750]")
    assert rows["ALLIANCE, hand-tuned"][4] == "0.800 [0.800, 0.800]"
    assert rows["random allocation"][2] == "0 % [0, 56]"
    assert rows["random allocation"][3] == "100.0 [100.0, 100.0]"
    # One to learn who is there, two courses of four lessons, seven rivals on three missions.
    assert len(bench.asked) == 1 + 2 * 4 + 7 * 3
    trained = [each for each in bench.asked[9:] if any("learning/memory=" in text for text in each.settings)]
    assert len(trained) == 3


def test_shares_of_perpetual_tasks_stand_side_by_side() -> None:
    def outcome(experiment: Experiment) -> MissionRecord:
        fair = every_set(fairness=2.0)[0] in experiment.settings
        return record(coverage={"a": 0.5, "b": 0.5} if fair else {"a": 0.9, "b": 0.0})

    (table,) = measure_shares(Options(seeds=2, quick=True), Bench(outcome)).tables

    assert table.columns[3:] == ("a [%]", "b [%]")
    assert table.rows[0][:4] == (1, 0.0, 2, "90.0 [90.0, 90.0]")
    assert table.rows[1][3:] == ("50.0 [50.0, 50.0]", "50.0 [50.0, 50.0]")
    assert len(table.rows) == 2


def test_cost_is_told_by_robot_and_second_and_as_a_speed() -> None:
    """A millisecond a robot and second: 3 robots pass 1000 / 3 mission seconds in a second."""
    report = measure_cost(Options(quick=True), Bench(lambda e: record()))
    assert [row for table in report.tables for row in table.rows] == [
        (3, 4, 5.0, 1.0, 333.3),
        (3, 20, 21.0, 1.0, 333.3),
    ]
    (figure,) = report.figures
    assert figure.name == "alliance_cost"
    assert [line.label for chart in figure.charts for line in chart.lines] == ["3 robots", "3 robots", "asked for"]


def test_costs_are_of_up_to_a_hundred_robots_with_a_hundred_behaviour_sets() -> None:
    rows = measure_cost(Options(), Bench(lambda e: record())).tables[0].rows
    assert [row[:2] for row in rows] == [(robots, sets) for robots in (10, 30, 100) for sets in (10, 30, 100)]


def test_every_robot_of_an_idle_team_has_a_behaviour_set_for_every_task_and_is_quickest_at_one() -> None:
    team = idle_team(3, 2, 1.0)
    tasks = tuple(Task(task, "idle", perpetual=True) for task in team.tasks)
    quickest = []
    for robot, parameters in team.parameters.items():
        setup = AgentSetup(robot, tuple(team.parameters), tasks, parameters, np.random.default_rng(0))
        sets = AllianceAgent(setup).behaviour_sets
        assert tuple(sets) == ("task0", "task1")
        quickest.append(max(sets, key=lambda task: sets[task].fast_rate))
    assert quickest == ["task0", "task1", "task0"]


def test_parts_are_measured_in_their_order_whatever_the_order_of_asking() -> None:
    parser = ArgumentParser()
    add_arguments(parser)
    told = parser.parse_args(["--parts", "shares,takeover", "--quick"])
    bench = Bench(lambda e: record({"a": None}, [("a", "robot1", 5.0, 90.0)], coverage={"a": 0.5}))

    report = measure(told, bench)

    assert [table.title.split(":")[1].split()[0] for table in report.tables] == ["from", "from", "share"]
    assert options_of(told).seeds == 1
    assert len({figure.name for figure in report.figures}) == len(report.figures) == 3


def test_a_part_that_there_is_not_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    parser = ArgumentParser()
    add_arguments(parser)
    with pytest.raises(SystemExit):
        parser.parse_args(["--parts", "speed"])

    assert f"'speed': there is no such part; there are: {', '.join(PARTS)}" in capsys.readouterr().err


def test_fifty_seeds_are_the_default() -> None:
    parser = ArgumentParser()
    add_arguments(parser)
    options = options_of(parser.parse_args([]))

    assert len(options.seed_numbers) == 50
    assert (options.application, options.duration, options.lessons) == ("cleanup", 900.0, 10)


def test_a_duration_that_is_none_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    parser = ArgumentParser()
    add_arguments(parser)
    with pytest.raises(SystemExit):
        parser.parse_args(["--duration", "nan"])

    assert "'nan': a number of seconds above 0 is expected" in capsys.readouterr().err
