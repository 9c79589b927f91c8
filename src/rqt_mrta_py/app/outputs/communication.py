"""Nodes and topics of a recorded mission: for programs, and in one picture."""

from __future__ import annotations

from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.model import MissionRecord
from rqt_mrta_py.render import draw_communication, write_picture
from rqt_mrta_py.supervisor import communication, recorded_communication
from rqt_mrta_py.transport import Spans

__all__ = ["write_communication"]


def write_communication(folder: OutputFolder, spans: Spans, record: MissionRecord, picture: bool) -> None:
    """Write what nodes say on which topics.

    Args:
        folder: where to.
        spans: what has been heard of whom.
        record: of the mission, which knows the robots.
        picture: whether to draw it too.
    """
    graph = recorded_communication(spans)
    folder.write_json("communication.json", communication(graph))
    if picture and graph.flows:
        robots = tuple(robot.id for robot in record.robots)
        write_picture(folder.path / "communication.png", draw_communication(graph, robots))
