"""Parts made by plugins that raise, take for ever, or are and answer what does not fit: one line that names them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.app.outputs import Mrta

IMPORTS = "from rqt_mrta_py.hooks import *\nfrom rqt_mrta_py.model import *\n\n\n"
AGENT = """
class Part:
    rate = 10.0

    def __init__(self, setup):
        pass

    def subscriptions(self):
        return ()

    def step(self, situation):
        return {answer}
"""
BEHAVIOUR = """
class Part:
    def __init__(self, setup):
        pass

    def subscriptions(self):
        return {wishes}

    def applicable(self, task, perception):
        return {answer}

    def cost(self, task, perception):
        return {cost}

    def start(self, task, perception):
        pass

    def step(self, task, perception):
        return BehaviourStep()
"""
WORLD = """
from rqt_mrta_py.sim.planar import PlanarWorld
import numpy as np


class Part(PlanarWorld):
    def {method}:
        return {answer}
"""
PLANNER = """
class Part:
    def __init__(self, setup):
        pass

    def path(self, start, goal):
        return {answer}

    def cost_field(self, goal):
        return {field}

    def observe(self, obstacles):
        pass


class Field:
    def __init__(self, length):
        self.length = length

    def at(self, place):
        return self.length
"""
LINK = """
class Part:
    def __init__(self, setup):
        {made}

    def deliveries(self, sender, receiver, now):
        return {answer}
"""
LISTENER = """
class Part:
    rays = {rays}

    def __init__(self, setup):
        pass

    def subscriptions(self):
        return {wishes}

    def hear(self, heard, board=None):
        return {answer}

    def notice(self, fact, board):
        pass

    def wake(self, time, board):
        {answer}

    def finish(self, time, board):
        pass

    def view(self, start, end):
        return {answer}

    def export(self, record):
        return {answer}

    def figures(self, record):
        return {answer}

    def value(self, record):
        return {answer}

    def sense(self, moment):
        return {answer}
"""


USUAL = {"answer": "None", "cost": "None", "field": "Field(None)", "made": "pass", "rays": "None", "wishes": "()"}


def plugin(hook: str, name: str, part: str, factory: str = "Part", **parts: str) -> str:
    """Write a plugin that registers one part."""
    registers = f"@hookimpl\ndef mrta_register_{hook}():\n    return {{{name!r}: {factory}}}\n"
    return IMPORTS + part.format(**{**USUAL, **parts}) + "\n\n" + registers


PANEL_NAME = "rqt_alliance/alliance_plugin"
ODOM = "[Subscription('/robot1/odom')]"
MISFITS = {
    "agent, no answer": (
        plugin("agents", "mrta_alliance", AGENT),
        "robot1: agent Part failed at 1.000 s: TypeError: answered None; accepted is Decision",
    ),
    "agent, no task": (
        plugin("agents", "mrta_alliance", AGENT, answer="Decision(['wander'])"),
        "robot1: agent Part failed at 1.000 s: TypeError: answered ['wander']; accepted is str",
    ),
    "agent, none made": (
        plugin("agents", "mrta_alliance", AGENT, "lambda setup: None"),
        "robot1: agent of mrta_alliance: made None, which has no 'rate'",
    ),
    "behaviour, none made": (
        plugin("behaviours", "wander", BEHAVIOUR, "lambda setup: None"),
        "robot1: behaviour 'wander': made None, which has no 'subscriptions'",
    ),
    "behaviour that raises": (
        plugin("behaviours", "wander", BEHAVIOUR, answer="1 / 0"),
        "robot1: behaviour 'wander' on task 'wander' cannot begin: ZeroDivisionError: division by zero",
    ),
    "behaviour, applicable is no truth value": (
        plugin("behaviours", "wander", BEHAVIOUR, answer="'yes'"),
        "robot1: behaviour 'wander' on task 'wander' cannot begin: TypeError: applicable answered 'yes'; accepted is "
        "bool",
    ),
    "planner, none made": (
        plugin("planners", "astar", "", "lambda setup: None"),
        "robot1: planner astar: made None, which has no 'path'",
    ),
    "world that raises": (
        plugin("worlds", "bullet", "", "lambda: 1 / 0"),
        "world bullet: ZeroDivisionError: division by zero",
    ),
    "world, none made": (
        plugin("worlds", "bullet", "", "lambda: None"),
        "world bullet: made None, which has no 'capabilities'",
    ),
    "world, no capabilities": (
        plugin("worlds", "bullet", WORLD + "\n    capabilities = 3\n", method="again(self)"),
        "world bullet: capabilities answered 3; accepted is a frozenset of texts",
    ),
    "world, no poses": (
        plugin("worlds", "bullet", WORLD, method="poses(self)"),
        "world bullet: poses answered None; accepted is an array of float64 of shape (5, 3)",
    ),
    "world, poses of another shape": (
        plugin("worlds", "bullet", WORLD, method="poses(self)", answer="np.zeros((3, 5))"),
        "world bullet: poses answered an array of shape (3, 5); accepted is (5, 3)",
    ),
    "world, poses of another type": (
        plugin("worlds", "bullet", WORLD, method="poses(self)", answer="np.zeros((5, 1), int)"),
        "world bullet: poses answered array([[0], [0], [0], [0], [0]]); accepted is an array of float64 of "
        "shape (5, 3)",
    ),
    "world, poses that are nowhere": (
        plugin("worlds", "bullet", WORLD, method="poses(self)", answer="np.diag([0.0, np.nan, 0.0, 0.0, 0.0])[:, :3]"),
        "world bullet: poses answered [0.0, nan, 0.0] for robot2; accepted are finite",
    ),
    "world, no ranges": (
        plugin("worlds", "bullet", WORLD, method="ranges(self, robots, bearings, max_range)", answer="[]"),
        "world bullet: ranges answered []; accepted is an array of float64 of shape (5, 36)",
    ),
    "world, ranges below nothing": (
        plugin(
            "worlds",
            "bullet",
            WORLD,
            method="ranges(self, robots, bearings, max_range)",
            answer="np.full((len(robots), len(bearings)), -0.5)",
        ),
        "world bullet: ranges answered -0.5 m; accepted are 0 m and above",
    ),
    "robot model, no radius": (
        plugin("robot_models", "diff_drive", "", "RobotModel('m', 'omni', 1, 1, 1, float('nan'), 1, 1, 1, 1, 1, 1)"),
        "plugin 'stranger_plugin': mrta_register_robot_models raised ValueError: robot model m: radius must be a "
        "finite number above 0 (got nan)",
    ),
    "sensor, no messages": (
        plugin("sensors", "odometry", LISTENER),
        "robot robot1: sensor odometry on odom: answered None; accepted is a sequence of Outgoing",
    ),
    "sensor, one message that is in no sequence": (
        plugin("sensors", "odometry", LISTENER, answer="Outgoing('odom', 'std_msgs/String', {})"),
        "robot robot1: sensor odometry on odom: answered Outgoing(topic='odom', type='std_msgs/String', fields={{}}, "
        "la...; accepted is a sequence of Outgoing",
    ),
    "sensor, no message": (
        plugin("sensors", "odometry", LISTENER, answer="['x']"),
        "robot robot1: sensor odometry on odom: answered 'x'; accepted is Outgoing",
    ),
    "sensor, a message without topic": (
        plugin("sensors", "odometry", LISTENER, answer="[Outgoing(None, 'std_msgs/String', {})]"),
        "robot robot1: sensor odometry on odom: answered an Outgoing on None of type 'std_msgs/String'; accepted are "
        "two texts",
    ),
    "sensor, a message without fields": (
        plugin("sensors", "odometry", LISTENER, answer="[Outgoing('odom', 'std_msgs/String', None)]"),
        "robot robot1: sensor odometry on odom: answered an Outgoing on 'odom' with fields None; accepted is a mapping",
    ),
    "sensor, odometry that is none": (
        plugin("sensors", "odometry", LISTENER, answer="[Outgoing('odom', 'nav_msgs/Odometry', {'pose': 3})]"),
        "/robot1/driver on /robot1/odom: nav_msgs/Odometry: pose: 3 does not fit; accepted is the fields of a "
        "geometry_msgs/PoseWithCovariance by name",
    ),
    "sensor, none made": (
        plugin("sensors", "odometry", "", "lambda context: None"),
        "sensor odometry: made None, which has no 'rays'",
    ),
    "sensor that raises": (
        plugin("sensors", "odometry", LISTENER, answer="1 / 0"),
        "the mission's tick at 0 s: ZeroDivisionError: division by zero, in sense ({file}:{line})",
    ),
    "link, none made": (
        plugin("links", "perfect", "", "lambda setup: None"),
        "link perfect: made None, which has no 'deliveries'",
    ),
    "link that cannot be made": (
        plugin("links", "perfect", LINK, made="1 / 0"),
        "link perfect: ZeroDivisionError: division by zero",
    ),
    "interpreter, no sign": (
        plugin("allocation_interpreters", "mrta_alliance", LISTENER, answer="['x']", wishes=ODOM),
        "interpreter of mrta_alliance: TypeError: a sign is 'x'; accepted is AllocationSign, hearing /robot1/odom",
    ),
    "rule, no wish": (
        plugin("incident_rules", "any", LISTENER, wishes="['x']"),
        "incident rule any: TypeError: a wish is 'x'; accepted is Subscription, subscribing",
    ),
    "rule, no severity": (
        plugin("incident_rules", "any", LISTENER, answer="board.open('key', 'warning', time, 'text')"),
        "incident rule any: TypeError: a severity is 'warning'; accepted is Severity, woken at 1.0",
    ),
    "rule, no time": (
        plugin("incident_rules", "any", LISTENER, answer="board.open('key', Severity.INFO, float('nan'), 'text')"),
        "incident rule any: ValueError: a start of nan s; it must be finite, woken at 1.0",
    ),
    "statistic, no JSON": (
        plugin("statistics", "any", "", "lambda record: {1}"),
        "statistic any: its value is no plain JSON (Object of type set is not JSON serializable); accepted: finite "
        "numbers, texts, truth values, None, and lists and dicts of them",
    ),
    "measure, no JSON": (
        plugin("measures", "any", LISTENER, answer="{1}"),
        "measure any: its value is no plain JSON (Object of type set is not JSON serializable); accepted: finite "
        "numbers, texts, truth values, None, and lists and dicts of them",
    ),
    "measure, none made": (
        plugin("measures", "any", LISTENER, "lambda setup: None"),
        "measure any: made None, which has no 'subscriptions'",
    ),
    "measure, no wish": (
        plugin("measures", "any", LISTENER, wishes="['x']"),
        "measure any: TypeError: wants to hear 'x'; a Subscription is needed",
    ),
    "measure that raises": (
        plugin("measures", "any", LISTENER, answer="1 / 0", wishes=ODOM),
        "measure any: ZeroDivisionError: division by zero",
    ),
    "panel, no view": (
        plugin("monitor_panels", PANEL_NAME, LISTENER),
        f"monitor panel {PANEL_NAME}: gives None; a CurvePanel of CurveGroups of Curves is needed",
    ),
    "panel, no wish": (
        plugin("monitor_panels", PANEL_NAME, LISTENER, wishes="['x']"),
        f"monitor panel {PANEL_NAME}: TypeError: wants to hear 'x'; a Subscription is needed",
    ),
    "renderer, no picture": (
        plugin("renderers", "monitor", "", "lambda view: None"),
        "renderer monitor: drew None; an array of (height, width, 3) uint8 is needed",
    ),
    "renderer, another shape": (
        plugin("renderers", "monitor", "import numpy\n", "lambda view: numpy.zeros((2, 3))"),
        "renderer monitor: drew an array of (2, 3) float64; an array of (height, width, 3) uint8 is needed",
    ),
    "exporter, no files": (
        plugin("exporters", "any", LISTENER),
        "exporter any: answers NoneType; a mapping of bytes by file name is accepted",
    ),
    "exporter, none made": (
        plugin("exporters", "any", LISTENER, "lambda setup: None"),
        "exporter any: made None, which has no 'subscriptions'",
    ),
    "figures, none": (
        plugin("figures", "any", LISTENER),
        "figures any: gives None; a sequence of Figures is needed",
    ),
    "figures, outside of the folder": (
        plugin("figures", "any", LISTENER, answer="[Figure('../any', 'Any', 'x', ())]"),
        "figures any: '../any' is no name of a figure; letters, digits, '_' and '-' are accepted",
    ),
    "figures, two of a name": (
        plugin("figures", "any", LISTENER, answer="[Figure(name, 'Any', 'x', ()) for name in ('one', 'One')]"),
        "figures any: gives two figures of the name 'One'; each needs its own",
    ),
    "figures, no lines": (
        plugin("figures", "any", LISTENER, answer="[Figure('any', 'Any', 'x', (Chart((1,), 'y'),))]"),
        "figures any: figure any: 1 stands among a chart's lines; a Line with a label and a LineStyle is needed",
    ),
    "figures, no numbers": (
        plugin("figures", "any", LISTENER, answer="[Figure('a', 'A', 'x', (Chart((Line('l', 'a', 'b'),), 'y'),))]"),
        "figures any: figure a: line 'l' has values that are no numbers",
    ),
}

WEIGHING_COSTS = (
    *("run", "border_patrol", "--architecture", "nearest_robot"),
    *("--duration", "1", "--pictures", "0", "--processes", "1"),
)
MISFITS_OF_TEAMS_THAT_WEIGH_COSTS = {
    "behaviour, cost is no number": (
        plugin("behaviours", "wander", BEHAVIOUR, answer="True", cost="'much'"),
        "robot1: behaviour 'wander' on task 'wander' failed at 1.000 s: TypeError: cost answered 'much'; accepted is "
        "a float or None",
    ),
    "behaviour, cost is not a number": (
        plugin("behaviours", "wander", BEHAVIOUR, answer="True", cost="float('nan')"),
        "robot1: behaviour 'wander' on task 'wander' failed at 1.000 s: ValueError: cost answered nan; None says that "
        "it cannot tell",
    ),
    "planner, no path": (
        plugin("planners", "astar", PLANNER, answer="3"),
        "robot2: planner astar: path answered 3; a tuple of finite Poses, or None, is needed",
    ),
    "planner, no poses": (
        plugin("planners", "astar", PLANNER, answer="(goal, (1.0, 2.0))"),
        "robot2: planner astar: path answered (Pose(x=4.6, y=2.6, yaw=0.0), (1.0, 2.0)); a tuple of finite Poses, or "
        "None, is needed",
    ),
    "planner that raises": (
        plugin("planners", "astar", PLANNER, answer="1 / 0"),
        "robot2: planner astar: ZeroDivisionError: division by zero",
    ),
    "planner, no cost field": (
        plugin("planners", "astar", PLANNER, field="3"),
        "robot1: planner astar: cost_field answered 3, which has no 'at'",
    ),
    "planner, no length": (
        plugin("planners", "astar", PLANNER, field="Field(-1.0)"),
        "robot1: planner astar: its cost field answered -1.0; a finite length of at least 0 m, or None, is needed",
    ),
    "link, no delays": (
        plugin("links", "perfect", LINK),
        "link Part: answered None for a message from 'robot1' to 'robot2'; delays of at least 0 s are accepted",
    ),
    "allocator, no pairs": (
        plugin("allocators", "nearest_robot/nearest", "", "lambda problem: None"),
        "allocator nearest_robot/nearest: answered None; pairs of a task's and a robot's id of the problem are needed, "
        "each robot once",
    ),
    "allocator, a stranger": (
        plugin("allocators", "nearest_robot/nearest", "", "lambda problem: [('wander', 'nobody')]"),
        "allocator nearest_robot/nearest: answered [('wander', 'nobody')]; pairs of a task's and a robot's id of the "
        "problem are needed, each robot once",
    ),
}


@pytest.mark.parametrize(("text", "message"), list(MISFITS.values()), ids=list(MISFITS))
def test_a_part_that_does_not_fit_stops_the_run_by_name(mrta: Mrta, stranger: Path, text: str, message: str) -> None:
    stranger.write_text(text)
    wishes = ["--export", "any"] if "mrta_register_exporters" in text else []
    wishes += ["--figures", "any"] if "mrta_register_figures" in text else []
    drawn = "mrta_register_monitor_panels" in text or "mrta_register_renderers" in text
    wishes += ["--pictures", "1" if drawn else "0"]

    status, lines = mrta("run", "border_patrol", "--duration", "0.5", "--processes", "1", *wishes)

    line = text.partition("def sense")[0].count("\n") + 2
    assert (status, lines) == (3, [f"mrta: {message.format(file=stranger, line=line)}"])


@pytest.mark.parametrize(
    ("text", "message"),
    list(MISFITS_OF_TEAMS_THAT_WEIGH_COSTS.values()),
    ids=list(MISFITS_OF_TEAMS_THAT_WEIGH_COSTS),
)
def test_a_part_that_does_not_fit_is_told_where_costs_are_weighed(
    mrta: Mrta, stranger: Path, text: str, message: str
) -> None:
    stranger.write_text(text)
    assert mrta(*WEIGHING_COSTS) == (3, [f"mrta: {message}"])


def test_a_part_that_lacks_a_library_ends_the_run_with_the_status_for_that(mrta: Mrta, stranger: Path) -> None:
    """A host of a robot made a failure of its own of it, with status 3."""
    part = "def lost(problem):\n    raise MissingDependencyError('the allocator needs SciPy; install scipy')\n"
    stranger.write_text(plugin("allocators", "nearest_robot/nearest", part, "lost"))

    assert mrta(*WEIGHING_COSTS) == (4, ["mrta: the allocator needs SciPy; install scipy"])


@pytest.mark.parametrize(
    "text",
    [
        plugin("message_observers", "any", "", "lambda setup: None"),
        plugin("message_observers", "any", LISTENER, wishes="['x']"),
        plugin("message_observers", "any", LISTENER, wishes="[Subscription(3)]"),
        plugin("message_observers", "any", LISTENER, answer="1 / 0", wishes=ODOM),
    ],
    ids=["none made", "no wish", "no topic", "raises"],
)
def test_a_message_observer_that_does_not_fit_is_logged_and_the_run_goes_on(
    mrta: Mrta, stranger: Path, caplog: pytest.LogCaptureFixture, text: str
) -> None:
    stranger.write_text(text)

    status, lines = mrta("run", "border_patrol", "--duration", "1", "--pictures", "0", "--processes", "1")

    assert (status, lines) == (0, [])
    assert [message for message in caplog.messages if "observer" in message] == ["event=observer_failed observer=any"]


def test_an_agent_that_takes_for_ever_stops_the_run_at_its_tick(
    mrta: Mrta, stranger: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("RQT_MRTA_PY_PATIENCE", "2")
    stranger.write_text(plugin("agents", "mrta_alliance", AGENT, answer="[None for _ in iter(int, 1)]"))

    status, lines = mrta("run", "border_patrol", "--duration", "1", "--pictures", "0", "--processes", "1")

    assert (status, len(lines)) == (3, 1)
    assert lines[0].startswith("mrta: the mission's tick at 0 s: no answer within 2 s; interrupted in ")
    assert str(stranger) in lines[0]
