"""The hooks: one journal observes all that a command does."""

from __future__ import annotations

from typing import Mapping

from mission_journal.journal import Journal
from rqt_mrta_py.hooks import MessageObserverFactory, hookimpl
from rqt_mrta_py.model import Event, Mission, MissionRecord

__all__ = [
    "mrta_on_event",
    "mrta_on_mission_end",
    "mrta_on_mission_start",
    "mrta_register_message_observers",
]

_JOURNAL = Journal()


@hookimpl
def mrta_on_mission_start(mission: Mission) -> None:
    """Begin a page."""
    _JOURNAL.begin(mission)


@hookimpl
def mrta_on_event(event: Event) -> None:
    """Write an event down."""
    _JOURNAL.note(event)


@hookimpl
def mrta_on_mission_end(record: MissionRecord) -> None:
    """Close the page."""
    _JOURNAL.end(record)


@hookimpl
def mrta_register_message_observers() -> Mapping[str, MessageObserverFactory]:
    """Let the journal hear what nodes warn of."""
    return {"mission_journal": lambda setup: _JOURNAL}
