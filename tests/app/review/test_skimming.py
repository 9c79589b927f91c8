"""Taking in only what may change something gives what taking in each message gives."""

from __future__ import annotations

import dataclasses
import random
from typing import Any, Dict, Iterator, List, Tuple

import pytest

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.review.recordings import Recordings
from rqt_mrta_py.app.review.skimming import Skimming
from rqt_mrta_py.app.review.subject import subject_of
from rqt_mrta_py.hooks import Codec, Stamped
from rqt_mrta_py.model import Mission, Progress
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

    def __init__(self, seed: int, codec: Codec) -> None:
        self._chance = random.Random(seed)
        self._codec = codec
        self._mode: Dict[str, str] = dict.fromkeys(ROBOTS, "idle")
        self._task: Dict[str, str] = dict.fromkeys(ROBOTS, TASKS[0])
        self._lead: Dict[str, float] = dict.fromkeys(ROBOTS, 0.0)
        self._now = 0

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
        for task in TASKS if mode != "mute" else ():
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


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("architecture", ["mrta_mini", "mrta_alliance"])
def test_skimming_a_restless_team_changes_nothing(host: Host, seed: int, architecture: str) -> None:
    """The second architecture has an interpreter, which is told of fewer messages too."""
    about = mission(ROBOTS, TASKS)
    about = dataclasses.replace(about, architecture=dataclasses.replace(about.architecture, package=architecture))
    messages = list(Scene(seed, host.codec()).messages(400))
    chance = random.Random(seed)
    connections = ConnectionList()
    blocks: List[Block] = []
    place = 0
    while place < len(messages):
        upto = place + chance.choice((1, 7, 500, 3000))
        blocks.append(Block.of(connections, messages[place:upto]))
        place = upto
    expected, events = one_by_one(about, host, messages)
    assert events > 10
    assert skimmed(about, host, blocks) == expected


def test_skimming_the_bag_of_a_run_changes_nothing(host: Host, patrol: Outputs) -> None:
    recordings = Recordings([patrol.bag])
    about = subject_of(host, recordings, None, None, host.codec()).mission
    expected, events = one_by_one(about, host, list(recordings.messages(Excerpt())))
    assert events > 10
    assert skimmed(about, host, list(recordings.blocks(Excerpt()))) == expected
