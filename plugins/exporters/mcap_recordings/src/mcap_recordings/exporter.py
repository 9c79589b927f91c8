"""A stream as an MCAP file, by MCAP's profile ``ros1``.

Source: MCAP format specification, version 0, with the well-known profile ``ros1``, message encoding ``ros1`` and schema
encoding ``ros1msg`` of its registry (mcap.dev/spec).
"""

from __future__ import annotations

from importlib import import_module
from typing import Any, BinaryIO, Callable, Dict, Tuple

from rqt_mrta_py.hooks import Connection, ExporterSetup, MissingDependencyError, MrtaError, Stamped
from rqt_mrta_py.model import MissionRecord

__all__ = ["FILE", "McapExporter"]

FILE = "mission.mcap"
_LIBRARY = "rqt_mrta_py"
_SEQUENCES = 1 << 32
_CHANNELS = (1 << 16) - 1
"""So wide are sequence numbers, and numbers of channels and schemas, which count from 1."""


class McapExporter:
    """Writes every message with the definition that came with it; bytes and times stay as they are.

    Args:
        setup: not needed.

    Raises:
        MissingDependencyError: the package mcap is not installed, or lacks what it compresses with.
    """

    def __init__(self, setup: ExporterSetup) -> None:
        try:
            import mcap.writer

            # The writer would miss what it compresses with only when it begins.
            import_module("zstandard")
        except ImportError as error:
            raise MissingDependencyError(
                f"exporter mcap: {error}; install it with: pip install 'rqt_mrta_py[mcap]'"
            ) from error
        # Part of its methods has no annotations.
        self._make: Callable[[BinaryIO], Any] = mcap.writer.Writer
        self._writer: Any = None
        self._schemas: Dict[Tuple[str, str], int] = {}
        self._channels: Dict[Connection, int] = {}
        self._sequences: Dict[int, int] = {}

    def begin(self, record: MissionRecord, create: Callable[[str], BinaryIO]) -> None:
        """Begin the file with what is known of the mission as metadata."""
        self._writer = self._make(create(FILE))
        self._writer.start(profile="ros1", library=_LIBRARY)
        known = {
            "application": record.application,
            "architecture": record.architecture,
            "taxonomy": str(record.taxonomy),
            "seed": record.seed,
        }
        told = {key: str(value) for key, value in known.items() if value is not None}
        self._writer.add_metadata(_LIBRARY, told)

    def take(self, stamped: Stamped) -> None:
        """Write the next message."""
        connection, receipt_ns, raw = stamped
        channel = self._channels.get(connection)
        if channel is None:
            channel = self._channels[connection] = self._register(connection)
        sequence = self._sequences.get(channel, 0)
        self._sequences[channel] = (sequence + 1) % _SEQUENCES
        # A bag knows one time of a message, its receipt.
        self._writer.add_message(channel, receipt_ns, raw, receipt_ns, sequence)

    def end(self) -> None:
        """Complete the file."""
        self._writer.finish()

    def _register(self, connection: Connection) -> int:
        """Give a publisher's topic a channel.

        Raises:
            MrtaError: there are more than MCAP has numbers for.
        """
        if len(self._channels) >= _CHANNELS:
            raise MrtaError(
                f"exporter mcap: {connection.topic}: the stream has more than {_CHANNELS} publishers of topics, for "
                "which MCAP has no numbers; export a part of it"
            )
        kind = (connection.type, connection.definition)
        if kind not in self._schemas:
            self._schemas[kind] = self._writer.register_schema(
                connection.type, "ros1msg", connection.definition.encode("utf-8", "replace")
            )
        about = {"md5sum": connection.md5, "latching": "1" if connection.latched else "0"}
        if connection.caller:
            about["callerid"] = connection.caller
        channel: int = self._writer.register_channel(connection.topic, "ros1", self._schemas[kind], about)
        return channel
