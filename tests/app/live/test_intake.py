"""Messages taken in together: what follows is what follows one by one."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Dict, List, Tuple

from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.live.intake import Intake
from rqt_mrta_py.app.live.stream_clock import StreamClock
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.model import Mission

ROBOTS = ("robot1", "robot2")
TASKS = ("wander", "report")

# What one robot says: a sensor's message, a motivation (active or not), an announcement, how a task goes.
words = st.tuples(
    st.sampled_from(("odom", "idle", "active", "announce", "running", "done", "appeared")),
    st.sampled_from(ROBOTS),
    st.sampled_from(TASKS),
)
# Timeouts are 2 s: pauses reach beyond them.
streams = st.lists(st.tuples(st.sampled_from((0, 1, 50, 400, 1_900, 2_000, 2_600)), words), min_size=1, max_size=40)


@lru_cache(maxsize=1)
def stage() -> Tuple[Host, Mission]:
    host = compose()
    return host, load_mission(host.registry, "border_patrol", seed=None)


@lru_cache(maxsize=None)
def message(kind: str, robot: str, task: str) -> Tuple[Connection, bytes]:
    """Make a connection, the same object for the same words, and bytes."""
    codec = stage()[0].codec()
    if kind == "odom":
        topic, type_name, fields = f"/{robot}/odom", "nav_msgs/Odometry", {}
    elif kind in ("idle", "active"):
        topic, type_name = f"/{robot}/alliance/motivation/{task}", "alliance_msgs/Motivation"
        fields = {"header": {"frame_id": f"/{robot}"}, "task_id": task, "active": kind == "active"}
    elif kind == "announce":
        topic, type_name = "/alliance/inter_robot_communication", "alliance_msgs/InterRobotCommunication"
        fields = {"header": {"frame_id": f"/{robot}"}, "task_id": task}
    else:
        topic, type_name = "/mrta/task_progress", "rqt_mrta_py/TaskProgress"
        code: Dict[str, Any] = {"running": 0, "done": 1, "appeared": 4}
        fields = {"robot_id": robot, "task_id": task, "progress": code[kind]}
    connection = codec.connection(topic, type_name, f"/{robot}/agent")
    return _same(connection), codec.encode(type_name, fields)


@lru_cache(maxsize=None)
def _same(connection: Connection) -> Connection:
    return connection


def stream_of(drawn: List[Tuple[int, Tuple[str, str, str]]]) -> List[Stamped]:
    at, stream = 1_000_000_000, []
    for pause, said in drawn:
        at += pause * 1_000_000
        connection, raw = message(*said)
        stream.append(Stamped(connection, at, raw))
    return stream


def observation() -> Observation:
    host, mission = stage()
    return Observation(mission, host.codec(), host.manager, None, panels=False, measures=False)


@settings(max_examples=40, deadline=None)
@given(streams, st.lists(st.booleans(), min_size=40, max_size=40))
def test_what_follows_is_the_same_one_by_one_and_together(
    drawn: List[Tuple[int, Tuple[str, str, str]]], looks: List[bool]
) -> None:
    stream = stream_of(drawn)
    single = observation()
    for stamped in stream:
        single.feed(stamped)
    together = observation()
    now = [0.0]
    kept: List[Stamped] = []
    intake = Intake("/supervisor", StreamClock(lambda: now[0]), together, (kept.extend,), lambda: None)
    for stamped, look in zip(stream, looks):
        now[0] = stamped.receipt_ns / 1e9
        intake.hear(stamped)
        if look:
            # As the thread does that looks at the clock.
            intake.catch_up()
            together.supervisor.let_pass(now[0])
    intake.catch_up()
    assert kept == stream
    assert together.finish() == single.finish()
