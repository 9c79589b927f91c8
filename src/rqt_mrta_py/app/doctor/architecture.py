"""Whether an architecture's taxonomy is understood, and whether somebody draws its panels."""

from __future__ import annotations

from typing import Iterator, Sequence, Tuple

from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.xml.element import Element
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.model import AllocationType, RobotType, TaskType
from rqt_mrta_py.wording import accepted, nearest, shown

__all__ = ["check_panels", "check_taxonomy"]

_AXES: Tuple[Tuple[str, Sequence[str]], ...] = (
    ("robots", RobotType.spellings()),
    ("tasks", TaskType.spellings()),
    ("allocations", AllocationType.spellings()),
)


def check_taxonomy(subject: Subject) -> Iterator[Problem]:
    """Find types that nobody understands; an axis left out is unknown, which is no mistake."""
    for file in subject.architectures:
        problems = Problems(str(file.path))
        architecture = Element(subject.root(file.path), "", problems).child("architecture") if file.spec else None
        for name, spellings in _AXES:
            part = architecture.child(name) if architecture is not None else None
            written = part.text("type") if part is not None else None
            if part is None or written is None or written.value in spellings:
                continue
            # Of each type there are seven spellings; the short ones say enough.
            known = spellings if nearest(written.value, spellings) else [text for text in spellings if _is_short(text)]
            part.problem(
                "type",
                f"is not understood (got {shown(written.value)}); {accepted(written.value, known)}",
                written.line,
            )
        yield from problems.found


def check_panels(subject: Subject) -> Iterator[Problem]:
    """Find widgets in whose place no plugin draws a panel."""
    for file in subject.architectures:
        problems = Problems(str(file.path))
        holder = Element(subject.root(file.path), "", problems).child("widgets") if file.spec else None
        panels = sorted(subject.host.manager.registered("mrta_register_monitor_panels"))
        for _, _, widget in holder.numbered(["widget"]) if holder is not None else ():
            written = widget.text("plugin_name")
            if written is not None and written.value not in panels:
                message = f"no plugin registers the panel {shown(written.value)}; {accepted(written.value, panels)}"
                widget.problem("plugin_name", message, written.line)
        yield from problems.found


def _is_short(spelling: str) -> bool:
    return len(spelling) == 2 and spelling.isupper()
