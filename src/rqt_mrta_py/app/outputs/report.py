"""The page of a finished mission: what its report is made from, and the file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, Mapping, Optional, Tuple

from rqt_mrta_py import __version__
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.versions import installed_versions
from rqt_mrta_py.model import CommunicationGraph, Explanation, Mission, MissionRecord
from rqt_mrta_py.model.timing import TimingTable
from rqt_mrta_py.render.report import BagFile, Provenance, ReportInput, report_html
from rqt_mrta_py.transport.patterns import TopicPattern

__all__ = ["REPORT", "ReportSource", "bag_file", "write_report"]

REPORT = "report.html"


@dataclass(frozen=True)
class ReportSource:
    """What a report tells besides what is derived from the stream.

    Attributes:
        made_by: what was done, for instance ``run`` or ``review``.
        bags: that were recorded or read.
        communication: nodes and topics; None if unknown.
        clocks: what messages tell of time; None where nobody measured.
        explanations: of the tasks that somebody asked about.
    """

    made_by: str
    bags: Tuple[BagFile, ...] = ()
    communication: Optional[CommunicationGraph] = None
    clocks: Optional[TimingTable] = None
    explanations: Tuple[Explanation, ...] = ()


def bag_file(path: Path, messages: int) -> BagFile:
    """Say what bag a report is about.

    Args:
        path: of a bag; of one that is not there the size is 0.
        messages: how many it holds.
    """
    return BagFile(path.name, path.stat().st_size if path.exists() else 0, messages)


def write_report(folder: OutputFolder, observation: Observation, record: MissionRecord, source: ReportSource) -> None:
    """Write ``report.html``.

    Args:
        folder: where to.
        observation: has heard the whole stream.
        record: everything known of the mission.
        source: what else is told.
    """
    mission = observation.mission
    scene = observation.scene
    given = ReportInput(
        view=observation.report_view(record),
        provenance=Provenance(
            source.made_by,
            source.bags,
            {"rqt_mrta_py": __version__, **_installed()},
            mission.parameters,
        ),
        tracks=scene.tracks(),
        bodies=scene.body_tracks(),
        tasks=scene.every_task(),
        communication=source.communication,
        clocks=source.clocks,
        explanations=source.explanations,
        figures=_figures(mission, record, source.communication),
    )
    folder.write_text(REPORT, report_html(given))


def _installed() -> Mapping[str, str]:
    return {name: version for name, version in installed_versions().items() if version != "missing"}


def _figures(mission: Mission, record: MissionRecord, graph: Optional[CommunicationGraph]) -> Dict[str, Any]:
    """Say how many messages the sharing out of tasks took: those on the topics that the architecture declares."""
    told = mission.architecture
    declared_topics = (
        *told.busy_robots,
        *told.idle_robots,
        *told.incoming_tasks,
        *told.allocated_tasks,
        *told.completed_tasks,
        *told.failed_tasks,
    )
    patterns = [TopicPattern(name) for name in dict.fromkeys(topic.name for topic in declared_topics)]
    if graph is None or not patterns or not record.allocations:
        return {}
    declared = [topic for topic in graph.topics if any(pattern.match(topic.name) is not None for pattern in patterns)]
    messages = sum(topic.messages for topic in declared)
    return {"messages_per_allocation": messages / len(record.allocations)}
