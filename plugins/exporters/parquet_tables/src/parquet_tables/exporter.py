"""The tables of one mission as Parquet files."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Sequence

from csv_tables.poses import POSES, PoseTrack

from parquet_tables.tables import Kind, Table, mission_tables, pose_table
from rqt_mrta_py.hooks import ExporterSetup, Heard, MissingDependencyError, Subscription
from rqt_mrta_py.model import MissionRecord

__all__ = ["ParquetExporter"]


class ParquetExporter:
    """Writes robots, tasks, allocations, incidents, events and poses as a file each.

    Every file carries application, architecture, taxonomy, seed, and the stream's time of its second 0.

    Args:
        setup: not needed.

    Raises:
        MissingDependencyError: the package pyarrow is not installed.
    """

    def __init__(self, setup: ExporterSetup) -> None:
        try:
            import pyarrow
            import pyarrow.parquet
        except ImportError as error:
            raise MissingDependencyError(
                f"exporter parquet: {error}; install it with: pip install 'rqt_mrta_py[parquet]'"
            ) from error
        self._arrow: Any = pyarrow
        self._poses = PoseTrack()
        evidence = {"topic": pyarrow.string(), "time_s": pyarrow.float64(), "index": pyarrow.int64()}
        self._types: Mapping[Kind, Any] = {
            Kind.TEXT: pyarrow.string(),
            Kind.NUMBER: pyarrow.float64(),
            Kind.TEXTS: pyarrow.list_(pyarrow.string()),
            Kind.EVIDENCE: pyarrow.list_(pyarrow.struct(list(evidence.items()))),
        }

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: the robots' poses."""
        return (POSES,)

    def hear(self, heard: Heard) -> None:
        """Take in one pose."""
        self._poses.hear(heard)

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        """Give the files by name."""
        start = record.start or 0.0
        tables: Dict[str, Table] = {**mission_tables(record), "poses": pose_table(self._poses, start)}
        known = {
            "application": record.application,
            "architecture": record.architecture,
            "taxonomy": str(record.taxonomy),
            "seed": record.seed,
            "start_s": record.start,
        }
        told = {key: str(value) for key, value in known.items() if value is not None}
        return {f"{name}.parquet": self._file(table, told) for name, table in tables.items()}

    def _file(self, table: Table, told: Mapping[str, str]) -> bytes:
        arrow = self._arrow
        fields = [(name, self._types[kind]) for name, (kind, _) in table.items()]
        columns = [
            arrow.array([_storable(cell) for cell in cells], type=self._types[kind]) for kind, cells in table.values()
        ]
        schema = arrow.schema(fields, metadata=dict(told))
        out = arrow.BufferOutputStream()
        arrow.parquet.write_table(arrow.Table.from_arrays(columns, schema=schema), out)
        content: bytes = out.getvalue().to_pybytes()
        return content


def _storable(cell: Any) -> Any:
    """Give a cell as Parquet can hold it: half a character, as broken texts may have, has no place in UTF-8."""
    if isinstance(cell, str):
        return cell.encode("utf-8", "backslashreplace").decode("utf-8")
    if isinstance(cell, list):
        return [_storable(each) for each in cell]
    if isinstance(cell, dict):
        return {name: _storable(each) for name, each in cell.items()}
    return cell
