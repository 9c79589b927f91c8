"""A stranger's package, put where strangers put theirs, does by hook whatever can be done by hook.

The package lies in ``stranger_pkg``. It is copied elsewhere and found once as a ROS package, once as an installed
Python distribution with an entry point; then the real command is run.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.hooks import HookSpecs
from tests.conftest import require_module

HERE = Path(__file__).parent
HOOKS = [name for name in vars(HookSpecs) if name.startswith("mrta_")]


@dataclass(frozen=True)
class Stranger:
    """The package where it was put, and the command as somebody who has it would run it."""

    application: str
    architecture: str
    environment: Dict[str, str]
    folder: Path

    def mrta(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "rqt_mrta_py", *arguments]
        return subprocess.run(
            command, cwd=self.folder, env=self.environment, capture_output=True, text=True, timeout=120, check=False
        )

    def plan(self, *arguments: str) -> List[str]:
        return ["run", self.application, "--architecture", self.architecture, *arguments]


@dataclass(frozen=True)
class Run:
    """What the stranger's mission left."""

    out: Path
    log: str

    def json(self, name: str) -> Any:
        return json.loads((self.out / name).read_text(encoding="utf-8"))

    def trace(self, topic: str) -> List[Any]:
        return list(self.json("export/trace/trace.json")[topic])


@pytest.fixture(scope="module", params=["ros_package", "distribution"])
def stranger(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Stranger:
    folder = tmp_path_factory.mktemp("elsewhere")
    package = folder / "packages" / "stranger"
    shutil.copytree(str(HERE / "stranger_pkg"), str(package), ignore=shutil.ignore_patterns("__pycache__"))
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("ROS_", "RQT_MRTA_PY_"))}
    if request.param == "ros_package":
        return Stranger("stranger", "stranger", {**environment, "ROS_PACKAGE_PATH": str(package.parent)}, folder)
    require_module("pip")
    site = folder / "site"
    install = ["--no-deps", "--no-build-isolation", "--no-index", "--quiet", "--target", str(site), str(package)]
    subprocess.run([sys.executable, "-m", "pip", "install", *install], env=environment, cwd=folder, check=True)
    # What remains of the package is its data: code must come from where it was installed.
    shutil.rmtree(package / "src")
    environment["PYTHONPATH"] = os.pathsep.join([str(site), *filter(None, [environment.get("PYTHONPATH")])])
    return Stranger(str(package), str(package / "architecture.xml"), environment, folder)


@pytest.fixture(scope="module")
def run(stranger: Stranger) -> Run:
    """Run the stranger's application once: 3 s, work from 0.5 s to 1.5 s."""
    done = stranger.mrta(*stranger.plan("--export", "trace", "--figures", "tunnels", "--out", "out", "-v"))
    assert done.returncode == 0, done.stderr
    return Run(stranger.folder / "out", done.stderr)


def listed(stranger: Stranger, kind: str) -> List[Dict[str, Any]]:
    answer = stranger.mrta("list", kind, "--json")
    assert answer.returncode == 0, answer.stderr
    return list(json.loads(answer.stdout)[kind])


@pytest.fixture(scope="module")
def plugin(stranger: Stranger) -> Dict[str, Any]:
    """Say what the list of plugins tells of the stranger's."""
    (found,) = [each for each in listed(stranger, "plugins") if each["name"] == "stranger"]
    return found


def test_stranger_implements_every_hook_that_there_is(plugin: Dict[str, Any]) -> None:
    """If this fails, a hook is new: let the stranger do something with it that shows, and test that here."""
    assert sorted(plugin["hooks"]) == sorted(HOOKS)


def test_every_hook_is_tested_here() -> None:
    untested = [hook for hook in HOOKS if f"test_hook_{hook}" not in globals()]
    assert untested == []


def test_list_of_hooks_names_the_stranger_everywhere(stranger: Stranger) -> None:
    implemented = {each["name"]: each["implemented_by"] for each in listed(stranger, "hooks")}
    assert [hook for hook in HOOKS if "stranger.plugin" not in implemented[hook]] == []


def test_code_comes_from_where_it_was_put(stranger: Stranger, plugin: Dict[str, Any]) -> None:
    assert stranger.folder in Path(plugin["folder"]).parents
    assert HERE not in Path(plugin["folder"]).parents


def test_hook_mrta_register_agents(run: Run) -> None:
    """Both take what their agents choose, when they choose it."""
    taken = [(each["robot"], each["task"]) for each in run.json("summary.json")["allocations"]]
    assert sorted(taken) == [("mole1", "heap"), ("mole2", "dig")]


def test_hook_mrta_register_allocators(run: Run) -> None:
    """The first robot got the last task."""
    assert {each["robot"]: each["task"] for each in run.json("summary.json")["allocations"]}["mole1"] == "heap"


def test_hook_mrta_register_allocation_interpreters(run: Run) -> None:
    assert [each["outcome"] for each in run.json("summary.json")["allocations"]] == ["gave_up", "gave_up"]
    assert "mole1 has given up heap: too hard" in (run.out / "events.jsonl").read_text(encoding="utf-8")


def test_hook_mrta_register_sensory_evaluators(run: Run) -> None:
    """Not before 1.5 s on the stream's clock, which begins at 1 s."""
    assert [each["from"] for each in run.json("summary.json")["allocations"]] == [1.5, 1.5]


def test_hook_mrta_register_robot_sensors(run: Run) -> None:
    """The stranger's whiskers believe half of the mileage, 0.7 m in the end; the agent repeats what they read."""
    assert run.trace("/mole1/felt")[:5] == [0.0] * 5
    assert run.trace("/mole1/felt")[-1] == pytest.approx(0.35)


def test_hook_mrta_register_behaviours(run: Run) -> None:
    """They stood still until they had a task, and again afterwards."""
    mileage = run.trace("/mole1/mileage")
    assert mileage[:6] == [0.0] * 6
    assert mileage[-1] == mileage[-10] > 0.0


def test_hook_mrta_register_robot_models(run: Run) -> None:
    """A mole's 0.7 m/s for 1 s."""
    assert run.trace("/mole1/mileage")[-1] == pytest.approx(0.7)


def test_hook_mrta_register_worlds(run: Run) -> None:
    """In a burrow nobody slows down: 0.07 m in each tick of 0.1 s from the first."""
    assert run.trace("/mole2/mileage")[6:9] == pytest.approx([0.07, 0.14, 0.21])


def test_hook_mrta_register_sensors(run: Run) -> None:
    """An odometer at 10 Hz for 3 s, both ends included."""
    assert len(run.trace("/mole1/mileage")) == 31


def test_hook_mrta_register_team_sensors(run: Run) -> None:
    """Of two moles the first lies lower, and is told so as often as the other."""
    assert run.trace("/mole1/rank") == [1] * 31
    assert run.trace("/mole2/rank") == [2] * 31


def test_hook_mrta_register_planners(run: Run) -> None:
    """Every way is 42 m long, and behaviours ask for it."""
    assert set(run.trace("/mole1/claim/heap")) == {"42.0"}


def test_hook_mrta_register_links(run: Run) -> None:
    """One's own greeting is heard with the next cycle, 0.1 s later; the other's is 0.4 s on its way."""
    delays = sorted({round(delay, 6) for delay in run.trace("/mole1/late_by")})
    assert delays[0] == 0.1
    assert {0.4} <= set(delays[1:]) <= {0.4, 0.5}


def test_hook_mrta_register_incident_rules(run: Run) -> None:
    incidents = run.json("summary.json")["incidents"]
    assert {each["rule"] for each in incidents} == {"somebody_works"}
    assert {each["text"] for each in incidents} == {"work in the Garden"}


def test_hook_mrta_register_allocation_paces(run: Run) -> None:
    incidents = run.json("summary.json")["incidents"]
    assert {each["causes"] for each in incidents} == {"moles that take it up within 42 s"}


def test_hook_mrta_register_statistics(run: Run) -> None:
    assert run.json("summary.json")["statistics"]["gave_up"] == 2


def test_hook_mrta_register_measures(run: Run) -> None:
    """Each of two moles dug for 1 s at 0.7 m/s."""
    assert run.json("summary.json")["statistics"]["mileage"] == {"mole1": 0.7, "mole2": 0.7, "each": 0.7}


def test_hook_mrta_register_renderers(run: Run) -> None:
    picture = require_module("cv2").imread(str(run.out / "monitor" / "000001.000.png"))  # type: ignore[attr-defined]
    assert picture.shape == (8, 16, 3)


def test_hook_mrta_register_monitor_panels(run: Run) -> None:
    """At 1 s the panel has 11 points, and the stranger's picture is as grey as that."""
    picture = require_module("cv2").imread(str(run.out / "monitor" / "000001.000.png"))  # type: ignore[attr-defined]
    assert set(picture.ravel().tolist()) == {11}


def test_hook_mrta_register_exporters(run: Run) -> None:
    trace = run.json("export/trace/trace.json")
    assert (trace["application"], trace["allocations"]) == (["Garden"], 2)


def test_hook_mrta_register_figures(run: Run) -> None:
    """One picture, 1600 pixels wide, with bars in it."""
    picture = require_module("cv2").imread(str(run.out / "figures" / "tunnels" / "dug.png"))  # type: ignore[attr-defined]
    assert picture.shape[1] == 1600
    assert (picture == (190, 135, 38)).all(axis=2).sum() > 10_000


def test_hook_mrta_register_grounds_readers(stranger: Stranger, run: Run) -> None:
    """Every way is 42 m long; the heap's mole claims it at 1.5 s of a stream that begins at 1 s."""
    bag = str(run.out / "mission.bag")
    done = stranger.mrta("review", bag, "--out", "why", "--pictures", "0", "--why", "heap", "--json")
    assert done.returncode == 0, done.stderr
    (task,) = json.loads(done.stdout)["why"]["tasks"]
    assert [(each["time"], each["robot"], each["text"]) for each in task["grounds"]] == [
        (1.5, "mole1", "dug for 42.0 in the Garden")
    ]


def test_hook_mrta_register_message_observers(run: Run) -> None:
    assert run.log.count("INFO stranger: an ear in the Garden") == 1
    assert run.log.count("INFO stranger: heard of mole2: too hard") == 1


def test_hook_mrta_on_mission_start(run: Run) -> None:
    assert run.log.count("INFO stranger: begins: Garden") == 1


def test_hook_mrta_on_event(run: Run) -> None:
    told = [line.partition("event: ")[2] for line in run.log.splitlines() if line.startswith("INFO stranger: event: ")]
    events = (run.out / "events.jsonl").read_text(encoding="utf-8").splitlines()
    assert told == [json.loads(event)["text"] for event in events]


def test_hook_mrta_on_mission_end(run: Run) -> None:
    assert run.log.count("INFO stranger: ends after 3 s") == 1


def test_hook_mrta_register_verbs(stranger: Stranger) -> None:
    heap = stranger.mrta("molehill", "5")
    assert (heap.returncode, heap.stdout) == (0, "ooooo\n")
    assert stranger.mrta("molehill", "10", "--out", "heaps").returncode == 1
    assert (stranger.folder / "heaps/heap.txt").read_text(encoding="utf-8") == "10\n"
    assert (stranger.folder / "heaps/heap.png").read_bytes().startswith(b"\x89PNG")
    again = stranger.mrta("molehill", "1", "--out", "heaps")
    assert (again.returncode, "the folder is not empty" in again.stderr) == (2, True)


def test_hook_mrta_register_assembly_planners(stranger: Stranger) -> None:
    planned = stranger.mrta("plan-structure", "wall", "--method", "crumbs", "--set", "worms=3", "--json")
    assert planned.returncode == 0, planned.stderr
    assert json.loads(planned.stdout)["counts"] == {"1": 14, "2": 0, "3": 0}


def test_hook_mrta_register_mission_makers(stranger: Stranger) -> None:
    shown = stranger.mrta("show", stranger.application, "--json")
    (application,) = [each for each in json.loads(shown.stdout)["registered"] if each["kind"] == "application"]
    assert application["settings"] == [{"name": "heaps", "text": "how many more", "default": "0"}]
    done = stranger.mrta(*stranger.plan("--set", "heaps=2", "--duration", "1", "--pictures", "0", "--out", "heaps_run"))
    assert done.returncode == 0, done.stderr
    summary = json.loads((stranger.folder / "heaps_run/summary.json").read_text(encoding="utf-8"))
    assert [task["id"] for task in summary["tasks"]] == ["dig", "heap", "heap0", "heap1"]


def test_hook_mrta_register_benchmarks(stranger: Stranger) -> None:
    measured = stranger.mrta("bench", "burrowing", "--depth", "2.5")
    assert measured.returncode == 0, measured.stderr
    assert [word for word in ("Digging", "depth [m]", "2.5", "Worms may vary.") if word not in measured.stdout] == []


def test_hook_mrta_check_parameters(stranger: Stranger) -> None:
    refused = stranger.mrta(*stranger.plan("--set", "mole2/patience=0", "--out", "never"))
    assert refused.returncode == 3
    assert "mole2/patience: mole2 has none left for 2 tasks" in refused.stderr
    assert not (stranger.folder / "never").exists()


def test_review_of_the_strangers_bag_gives_what_the_run_gave(stranger: Stranger, run: Run) -> None:
    """The stranger's rule, interpreter, statistic and exporter hear a bag as they heard the run."""
    done = stranger.mrta(
        *("review", str(run.out / "mission.bag"), "--out", "again", "--pictures", "0"),
        *("--export", "trace", "--figures", "tunnels"),
    )
    assert done.returncode == 0, done.stderr
    for name in (
        "summary.json",
        "events.jsonl",
        "incidents.jsonl",
        "export/trace/trace.json",
        "figures/tunnels/dug.png",
    ):
        assert (stranger.folder / "again" / name).read_bytes() == (run.out / name).read_bytes(), name
