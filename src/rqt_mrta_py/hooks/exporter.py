"""Exporters: further files of a finished run or review, in other programs' formats."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Mapping, Protocol, Sequence

from rqt_mrta_py.hooks.stream import Heard, Subscription
from rqt_mrta_py.model import Mission, MissionRecord

__all__ = ["Exporter", "ExporterFactory", "ExporterSetup"]


@dataclass(frozen=True)
class ExporterSetup:
    """What an exporter is made from: the mission as far as it is known."""

    mission: Mission


class Exporter(Protocol):
    """Hears the stream of one mission, and in the end writes it down in one format."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear, if anything; asked once. Names must be absolute or patterns."""
        ...

    def hear(self, heard: Heard) -> None:
        """Take in one message; messages come in the order of the stream."""
        ...

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        """Give the content of each file by its name; asked once, with everything known of the mission.

        Names are plain file names; they are written to ``export/<name of the exporter>/`` in the output folder.
        """
        ...


ExporterFactory = Callable[[ExporterSetup], Exporter]
