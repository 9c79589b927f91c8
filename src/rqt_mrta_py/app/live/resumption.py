"""What a supervisor that goes on after a crash cannot hear again: which tasks have ended is said only once.

It stands in the bag that was left. It is said anew, as an operator would, so that it is in the new bag too and robots
that were started anew hear it.
"""

from __future__ import annotations

import logging
import threading
import time
from pathlib import Path
from typing import Dict, List, Optional, Tuple

from rqt_mrta_py.app.live.live_supervisor import LiveSupervisor
from rqt_mrta_py.app.mission_message import MISSION_TOPIC
from rqt_mrta_py.app.mission_source import told_mission
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.hooks import Codec, Stamped, task_order
from rqt_mrta_py.model import Mission, Progress, TaskState
from rqt_mrta_py.supervisor import standing_of
from rqt_mrta_py.supervisor.own_topics import TASK_STATE, TEAM_STATE
from rqt_mrta_py.supervisor.standing import TASK_STATES
from rqt_mrta_py.supervisor.tasks import FINAL
from rqt_mrta_py.transport import ChunkWalk

__all__ = ["ended_tasks", "left_behind", "resume"]

_log = logging.getLogger("rqt_mrta_py.app")

_RECENT = 60.0
"""After a longer break a mission counts as another one [s]."""
_LOOK = 0.1
"""How often it is looked whether the clock runs [s]."""


def resume(supervisor: LiveSupervisor) -> None:
    """Say again what was known when the recording before this one broke off; in a thread of its own.

    Args:
        supervisor: that has begun; where it does not record, or nothing broke off, nothing is done.
    """
    bag = supervisor.recorded_path
    active = None if bag is None else left_behind(bag)
    if active is not None:
        threading.Thread(target=_resume, args=(supervisor, active), name="resuming", daemon=True).start()


def left_behind(bag: Path) -> Optional[Path]:
    """Give what an earlier recording left that broke off right before a bag of the same name; None if none did.

    Args:
        bag: as ``free_bag`` chose it.
    """
    stem, _, number = bag.stem.rpartition("-")
    if not (stem and number.isdigit()):
        return None
    before = f"{stem}-{int(number) - 1}" if int(number) > 2 else stem
    active = bag.with_name(f"{before}.bag.active")
    return active if active.exists() else None


def ended_tasks(active: Path, codec: Codec, mission: Mission) -> Tuple[float, List[Tuple[str, TaskState]]]:
    """Read which tasks had ended.

    Args:
        active: what the recording left.
        codec: reads it.
        mission: if the bag is of another one, nothing had.

    Returns:
        When its last message was received [s], and ids of tasks with their states.

    Raises:
        MrtaError: it cannot be read.
    """
    last: Optional[Stamped] = None
    said: Optional[Stamped] = None
    states: Dict[str, TaskState] = {}
    for stamped in ChunkWalk(active):
        last = stamped
        connection = stamped.connection
        if connection.topic == MISSION_TOPIC:
            said = stamped
        elif connection.topic == TEAM_STATE.name and connection.type == TEAM_STATE.type:
            states = dict(standing_of(codec.decode(connection, stamped.raw)).tasks)
        elif connection.topic == TASK_STATE.name and connection.type == TASK_STATE.type:
            fields = codec.decode(connection, stamped.raw)
            states[fields["task_id"]] = TASK_STATES.get(fields["state"], TaskState.WAITING)
    if last is None or said is None or _identity(told_mission(said, codec, str(active))[0]) != _identity(mission):
        return 0.0, []
    return last.receipt_ns / 1e9, [(task, state) for task, state in states.items() if state in FINAL]


def _identity(mission: Mission) -> Tuple[object, ...]:
    application = mission.application
    robots = tuple(robot.id for robot in application.robots)
    return application.package, mission.architecture.package, robots, mission.task_ids


def _resume(supervisor: LiveSupervisor, active: Path) -> None:
    node = supervisor.node
    try:
        broke_off, ended = ended_tasks(active, node.codec, supervisor.mission)
    except MrtaError as error:
        _log.warning("recording=%s cannot be resumed: %s", active, error)
        return
    while ended and not node.now() and not node.is_shut_down:
        time.sleep(_LOOK)
    with node.lock:
        if not ended or node.is_shut_down or not broke_off <= supervisor.now <= broke_off + _RECENT:
            return
        known = {task.id: task.state for task in supervisor.record().tasks}
        again = [(task, end) for task, end in ended if known.get(task) not in FINAL]
        for task, end in again:
            detail = "as was known before the supervisor was started anew"
            supervisor.say(task_order(Progress(end.value), task, supervisor.now, detail=detail))
        _log.info("resumed=%s ended_tasks=%d", active, len(again))
