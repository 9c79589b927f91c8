"""Every hook keeps its promise to a stranger: what one plugin registers takes effect in a mission of two seconds."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import pytest

from rqt_mrta_py.app.catalogue.plugins import hook_entries, plugin_entries
from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.making import making_of
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.exports import exporters_for
from rqt_mrta_py.app.outputs.figures import figure_makers_for
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.picture_files import PictureFiles
from rqt_mrta_py.app.outputs.pictures import PictureSchedule
from rqt_mrta_py.app.review.why import Why
from rqt_mrta_py.app.run.embedded import EmbeddedRun
from rqt_mrta_py.app.run.watch import WatchPlan, open_watch
from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.hooks.contract import HOOKS
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Explanation, Ground, MissionRecord, Twist
from rqt_mrta_py.transport import read_bag
from tests.hooks.garden import MISSION, MOLE
from tests.hooks.stranger import Stranger


class Story(NamedTuple):
    """What a mission with the stranger's plugin alone left behind."""

    stranger: Stranger
    stream: List[Stamped]
    heard: List[Any]
    record: MissionRecord
    pictures: List[Path]
    folder: Path
    explanations: Sequence[Explanation]


@pytest.fixture(scope="module")
def story(tmp_path_factory: pytest.TempPathFactory) -> Story:
    stranger = Stranger()
    manager = PluginManager()
    manager.register(stranger, "stranger")
    host = Host(discover({}, prefix="/nowhere", shares=(), distributions=()), manager, [])
    codec = host.codec()
    folder = OutputFolder(tmp_path_factory.mktemp("out"))
    monitor = folder.monitor(wanted=True)
    assert monitor is not None
    exporters = exporters_for(MISSION, ["ledger", "transcript"], manager)
    figures = figure_makers_for(MISSION, ["chronicle"], manager)
    why = Why(MISSION, ["dig"], manager)
    observation = Observation(MISSION, codec, manager, 1.5, (*exporters.values(), *figures.values(), *why.listeners))
    run = EmbeddedRun(MISSION, 1.5, codec, manager)
    pictures = PictureSchedule(host.renderer("monitor"), 5, 10, PictureFiles(monitor))
    plan = WatchPlan(
        *(observation, folder, run.clock, run.last_tick, False, pictures, None, exporters, manager.patience, figures)
    )
    with open_watch(plan, run.bus) as watch:
        for tick in range(run.last_tick + 1):
            run.step(tick)
            watch.end_tick(tick)
        record = watch.finish().record
    run.close()
    stream = list(read_bag(folder.path / "mission.bag"))
    heard = [(each.connection.topic, codec.decode(each.connection, each.raw)) for each in stream]
    return Story(stranger, stream, heard, record, sorted(monitor.iterdir()), folder.path, why.explain(record))


@pytest.fixture
def host(monkeypatch: pytest.MonkeyPatch) -> Host:
    """Let the command know the stranger's plugin alone."""
    manager = PluginManager()
    manager.register(Stranger(), "stranger")
    host = Host(discover({}, prefix="/nowhere", shares=(), distributions=()), manager, [])
    monkeypatch.setattr("rqt_mrta_py.app.compose.compose", lambda: host)
    return host


def said(story: Story, topic: str) -> List[Any]:
    return [fields for name, fields in story.heard if name == topic]


@pytest.mark.parametrize("hook", HOOKS)
def test_every_hook_has_a_test_of_its_own_here(hook: str) -> None:
    name = f"test_hook_{hook}"
    assert any(each == name or each.startswith(f"{name}_") for each in globals())
    assert hasattr(Stranger, hook)


def test_hook_mrta_register_agents_decides_for_a_robot_of_its_architecture(story: Story) -> None:
    (allocation,) = story.record.allocations
    assert (allocation.robot, allocation.task, allocation.start, allocation.end) == ("mole1", "dig", 1.5, 2.0)


def test_hook_mrta_register_allocation_interpreters_says_how_an_allocation_ended(story: Story) -> None:
    (ended,) = [event for event in story.stranger.events if event.kind == "allocation_ended"]
    assert (ended.time, ended.state, ended.text) == (2.0, "gave_up", "mole1 has given up dig: too hard")


def test_hook_mrta_register_allocation_paces_says_what_rules_measure_by(story: Story) -> None:
    (incident,) = story.record.incidents
    assert incident.causes == "moles that dig for 2 s or longer"


def test_hook_mrta_register_behaviours_carries_out_its_kind_and_tells_the_cost(story: Story) -> None:
    assert [fields["data"] for fields in said(story, "/mole1/claim/dig")] == ["3.0 m"] * 5
    driven = [fields["linear"]["x"] for fields in said(story, "/mole1/cmd_vel")]
    assert max(driven) == MOLE.max_speed


def test_hook_mrta_register_sensory_evaluators_is_asked_by_the_agent(story: Story) -> None:
    claims = [each for each in story.stream if each.connection.topic == "/mole1/claim/dig"]
    assert claims[0].receipt_ns == 1_500_000_000


def test_hook_mrta_register_robot_sensors_is_read_by_the_agent_for_its_evaluators(story: Story) -> None:
    """The evaluator would let it begin at 1.3 s; the sixth mileage is said, and heard, at 1.5 s."""
    felt = [each.receipt_ns for each in story.stream if each.connection.topic == "/mole1/mileage"]
    claims = [each.receipt_ns for each in story.stream if each.connection.topic == "/mole1/claim/dig"]
    assert (felt[5], claims[0]) == (1_500_000_000, 1_500_000_000)


def test_hook_mrta_register_allocators_is_asked_by_the_agent_and_obeyed(story: Story) -> None:
    problems = story.stranger.problems
    assert [(each.robots, each.tasks, each.costs.tolist()) for each in problems] == [
        (("mole1",), MISSION.tasks, [[3.0]])
    ] * 5
    assert len(said(story, "/mole1/claim/dig")) == 5


def test_hook_mrta_register_planners_finds_ways_for_behaviours(story: Story) -> None:
    """The way straight to the task is 1.5 m long; the stranger's is twice that."""
    assert {fields["data"] for fields in said(story, "/mole1/claim/dig")} == {"3.0 m"}


def test_hook_mrta_register_links_decides_what_robots_hear_of_others(story: Story) -> None:
    """Claims are said at 1.5, 1.6, ... 1.9 s; the radio opens at 1.65 s."""
    assert len(said(story, "/mole1/claim/dig")) == 5
    assert [fields["data"] for fields in said(story, "/mole2/echo")] == ["3.0 m"] * 3


def test_hook_mrta_register_worlds_is_stepped_and_commanded(story: Story) -> None:
    world = story.stranger.world
    assert world.setup is not None
    assert (world.setup.tick, world.steps, world.closed) == (0.1, 16, 1)
    assert world.commands == {"mole1": Twist(), "mole2": Twist()}


def test_hook_mrta_register_robot_models_says_what_is_built(story: Story) -> None:
    setup = story.stranger.world.setup
    assert setup is not None
    assert [robot.model for robot in setup.robots] == [MOLE, MOLE]


def test_hook_mrta_register_sensors_publishes_in_the_namespace_of_its_robot(story: Story) -> None:
    assert [fields["data"] for fields in said(story, "/mole1/mileage")] == [1.5] * 16


def test_hook_mrta_register_team_sensors_publishes_in_the_namespace_of_each_robot(story: Story) -> None:
    assert [fields["data"] for fields in said(story, "/mole1/smell")] == [2.0] * 16
    assert [fields["data"] for fields in said(story, "/mole2/smell")] == [2.0] * 16


def test_hook_mrta_register_incident_rules_puts_up_incidents(story: Story) -> None:
    (incident,) = story.record.incidents
    assert (incident.rule, incident.start, incident.text) == ("any_allocation", 1.5, "somebody works in Garden")


def test_hook_mrta_register_statistics_sums_the_mission_up(story: Story) -> None:
    assert story.record.statistics["gave_up"] == 1


def test_hook_mrta_register_measures_sums_up_what_it_heard(story: Story) -> None:
    measured = {"Garden": "mole1 3.0 m", "of": 5, "allocated": 1}
    assert story.record.statistics == {"dearest_claim": measured, "gave_up": 1}


def test_hook_mrta_register_monitor_panels_shows_in_the_pictures(story: Story) -> None:
    (panel,) = story.stranger.views[1].panels
    (curve,) = panel.groups[0].curves
    assert curve.times == pytest.approx([1.0, 1.1, 1.2, 1.3, 1.4, 1.5])
    assert set(curve.values) == {1.5}


def test_hook_mrta_register_renderers_draws_every_period(story: Story) -> None:
    assert [view.now for view in story.stranger.views] == [1.0, 1.5, 2.0, 2.5]
    assert len(story.pictures) == 4
    assert len(said(story, "/mrta/monitor/compressed")) == 4


def test_hook_mrta_register_exporters_leaves_the_files_that_are_asked_for(story: Story) -> None:
    assert (story.folder / "export" / "ledger" / "ledger.txt").read_text() == "mole1 dig 3.0 m\n1 in all"


def test_hook_mrta_register_exporters_are_handed_the_messages_of_the_bag(story: Story) -> None:
    folder = story.folder / "export" / "transcript"
    assert [path.name for path in folder.iterdir()] == ["transcript.txt"]
    sizes: Dict[str, int] = {}
    for stamped in story.stream:
        sizes[stamped.connection.topic] = sizes.get(stamped.connection.topic, 0) + len(stamped.raw)
    lines = ["1 in all", *(f"{topic} {sizes[topic]}" for topic in sorted(sizes))]
    assert (folder / "transcript.txt").read_text().splitlines() == lines


def test_hook_mrta_register_figures_leaves_the_pictures_that_are_asked_for(story: Story) -> None:
    (picture,) = (story.folder / "figures" / "chronicle").iterdir()
    assert (picture.name, picture.read_bytes()[:4]) == ("mileage.png", b"\x89PNG")


def test_hook_mrta_register_grounds_readers_tells_why_a_task_was_taken(story: Story) -> None:
    (explanation,) = story.explanations
    assert explanation.grounds == (Ground(1.5, "dig", "3.0 m away in Garden", "mole1", {"cost": "3.0 m"}),)
    assert [(spell.robot, spell.start, spell.end) for spell in explanation.spells] == [
        ("", 1.0, 1.5),
        ("mole1", 1.5, 2.0),
        ("", 2.0, 2.5),
    ]


def test_hook_mrta_register_message_observers_hears_the_stream(story: Story) -> None:
    assert [heard.fields["data"] for heard in story.stranger.overheard] == [1.5] * 16
    assert {heard.robot for heard in story.stranger.overheard} == {"mole1"}


def test_hook_mrta_register_assembly_planners_is_found_by_verbs(host: Host, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["dig-deeper"]) == 1
    assert capsys.readouterr().out == "dug 1.0 m below what molehill plans\n"


@pytest.mark.parametrize(
    ("robots", "overrides", "distance", "team"),
    [(None, (), 0.6, 180.0), (3, (), 0.6, 180.0), (2, (), 0.6, 2.0), (None, ("distance=0.9",), 0.9, 3.0)],
    ids=["nothing set", "the usual team", "another team", "a setting"],
)
def test_hook_mrta_register_mission_makers_makes_tasks_and_scenario_of_settings(
    host: Host, robots: Optional[int], overrides: Tuple[str, ...], distance: float, team: float
) -> None:
    making = making_of(host, "border_patrol", overrides, robots)
    mission = load_mission(host.registry, "border_patrol", rewrite=making.rewrite)
    assert {task.id: task.data.get("distance") for task in mission.tasks}["border_protection"] == distance
    assert mission.scenario is not None
    assert (mission.scenario.duration, making.robots) == (team, robots or 3)


def test_hook_mrta_register_verbs_adds_to_the_command(host: Host, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["dig-deeper", "--depth", "2"]) == 1
    assert capsys.readouterr().out == "dug 2.0 m below what molehill plans\n"


def test_hook_mrta_register_benchmarks_is_measured(host: Host, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "holes", "--depth", "2"]) == 0
    assert capsys.readouterr().out == "Holes\n\ndepth [m]\n2\n"


@pytest.mark.parametrize("hook", HOOKS)
def test_every_hook_is_used_by_a_plugin_of_this_project(hook: str) -> None:
    """Read from the sources, without importing them."""
    own = discover({}, prefix="/nowhere", shares=(), distributions=())
    assert hook_entries(plugin_entries(own, ()))[hook] != []


def test_hook_mrta_check_parameters_refuses_a_value_where_it_was_set(root: Path) -> None:
    manager = PluginManager()
    manager.register(Stranger(), "stranger")
    registry = discover({}, prefix="/nowhere", shares=(), distributions=())

    with pytest.raises(ConfigError) as caught:
        load_mission(registry, "border_patrol", overrides=["robot2/spin_rate=3"], checks=manager)

    assert str(caught.value) == "--set: robot2/spin_rate: 3.0 Hz is too much for 3 tasks"


def test_hook_mrta_on_mission_start_comes_first_and_once(story: Story) -> None:
    assert story.stranger.missions == [MISSION]


def test_hook_mrta_on_event_tells_each_event_of_the_record_in_order(story: Story) -> None:
    assert tuple(story.stranger.events) == story.record.events
    assert len(story.stranger.events) >= 6


def test_hook_mrta_on_mission_end_is_given_the_finished_record(story: Story) -> None:
    assert story.stranger.records == [story.record]
    assert story.record.statistics
