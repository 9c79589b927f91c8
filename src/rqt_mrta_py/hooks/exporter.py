"""Exporters: further files of a finished run or review, in other programs' formats."""

from __future__ import annotations

from dataclasses import dataclass
from typing import BinaryIO, Callable, Mapping, Protocol, Sequence, Union

from rqt_mrta_py.hooks.stream import Heard, Stamped, Subscription
from rqt_mrta_py.model import Mission, MissionRecord

__all__ = ["Exporter", "ExporterFactory", "ExporterSetup", "MessageExporter"]


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


class MessageExporter(Protocol):
    """Is handed every message of a finished mission as it was recorded, and writes as it goes.

    Made for formats that hold the messages themselves: they may be larger than memory.
    """

    def begin(self, record: MissionRecord, create: Callable[[str], BinaryIO]) -> None:
        """Begin the files; called once, before the first message.

        Args:
            record: everything known of the mission.
            create: opens a new file for writing by its plain name, in ``export/<name of the exporter>/`` of the output
                folder. Files are closed for the exporter, and there only when all went well.
        """
        ...

    def take(self, stamped: Stamped) -> None:
        """Take the next message: of the bag, or of the supervisor, on topics of which the bag has nothing."""
        ...

    def end(self) -> None:
        """Complete the files; called once, after the last message."""
        ...


ExporterFactory = Callable[[ExporterSetup], Union[Exporter, MessageExporter]]
