"""Missions watched by one rule, or by all of the house."""

from __future__ import annotations

import dataclasses
from typing import Any, Optional, Tuple

from rqt_mrta_py.hooks import AllocationPace
from rqt_mrta_py.model import Incident, Mission, Task, Taxonomy
from rqt_mrta_py.supervisor.plugin import mrta_register_incident_rules
from tests.supervisor.mini import Signs, Stream, mission

PACE = AllocationPace(handover=3.0, uptake=10.0, brief=5.0)
"""Short and round, so that times in tests can be worked out in the head."""


def watched(rule: str, of: Optional[Mission] = None, pace: AllocationPace = PACE) -> Stream:
    """Make a stream that one rule of the house watches."""
    return Stream(of, interpreter=Signs(), rules={rule: mrta_register_incident_rules()[rule]}, pace=pace)


def under(taxonomy: str, of: Optional[Mission] = None) -> Mission:
    """Change a mission's taxonomy."""
    of = of or mission()
    return dataclasses.replace(of, architecture=dataclasses.replace(of.architecture, taxonomy=Taxonomy.parse(taxonomy)))


def with_task(task_id: str, of: Optional[Mission] = None, **changes: Any) -> Mission:
    """Change what is listed of one task."""
    of = of or mission()

    def changed(task: Task) -> Task:
        return dataclasses.replace(task, **changes) if task.id == task_id else task

    return dataclasses.replace(of, tasks=tuple(changed(task) for task in of.tasks))


def incidents(stream: Stream) -> Tuple[Incident, ...]:
    """End a stream and list what was found."""
    return stream.finish().incidents


def spans(stream: Stream) -> Tuple[Tuple[float, float], ...]:
    """End a stream and list when what was found began and ended [s]."""
    return tuple((each.start, each.end) for each in incidents(stream))
