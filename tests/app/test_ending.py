"""A mission ends at its duration, or where its scenario says so a while after its last task has ended."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import pytest

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.run.ending import MissionEnd
from rqt_mrta_py.app.run.preparation import Preparation
from rqt_mrta_py.app.run.request import RunRequest
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, Arena, Mission, Progress, ScenarioSpec, Task, Taxonomy
from rqt_mrta_py.transport import read_bag
from tests.app.errand_yard import DURATION, write_errand_yard
from tests.app.outputs import Mrta

LINGER = 2.0


def end_of(*tasks: Task, linger: Any = LINGER, later: Tuple[Task, ...] = ()) -> MissionEnd:
    scenario = ScenarioSpec(Arena(0.0, 0.0, 1.0, 1.0), (), (), linger=linger)
    spec = ArchitectureSpec("a", "a", Taxonomy())
    return MissionEnd(Mission(ApplicationSpec("app", "app"), spec, tasks, scenario=scenario, later_tasks=later))


def told(end: MissionEnd, *said: Tuple[str, Progress, float]) -> MissionEnd:
    for task, progress, stamp in said:
        end.take_in(task, progress.code, stamp)
    return end


def test_the_end_comes_a_while_after_the_last_task_has_ended_however_it_ended() -> None:
    end = told(end_of(Task("a", "k"), Task("b", "k")), ("a", Progress.FAILED, 5.0))
    assert not end.is_over(100.0)
    told(end, ("b", Progress.DONE, 9.0))
    assert [end.is_over(now) for now in (10.9, 11.0, 12.0)] == [False, True, True]


def test_a_task_that_appears_anew_puts_the_end_off_until_it_has_ended_again() -> None:
    end = told(end_of(Task("a", "k")), ("a", Progress.DONE, 5.0), ("a", Progress.APPEARED, 6.0))
    assert not end.is_over(50.0)
    assert told(end, ("a", Progress.WITHDRAWN, 51.0)).is_over(53.0)


def test_who_never_ends_is_not_waited_for_and_who_is_to_appear_is() -> None:
    end = told(end_of(Task("a", "k"), Task("p", "k", perpetual=True)), ("a", Progress.DONE, 1.0))
    assert end.is_over(3.0)
    end = told(end_of(Task("a", "k"), later=(Task("b", "k"),)), ("a", Progress.DONE, 1.0))
    assert not end.is_over(3.0)


@pytest.mark.parametrize(
    "end", [end_of(Task("a", "k"), linger=None), end_of(Task("p", "k", perpetual=True))], ids=["not asked", "perpetual"]
)
def test_other_missions_go_on_to_their_duration(end: MissionEnd) -> None:
    assert not end.is_awaited
    assert not told(end, ("a", Progress.DONE, 0.0)).is_over(1e9)


@pytest.fixture
def lingering(tmp_path: Path) -> Path:
    yard = tmp_path / "errand_yard"
    write_errand_yard(yard)
    scenario = yard / "scenario.yaml"
    scenario.write_text(scenario.read_text().replace("duration:", f"linger: {LINGER:g}\nduration:"))
    return yard


def summary_of(out: Path) -> Dict[str, Any]:
    summary: Dict[str, Any] = json.loads((out / "summary.json").read_text())
    return summary


def bag_of(out: Path) -> List[Tuple[str, int]]:
    return [(connection.topic, receipt) for connection, receipt, _ in read_bag(out / "mission.bag")]


@pytest.mark.parametrize("processes", [1, 2])
def test_a_run_ends_early_as_whole_as_at_its_duration(
    mrta: Mrta, lingering: Path, tmp_path: Path, processes: int
) -> None:
    out = tmp_path / "out"
    status, _ = mrta("run", str(lingering), "--out", str(out), "--pictures", "1", "--processes", str(processes))
    assert status == 0
    summary = summary_of(out)
    ends = [task["history"][-1] for task in summary["tasks"] if task["id"] != "rest"]
    assert [each["state"] for each in ends] == ["done", "done"]
    over = summary["time"]["end"]
    assert over == pytest.approx(max(each["from"] for each in ends) + LINGER, abs=0.11)
    assert over < DURATION
    said = bag_of(out)
    last = max(receipt for _, receipt in said)
    assert ("/mrta/team_state", last) in said
    pictures = sorted((out / "monitor").glob("*.png"))
    assert sum(topic == "/mrta/monitor/compressed" for topic, _ in said) == len(pictures) > 0


@pytest.mark.parametrize(
    ("file_says", "asked", "planned"),
    [("", None, DURATION), ("linger: 0\n", None, None), ("linger: 2\n", None, None), ("linger: 2\n", 5.0, 5.0)],
)
def test_a_run_plans_for_a_duration_unless_its_mission_ends_any_time_before(
    tmp_path: Path, file_says: str, asked: Optional[float], planned: Optional[float]
) -> None:
    yard = tmp_path / "errand_yard"
    write_errand_yard(yard)
    scenario = yard / "scenario.yaml"
    scenario.write_text(file_says + scenario.read_text())
    observation = Preparation(compose(), RunRequest(str(yard), duration=asked)).observe()
    assert observation.dashboard_view(observation.finish()).duration == planned


@pytest.mark.parametrize(("asked", "told"), [((), 0.0), (("--duration", "5"), 5.0)])
def test_its_bag_tells_a_planned_duration_only_if_somebody_has_planned_one(
    mrta: Mrta, lingering: Path, tmp_path: Path, asked: Tuple[str, ...], told: float
) -> None:
    out = tmp_path / "out"
    assert mrta("run", str(lingering), "--out", str(out), "--pictures", "0", *asked)[0] == 0
    codec = compose().codec()
    said = next(each for each in read_bag(out / "mission.bag") if each[0].topic == "/mrta/mission")
    assert codec.decode(said[0], said[2])["duration"] == told


def test_its_bag_reviews_to_what_the_run_said(mrta: Mrta, lingering: Path, tmp_path: Path) -> None:
    run, review = tmp_path / "run", tmp_path / "review"
    assert mrta("run", str(lingering), "--out", str(run), "--pictures", "0")[0] == 0
    assert mrta("review", str(run / "mission.bag"), "--out", str(review), "--pictures", "0")[0] == 0
    assert (run / "events.jsonl").read_text() == (review / "events.jsonl").read_text()
    assert summary_of(run)["tasks"] == summary_of(review)["tasks"]
