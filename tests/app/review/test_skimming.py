"""Taking in only what may change something gives what taking in each message gives."""

from __future__ import annotations

import dataclasses
import random
from typing import Any, Dict, Iterator, List, Sequence, Tuple

import pytest

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.review.recordings import Recordings
from rqt_mrta_py.app.review.skimming import Skimming
from rqt_mrta_py.app.review.subject import subject_of
from rqt_mrta_py.hooks import AllocationSign, Codec, Fact, Heard, IncidentBoard, Stamped, Subscription
from rqt_mrta_py.model import Mission, Progress, Severity
from rqt_mrta_py.supervisor import event_lines, incident_lines, summary
from rqt_mrta_py.transport import Block, ConnectionList, Excerpt
from tests.app.outputs import Outputs
from tests.supervisor.mini import mission

NS = 10**9
ROBOTS, TASKS = ("robot1", "robot2", "robot3"), ("patrol", "inspect", "report")


@pytest.fixture(scope="module")
def host() -> Host:
    return compose()


class Scene:
    """Three robots that change their minds, fall silent, set their clocks wrongly, and one that nobody knows."""

    def __init__(self, seed: int, codec: Codec, *, idle_only: bool = False) -> None:
        self._chance = random.Random(seed)
        self._codec = codec
        self._mode: Dict[str, str] = dict.fromkeys(ROBOTS, "idle")
        self._task: Dict[str, str] = dict.fromkeys(ROBOTS, TASKS[0])
        self._lead: Dict[str, float] = dict.fromkeys(ROBOTS, 0.0)
        self._now = 0
        # Whether a robot says that it is idle only while it is, as those of other architectures do.
        self._idle_only = idle_only

    def messages(self, ticks: int) -> Iterator[Stamped]:
        for tick in range(ticks):
            self._now = 100 * NS + tick * NS // 10
            for robot in ROBOTS:
                self._change(robot)
                yield from self._says(robot, tick)
            if self._chance.random() < 0.01:
                yield self._announcement("stranger", self._chance.choice((*TASKS, "nonsense")))
            if self._chance.random() < 0.01:
                yield self._progress()

    def _change(self, robot: str) -> None:
        draw = self._chance.random()
        if draw < 0.01:
            self._mode[robot] = self._chance.choice(("idle", "busy", "busy", "silent", "mute"))
            self._task[robot] = self._chance.choice(TASKS)
        elif draw < 0.013:
            self._lead[robot] = self._chance.choice((0.0, 0.0, 5.0, -5.0, 0.9))

    def _says(self, robot: str, tick: int) -> Iterator[Stamped]:
        mode = self._mode[robot]
        if mode == "silent":
            return
        yield self._stamped(f"/{robot}/odom", "std_msgs/Empty", {}, f"/{robot}/base")
        for task in TASKS if mode == "idle" or (mode == "busy" and not self._idle_only) else ():
            active = mode == "busy" and task == self._task[robot]
            fields = {"header": self._header(robot), "task_id": task, "motivation": float(tick), "active": active}
            topic = f"/{robot}/alliance/motivation/{task}"
            yield self._stamped(topic, "alliance_msgs/Motivation", fields, f"/{robot}/alliance")
        if mode == "busy" and tick % 5 == 0:
            yield self._announcement(robot, self._task[robot])

    def _announcement(self, robot: str, task: str) -> Stamped:
        fields = {"header": self._header(robot), "task_id": task}
        topic = "/alliance/inter_robot_communication"
        # As some recorders write it: all of them under one name.
        return self._stamped(topic, "alliance_msgs/InterRobotCommunication", fields, "/recorder")

    def _progress(self) -> Stamped:
        code = list(Progress).index(self._chance.choice(list(Progress)))
        fields = {
            "task_id": self._chance.choice(TASKS),
            "robot_id": self._chance.choice(ROBOTS),
            "progress": code,
            "detail": "by chance",
        }
        return self._stamped("/mrta/task_progress", "rqt_mrta_py/TaskProgress", fields, "/simulation")

    def _header(self, robot: str) -> Dict[str, Any]:
        return {"stamp": self._now / NS + self._lead.get(robot, 0.0), "frame_id": f"/{robot}"}

    def _stamped(self, topic: str, type_name: str, fields: Dict[str, Any], caller: str) -> Stamped:
        self._now += self._chance.choice((0, 1_000_000, 3_000_000))
        return Stamped(
            self._codec.connection(topic, type_name, caller), self._now, self._codec.encode(type_name, fields)
        )


def outcome(observation: Observation) -> List[object]:
    record = observation.finish()
    return [summary(record), list(event_lines(record.events)), list(incident_lines(record))]


def one_by_one(about: Mission, host: Host, messages: List[Stamped]) -> Tuple[List[object], int]:
    observation = Observation(about, host.codec(), host.manager, None, panels=False)
    for stamped in messages:
        observation.feed(stamped)
    found = outcome(observation)
    return found, len(found[1])  # type: ignore[arg-type]


def skimmed(about: Mission, host: Host, blocks: List[Block]) -> List[object]:
    observation = Observation(about, host.codec(), host.manager, None, panels=False)
    skimming = Skimming(observation)
    for block in blocks:
        skimming.feed(block)
    return outcome(observation)


def cut(messages: List[Stamped], seed: int) -> List[Block]:
    chance = random.Random(seed)
    connections = ConnectionList()
    blocks: List[Block] = []
    place = 0
    while place < len(messages):
        upto = place + chance.choice((1, 7, 500, 3000))
        blocks.append(Block.of(connections, messages[place:upto]))
        place = upto
    return blocks


def about_three(architecture: str, robots: Sequence[str] = ROBOTS, tasks: Sequence[str] = TASKS) -> Mission:
    about = mission(robots, tasks)
    return dataclasses.replace(about, architecture=dataclasses.replace(about.architecture, package=architecture))


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("idle_only", [False, True])
@pytest.mark.parametrize("architecture", ["mrta_mini", "mrta_alliance"])
def test_skimming_a_restless_team_changes_nothing(host: Host, seed: int, architecture: str, idle_only: bool) -> None:
    """The second architecture has an interpreter, which is told of fewer messages too."""
    messages = list(Scene(seed, host.codec(), idle_only=idle_only).messages(400))
    about = about_three(architecture)
    expected, events = one_by_one(about, host, messages)
    assert events > 10
    assert skimmed(about, host, cut(messages, seed)) == expected


@pytest.mark.parametrize("seed", range(3))
def test_skimming_a_team_that_nobody_listed_changes_nothing(host: Host, seed: int) -> None:
    messages = list(Scene(seed, host.codec()).messages(400))
    about = about_three("mrta_alliance", (), ())
    expected, events = one_by_one(about, host, messages)
    assert events > 10
    assert skimmed(about, host, cut(messages, seed)) == expected


@pytest.mark.parametrize("seed", [4, 1022])
def test_skimming_a_team_with_a_stranger_changes_nothing(host: Host, seed: int) -> None:
    """Robot3 is none of the mission's. With the second seed robot1 quickens on its topic before it falls silent."""
    messages = list(Scene(seed, host.codec(), idle_only=True).messages(422))
    about = about_three("mrta_mini", ROBOTS[:2], TASKS[:2])
    expected, events = one_by_one(about, host, messages)
    assert events > 10
    assert skimmed(about, host, cut(messages, seed)) == expected


class Remembering:
    """An interpreter that says nothing, and remembers when robots announced what."""

    repeats_matter = False
    last_matters = (Subscription("/alliance/inter_robot_communication", "", ("task_id",)),)

    def __init__(self) -> None:
        self.heard: List[Tuple[str, float]] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return (*self.last_matters, Subscription("/@robot_id@/alliance/motivation/@task_id@", "", ("active",)))

    def hear(self, heard: Heard) -> Sequence[AllocationSign]:
        self.heard.append((heard.topic.rsplit("/", 1)[-1], heard.receipt))
        return ()


def test_an_interpreter_is_told_again_of_the_last_message_of_what_it_lists(
    host: Host, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Robot1 is on patrol and says so from 100 s on, ten times a second, until it goes over to inspect at 102 s."""
    interpreter = Remembering()
    registered = host.manager.registered
    found = {"mrta_register_allocation_interpreters": {"mrta_mini": lambda setup: interpreter}}
    monkeypatch.setattr(host.manager, "registered", lambda hook: found.get(hook) or registered(hook))
    codec, messages = host.codec(), []
    for tick in range(21):
        receipt_ns = 100 * NS + tick * NS // 10
        header = {"stamp": receipt_ns / NS, "frame_id": "/robot1"}
        for topic, kind, fields in (
            ("/robot1/alliance/motivation/patrol", "Motivation", {"task_id": "patrol", "active": True}),
            (
                "/alliance/inter_robot_communication",
                "InterRobotCommunication",
                {"task_id": "inspect" if tick == 20 else "patrol"},
            ),
        ):
            raw = codec.encode(f"alliance_msgs/{kind}", {"header": header, **fields})
            messages.append(Stamped(codec.connection(topic, f"alliance_msgs/{kind}"), receipt_ns, raw))
    observation = Observation(about_three("mrta_mini"), codec, host.manager, None, panels=False)
    skimming, connections = Skimming(observation), ConnectionList()
    # By the end of the first block it is known that robot1 says both while it is busy.
    for part in (messages[:16], messages[16:]):
        skimming.feed(Block.of(connections, part))
    told = {topic: [receipt for kind, receipt in interpreter.heard if kind == topic] for topic, _ in interpreter.heard}
    assert told["patrol"][0] == 100.0
    assert 101.9 not in told["patrol"]
    assert told["inter_robot_communication"][-2:] == [101.9, 102.0]
    assert len(told["inter_robot_communication"]) < 12


class Ear:
    """Hears everything that robots say of their motivations."""

    def __init__(self) -> None:
        self.heard: List[Heard] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return (Subscription("/@robot_id@/alliance/motivation/@task_id@", "", ("motivation", "header/stamp")),)

    def hear(self, heard: Heard) -> None:
        self.heard.append(heard)


def test_who_wants_to_hear_each_message_hears_each(host: Host) -> None:
    messages = list(Scene(1, host.codec()).messages(400))
    about = about_three("mrta_alliance")
    one, other = Ear(), Ear()
    observation = Observation(about, host.codec(), host.manager, None, (one,), panels=False)
    for stamped in messages:
        observation.feed(stamped)
    skimming = Skimming(Observation(about, host.codec(), host.manager, None, (other,), panels=False))
    for block in cut(messages, 1):
        skimming.feed(block)
    assert other.heard == one.heard


class Restless:
    """An incident rule that hears each motivation, and looks again a little later."""

    causes = "Nothing."

    def subscriptions(self) -> Sequence[Subscription]:
        return (Subscription("/robot2/alliance/motivation/@task_id@", "", ("motivation",)),)

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        if heard.ordinal % 16 == 5:
            board.wake_at(heard.receipt + 0.33)

    def wake(self, time: float, board: IncidentBoard) -> None:
        board.open(f"{time}", Severity.INFO, time, f"looked at {time}")

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        pass

    def finish(self, time: float, board: IncidentBoard) -> None:
        pass


@pytest.mark.parametrize("seed", range(3))
def test_a_rule_that_hears_each_message_is_woken_in_time(
    host: Host, seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    registered = host.manager.registered

    def with_rule(hook: str) -> Dict[str, Any]:
        found = registered(hook)
        return {**found, "restless": lambda setup: Restless()} if hook == "mrta_register_incident_rules" else found

    monkeypatch.setattr(host.manager, "registered", with_rule)
    messages = list(Scene(seed, host.codec()).messages(400))
    about = about_three("mrta_alliance")
    expected, events = one_by_one(about, host, messages)
    assert events > 50
    assert skimmed(about, host, cut(messages, seed)) == expected


def test_skimming_the_bag_of_a_run_changes_nothing(host: Host, patrol: Outputs) -> None:
    recordings = Recordings([patrol.bag])
    about = subject_of(host, recordings, None, None, host.codec()).mission
    expected, events = one_by_one(about, host, list(recordings.messages(Excerpt())))
    assert events > 10
    assert skimmed(about, host, list(recordings.blocks(Excerpt()))) == expected
