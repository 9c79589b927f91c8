"""What a run and a review leave alike: summary, events, incidents, the mission in one picture, the log."""

from __future__ import annotations

import platform
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py import __version__
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.versions import installed_versions
from rqt_mrta_py.hooks import Renderer
from rqt_mrta_py.model import Explanation, MissionRecord, Outcome, TaskState
from rqt_mrta_py.render import write_picture
from rqt_mrta_py.supervisor import event_lines, incident_lines, summary
from rqt_mrta_py.wording import printable

__all__ = ["MissionResult", "Results", "Stopwatch", "write_results"]


@dataclass(frozen=True)
class MissionResult:
    """A finished run or review.

    Attributes:
        folder: where its outputs are.
        record: everything known of the mission.
        summary: as written to ``summary.json``.
        mission_time: what passed on the stream's clock [s].
        wall_time: what passed on the wall [s].
        interrupted: True if the user asked to end; the outputs are complete as far as it went.
        explanations: of the tasks that the user asked about.
    """

    folder: Path
    record: MissionRecord
    summary: Dict[str, Any]
    mission_time: float
    wall_time: float
    interrupted: bool = False
    explanations: Tuple[Explanation, ...] = ()

    def text(self) -> str:
        """Say in a few lines what happened and where the outputs are."""
        record = self.record
        lost = sum(allocation.outcome is Outcome.LOST for allocation in record.allocations)
        ended = sum(task.state in (TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN) for task in record.tasks)
        speed = _speed(self.mission_time, self.wall_time)
        lines = [
            f"{record.application or 'mission'} under {record.architecture or 'unknown architecture'}: "
            f"{self.mission_time:.1f} s in {self.wall_time:.1f} s ({speed:.1f} times real time)"
            f"{', interrupted' if self.interrupted else ''}",
            f"{_counted(record.robots, 'robot')}, {_counted(record.tasks, 'task')} ({ended} ended), "
            f"{_counted(record.allocations, 'allocation')} ({lost} lost), {_counted(record.incidents, 'incident')}",
        ]
        start = record.start or 0.0
        lines += [
            f"{incident.start - start:8.1f} s  {incident.severity.value}: {printable(incident.text)}"
            for incident in record.incidents
        ]
        lines.append(f"outputs: {self.folder}")
        return "\n".join(lines)


class Results(NamedTuple):
    """What is known of a stream that has ended.

    Attributes:
        record: everything known of the mission.
        summary: as written to ``summary.json``.
    """

    record: MissionRecord
    summary: Dict[str, Any]


def write_results(folder: OutputFolder, observation: Observation, dashboard: Optional[Renderer]) -> Results:
    """Sum up a stream that has ended and write what is derived from it.

    Args:
        folder: where to.
        observation: has heard the whole stream.
        dashboard: draws the mission in one picture; None for no pictures.
    """
    record = observation.finish()
    summed_up = summary(record)
    folder.write_json("summary.json", summed_up)
    folder.write_lines("events.jsonl", event_lines(record.events))
    folder.write_lines("incidents.jsonl", incident_lines(record))
    if dashboard is not None and record.start is not None:
        write_picture(folder.path / "dashboard.png", dashboard(observation.dashboard_view(record)))
    return Results(record, summed_up)


def _speed(mission_time: float, wall_time: float) -> float:
    return mission_time / wall_time if wall_time > 0 else 0.0


def _counted(things: Sequence[object], name: str) -> str:
    return f"{len(things)} {name}{'' if len(things) == 1 else 's'}"


class Stopwatch:
    """Measures one execution on the wall clock; what it measures goes to ``run.log`` and the terminal only."""

    def __init__(self) -> None:
        self._started = time.strftime("%Y-%m-%dT%H:%M:%S%z")
        self._began = time.monotonic()

    def result(self, folder: OutputFolder, results: Results, interrupt: Interrupt, processes: int = 1) -> MissionResult:
        """Stop, write ``run.log`` and give the result.

        Args:
            folder: where the outputs are.
            results: of the stream.
            interrupt: knows by now whether the user asked to end.
            processes: that shared the work.
        """
        record, summed_up = results
        mission_time = (record.end or 0.0) - (record.start or 0.0)
        wall_time = time.monotonic() - self._began
        lines = [
            f"rqt_mrta_py {__version__}",
            f"started {self._started}",
            f"mission_seconds {mission_time:.3f}",
            f"wall_seconds {wall_time:.3f}",
            f"mission_seconds_per_wall_second {_speed(mission_time, wall_time):.2f}",
            f"processes {processes}",
            f"python {platform.python_version()}",
        ]
        lines += [f"{name} {version}" for name, version in installed_versions().items()]
        folder.write_text("run.log", "\n".join(lines) + "\n")
        return MissionResult(folder.path, record, summed_up, mission_time, wall_time, interrupt.requested)
