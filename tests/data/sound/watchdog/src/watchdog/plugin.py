"""Notes that something happened."""

from __future__ import annotations

from typing import List

from rqt_mrta_py.hooks import hookimpl
from rqt_mrta_py.model import Event

heard: List[Event] = []


@hookimpl
def mrta_on_event(event: Event) -> None:
    """Keep an event."""
    heard.append(event)
