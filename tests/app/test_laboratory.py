"""The laboratory: experiments as simulated missions without bag and pictures."""

from __future__ import annotations

import dataclasses
import multiprocessing
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import List

import pytest

from rqt_mrta_py.app.bench.experiments import ExperimentMissions, settings_for
from rqt_mrta_py.app.bench.laboratory import EmbeddedLaboratory, ExperimentError
from rqt_mrta_py.app.bench.workers import WorkerError, in_order
from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.run.mission import RunRequest, run_mission
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Agent, AgentSetup, Decision, Experiment, IdleTeam, Trial
from rqt_mrta_py.model import RadioSetup, ScenarioEvent, ScenarioEventKind, TaskState
from rqt_mrta_py.supervisor import summary as summary_of
from tests.app.errand_yard import DURATION, write_errand_yard


@pytest.fixture(scope="module")
def host() -> Host:
    return compose()


@pytest.fixture(scope="module")
def errands(tmp_path_factory: pytest.TempPathFactory) -> str:
    return write_errand_yard(tmp_path_factory.mktemp("errands") / "errand_yard")


@pytest.fixture(scope="module")
def trial(host: Host, errands: str) -> Trial:
    """Carry out the application as it is."""
    (trial,) = EmbeddedLaboratory(host).trials([Experiment(errands, seed=1)])
    return trial


def test_a_mission_ends_at_the_moment_when_the_last_task_that_can_end_has(trial: Trial) -> None:
    states = {task.id: task.state for task in trial.record.tasks}
    ends = [task.history[-1].start for task in trial.record.tasks if task.state is TaskState.DONE]

    assert states["north"] is states["south"] is TaskState.DONE
    assert states["rest"] not in {TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN}
    assert trial.record.start == 1.0
    assert trial.record.end == max(ends) < 1.0 + DURATION


def test_messages_are_counted_by_type(trial: Trial) -> None:
    assert trial.record.end is not None
    ticks = round((trial.record.end - 1.0) * 20) + 1

    assert trial.messages["rosgraph_msgs/Clock"] == ticks
    # Two localisers at 10 Hz, from the first tick on.
    assert trial.messages["geometry_msgs/PoseStamped"] == 2 * ((ticks + 1) // 2)
    assert "rqt_mrta_py/TeamState" not in trial.messages
    assert trial.processor_time > 0.0


def test_a_mission_whose_tasks_are_all_perpetual_lasts_as_long_as_it_is_told(host: Host, errands: str) -> None:
    (trial,) = EmbeddedLaboratory(host).trials([Experiment(errands, seed=1, duration=3.0, tasks=("rest",))])

    assert trial.record.end == 4.0
    assert [task.id for task in trial.record.tasks] == ["rest"]


def test_a_task_that_is_to_appear_keeps_the_mission_going(host: Host, errands: str) -> None:
    appears = ScenarioEvent(5.0, ScenarioEventKind.TASK_APPEARS, task="north")
    withdrawn = [ScenarioEvent(at, ScenarioEventKind.TASK_WITHDRAWN, task=task) for at, task in enumerate(["south"], 1)]
    late = ScenarioEvent(6.0, ScenarioEventKind.TASK_WITHDRAWN, task="north")
    experiment = Experiment(errands, seed=1, duration=20.0, events=(late, appears, *withdrawn))

    (trial,) = EmbeddedLaboratory(host).trials([experiment])

    assert trial.record.end == 7.0
    assert trial.experiment == experiment


def test_the_record_is_what_a_run_of_the_same_mission_finds(host: Host, errands: str, tmp_path: Path) -> None:
    request = RunRequest(errands, seed=3, duration=6.0, pictures=0, out=tmp_path / "run", processes=1)
    summary = run_mission(host, request, lambda passed, planned: None).summary
    (trial,) = EmbeddedLaboratory(host).trials([Experiment(errands, seed=3, duration=6.0)])

    assert summary_of(trial.record) == summary


def test_records_do_not_depend_on_how_many_processes_share_the_work(host: Host, errands: str) -> None:
    experiments = [Experiment(errands, seed=seed, duration=2.0 + seed) for seed in (3, 1, 2)]
    told: List[float] = []

    alone = list(EmbeddedLaboratory(host, 1).trials(experiments))
    shared = list(EmbeddedLaboratory(host, 2, lambda done, planned: told.append(done)).trials(experiments))

    assert [trial.experiment for trial in shared] == experiments
    assert [(trial.record, trial.messages) for trial in shared] == [(trial.record, trial.messages) for trial in alone]
    assert told == [0.0, 1.0, 2.0, 3.0]
    assert multiprocessing.active_children() == []


@pytest.mark.parametrize("processes", [1, 2])
def test_an_error_in_one_experiment_names_application_and_seed_and_stops(
    host: Host, errands: str, processes: int
) -> None:
    experiments = [Experiment(errands, 1, duration=0.5), Experiment(errands, 2, robots=7), Experiment(errands, 3)]
    trials = EmbeddedLaboratory(host, processes).trials(experiments)

    assert next(trials).experiment.seed == 1
    with pytest.raises(ExperimentError) as caught:
        next(trials)
    assert str(caught.value) == f"{errands}, seed 2: --robots 7: errand_yard has 2 robots; give 1 to 2"
    assert caught.value.exit_code == UsageError.exit_code
    assert multiprocessing.active_children() == []


def idle_team(architecture: str = "mrta_alliance", robots: int = 2) -> IdleTeam:
    """Make a team in which each robot has a task of its own, and takes it up in its tenth cycle."""
    tasks = tuple(f"task{number}" for number in range(robots))
    parameters = {}
    for task in tasks:
        fast = {"task_id": task, "motivational_behaviour": {"threshold": 10.0, "impatience": {"fast_rate": 1.0}}}
        sets = {"size": 1, "behaviour_set0": fast}
        parameters[f"robot_of_{task}"] = {"spin_rate": 10.0, "broadcast_rate": 2.0, "behaviour_sets": sets}
    return IdleTeam(architecture, parameters, tasks, duration=3.0, warm_up=2.0)


def test_what_an_idle_team_says_is_counted_in_its_duration_alone(host: Host) -> None:
    """Two robots, 30 cycles: a motivation each; tasks are taken up in the warm-up, and announced twice a second."""
    team = idle_team()
    (cost,) = EmbeddedLaboratory(host).costs([team])

    assert cost.team is team
    assert cost.messages["alliance_msgs/Motivation"] == 60
    assert cost.messages["alliance_msgs/InterRobotCommunication"] == 12
    assert "rqt_mrta_py/TaskProgress" not in cost.messages
    assert cost.processor_time > 0.0


def test_costs_come_in_the_order_of_teams_and_progress_is_told(host: Host) -> None:
    told: List[float] = []
    laboratory = EmbeddedLaboratory(host, progress=lambda done, planned: told.append(done))
    costs = list(laboratory.costs([idle_team(robots=3), idle_team(robots=1)]))

    assert [cost.messages["alliance_msgs/Motivation"] for cost in costs] == [90, 30]
    assert told == [0.0, 1.0, 2.0]


@pytest.mark.parametrize("processes", [1, 2])
def test_other_work_is_shared_too_and_its_outcomes_keep_their_order(host: Host, processes: int) -> None:
    told: List[float] = []
    laboratory = EmbeddedLaboratory(host, processes, lambda done, planned: told.append(done / planned))
    assert list(laboratory.outcomes(lambda item: item**2, [3, 1, 2])) == [9, 1, 4]
    assert told == [0.0, 1 / 3, 2 / 3, 1.0]
    assert multiprocessing.active_children() == []


def test_an_error_in_an_idle_team_names_architecture_and_team(host: Host) -> None:
    with pytest.raises(ExperimentError, match=r"^nobody, 2 idle robots: nobody: "):
        list(EmbeddedLaboratory(host).costs([idle_team("nobody")]))
    broken = dataclasses.replace(idle_team(), parameters={"robot0": {"behaviour_sets": {"size": "many"}}})
    with pytest.raises(ExperimentError, match=r"^mrta_alliance, 1 idle robots: robot0: agent of mrta_alliance"):
        list(EmbeddedLaboratory(host).costs([broken]))
    assert multiprocessing.active_children() == []


def test_an_experiment_changes_what_it_names_and_leaves_the_rest(host: Host, errands: str) -> None:
    missions = ExperimentMissions(host)
    plain, plain_duration = missions.prepare(Experiment(errands, 5))
    radio = RadioSetup("lossy", {"loss": 0.5})
    changed, duration = missions.prepare(
        Experiment(
            errands,
            6,
            duration=9.0,
            world="bullet",
            robots=1,
            settings=("spin_rate=7", "robot1/broadcast_rate=3"),
            events=(),
            radio=radio,
        )
    )

    assert plain.scenario is not None
    assert changed.scenario is not None
    assert (plain_duration, duration, plain.seed, changed.seed) == (DURATION, 9.0, 5, 6)
    assert [robot.id for robot in changed.application.robots] == ["robot1"]
    assert (changed.parameters["robot1"]["spin_rate"], changed.parameters["robot1"]["broadcast_rate"]) == (7.0, 3.0)
    assert len(plain.scenario.events) == 1
    assert dataclasses.replace(
        plain.scenario, world="bullet", robots=plain.scenario.robots[:1], events=(), radio=radio
    ) == (changed.scenario)


def test_settings_for_all_robots_yield_to_those_of_one() -> None:
    assert settings_for(["a", "b"], ["b/x=1", "x=2", "sensors/size=0"]) == [
        "a/x=2",
        "b/x=2",
        "a/sensors/size=0",
        "b/sensors/size=0",
        "b/x=1",
    ]


def test_what_happens_to_tasks_that_are_left_out_is_left_out_too(host: Host, errands: str) -> None:
    events = tuple(ScenarioEvent(1.0, ScenarioEventKind.TASK_WITHDRAWN, task=task) for task in ("north", "south"))
    mission, _ = ExperimentMissions(host).prepare(Experiment(errands, 1, events=events, tasks=("south",)))

    assert [task.id for task in mission.tasks] == ["south"]
    assert mission.scenario is not None
    assert mission.scenario.events == events[1:]


@pytest.mark.parametrize(
    ("experiment", "message"),
    [
        ({"tasks": ("west",)}, "task 'west': the application has no such task; nearest is 'rest'"),
        (
            {"events": (ScenarioEvent(1.0, ScenarioEventKind.TASK_WITHDRAWN, task="noth"),)},
            "task 'noth' of an event: there is no such task; nearest is 'north'",
        ),
        ({"world": "flat"}, "--world flat: there is no such world"),
    ],
)
def test_an_experiment_that_does_not_fit_is_refused(host: Host, errands: str, experiment: dict, message: str) -> None:
    with pytest.raises(UsageError, match=message):
        ExperimentMissions(host).prepare(Experiment(errands, 1, **experiment))


def _square(number: int) -> int:
    time.sleep(0.02 * (number % 3))
    return number * number


def test_answers_come_in_the_order_of_items_whoever_is_quicker() -> None:
    assert list(in_order(_square, range(20), 3)) == [number * number for number in range(20)]
    assert list(in_order(_square, [], 3)) == []


def test_what_a_function_raises_for_the_first_item_is_raised() -> None:
    answers = in_order(lambda number: 1 // (number - 2) // (number - 3), range(5), 2)

    assert [next(answers), next(answers)] == [0, 0]
    with pytest.raises(ZeroDivisionError):
        next(answers)


def test_a_process_that_ends_without_a_word_is_told_of() -> None:
    with pytest.raises(WorkerError, match="ended with status 7"):
        list(in_order(lambda number: os._exit(7), range(3), 2))


def test_who_stops_listening_ends_the_processes() -> None:
    answers = in_order(lambda number: time.sleep(60 * number), range(5), 2)
    next(answers)
    answers.close()  # type: ignore[attr-defined]

    assert multiprocessing.active_children() == []


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_processes_end_with_the_one_that_asks_them(number: signal.Signals) -> None:
    script = (
        "import os, time\n"
        "from rqt_mrta_py.app.bench.workers import in_order\n"
        "def work(number):\n"
        # One call, so that the lines of two processes do not mix in the pipe.
        "    os.write(1, b'%d\\n' % os.getpid())\n"
        "    time.sleep(60)\n"
        "list(in_order(work, range(4), 2))\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True
    ) as process:
        try:
            assert process.stdout is not None
            workers = {int(process.stdout.readline()) for _ in range(2)}
            if number is signal.SIGINT:
                os.killpg(process.pid, number)
            else:
                process.send_signal(number)
            # The pipe's end is reached once nobody is left to write to it.
            rest = process.communicate(timeout=30)[0]
        finally:
            process.kill()

    assert process.returncode != 0
    assert rest == b""
    assert len(workers - {process.pid}) == 2


@dataclasses.dataclass(frozen=True)
class Asleep:
    """One robot's agent decides nothing and says nothing."""

    robot: str

    def __call__(self, setup: AgentSetup, agent: Agent) -> Agent:
        if setup.robot_id == self.robot:
            agent.step = lambda situation: Decision(None)  # type: ignore[method-assign]  # of this object alone
        return agent


@pytest.mark.parametrize("processes", [1, 2])
def test_an_experiment_may_put_other_agents_in_the_place_of_some(host: Host, errands: str, processes: int) -> None:
    """robot1 has no part in it; the other mission is as ever."""
    asleep = Experiment(errands, 1, duration=15.0, events=(), agents=Asleep("robot1"))
    changed, usual = EmbeddedLaboratory(host, processes).trials([asleep, dataclasses.replace(asleep, agents=None)])

    assert {each.robot for each in changed.record.allocations} == {"robot2"}
    assert {each.robot for each in usual.record.allocations} == {"robot1", "robot2"}
    assert changed.experiment == asleep
