"""Parquet files, read back by pyarrow and, where it is there, by pandas; expected values are written by hand."""

from __future__ import annotations

import dataclasses
import io
import math
import sys
from typing import Any, Dict, List

import pytest
from parquet_tables.exporter import ParquetExporter

from rqt_mrta_py.errors import MissingDependencyError
from rqt_mrta_py.hooks import ExporterSetup, Heard
from rqt_mrta_py.model import (
    ApplicationSpec,
    ArchitectureSpec,
    Evidence,
    Incident,
    Mission,
    MissionRecord,
    Severity,
    Taxonomy,
)
from tests.plugins.csv_tables.missions import RECORD

parquet = pytest.importorskip("pyarrow.parquet", reason="the package pyarrow is not installed (extra parquet)")

NAMES = ["robots", "tasks", "allocations", "incidents", "events", "poses"]


@pytest.fixture
def exporter() -> ParquetExporter:
    mission = Mission(ApplicationSpec("yard", "Yard"), ArchitectureSpec("x", "X", Taxonomy()), ())
    return ParquetExporter(ExporterSetup(mission))


def table(exporter: ParquetExporter, name: str, record: MissionRecord = RECORD) -> Any:
    return parquet.read_table(io.BytesIO(exporter.export(record)[f"{name}.parquet"]))


def rows(exporter: ParquetExporter, name: str, record: MissionRecord = RECORD) -> List[Dict[str, Any]]:
    return list(table(exporter, name, record).to_pylist())


def test_tables_count_seconds_from_the_streams_start(exporter: ParquetExporter) -> None:
    assert rows(exporter, "robots") == [
        {"robot": "a", "state": "offline", "from_s": 0.0, "to_s": 0.1},
        {"robot": "a", "state": "idle", "from_s": 0.1, "to_s": 10.5},
    ]
    assert rows(exporter, "tasks") == [
        {"task": "t", "state": "waiting", "from_s": 0.0, "to_s": 2.25},
        {"task": "t", "state": "done", "from_s": 2.25, "to_s": 10.5},
    ]
    assert rows(exporter, "allocations") == [
        {"task": "t", "robot": "a", "from_s": 0.2, "to_s": 2.25, "outcome": "done"}
    ]


def test_incidents_keep_lists_and_evidence(exporter: ParquetExporter) -> None:
    evidence = (Evidence("/a", 1.5, 0), Evidence("/b", 2.0, 7))
    incident = Incident("odd", Severity.ERROR, 2.0, 3.5, ("a", "b"), (), 'says "no",\nand leaves', evidence, "rain")
    record = dataclasses.replace(RECORD, incidents=(incident,))
    assert rows(exporter, "incidents", record) == [
        {
            "rule": "odd",
            "severity": "error",
            "from_s": 1.0,
            "to_s": 2.5,
            "robots": ["a", "b"],
            "tasks": [],
            "text": 'says "no",\nand leaves',
            "evidence": [
                {"topic": "/a", "time_s": 0.5, "index": 0},
                {"topic": "/b", "time_s": 1.0, "index": 7},
            ],
            "causes": "rain",
        }
    ]


def test_events_have_nothing_where_nothing_is_known(exporter: ParquetExporter) -> None:
    assert [(row["time_s"], row["robot"], row["task"], row["text"]) for row in rows(exporter, "events")] == [
        (0.1, "a", None, "a is idle"),
        (2.25, None, None, "=HYPERLINK(1)"),
    ]


def test_poses_are_numbers_in_the_order_of_the_stream(exporter: ParquetExporter) -> None:
    for robot, receipt, x in (("b", 1.5, -2.0), ("a", 1.5, math.nan), ("a", 2.0, 3.0)):
        fields = {"pose/position/x": x, "pose/position/y": 0.25, "pose/orientation/x": 0.0, "pose/orientation/y": 0.0}
        fields.update({"pose/orientation/z": math.sin(0.5), "pose/orientation/w": math.cos(0.5)})
        exporter.hear(Heard(f"/{robot}/pose", "geometry_msgs/PoseStamped", receipt, fields, robot=robot))
    assert rows(exporter, "poses") == [
        {"robot": "b", "time_s": 0.5, "x_m": -2.0, "y_m": 0.25, "yaw_rad": pytest.approx(1.0)},
        {"robot": "a", "time_s": 1.0, "x_m": 3.0, "y_m": 0.25, "yaw_rad": pytest.approx(1.0)},
    ]


def test_a_mission_of_which_nothing_is_known_gives_tables_with_types_and_no_rows(exporter: ParquetExporter) -> None:
    empty = MissionRecord(None, None, Taxonomy.parse("ST-SR-IA"), None, None, None, (), (), (), (), ())
    assert list(exporter.export(empty)) == [f"{name}.parquet" for name in NAMES]
    for name in NAMES:
        full, bare = table(exporter, name), table(exporter, name, empty)
        assert bare.num_rows == 0
        assert bare.schema.remove_metadata() == full.schema.remove_metadata()
    assert table(exporter, "robots", empty).schema.metadata == {b"taxonomy": b"ST-SR-IA"}


def test_every_file_says_of_which_mission_it_is(exporter: ParquetExporter) -> None:
    told = {
        "application": "yard",
        "architecture": "nearest_robot",
        "taxonomy": "ST-SR-IA",
        "seed": "7",
        "start_s": "1.0",
    }
    for name in NAMES:
        found = table(exporter, name).schema.metadata
        assert {key.decode(): value.decode() for key, value in found.items()} == told


def test_broken_texts_are_kept_as_far_as_they_can_be(exporter: ParquetExporter) -> None:
    allocation = RECORD.allocations[0]._replace(robot="r\ud800\0")
    (row,) = rows(exporter, "allocations", dataclasses.replace(RECORD, allocations=(allocation,)))
    assert row["robot"] == "r\\ud800\0"


def test_equal_missions_give_equal_bytes(exporter: ParquetExporter) -> None:
    assert exporter.export(RECORD) == exporter.export(RECORD)


def test_pandas_reads_the_files(exporter: ParquetExporter) -> None:
    pandas = pytest.importorskip("pandas")
    frame = pandas.read_parquet(io.BytesIO(exporter.export(RECORD)["robots.parquet"]))
    assert frame["to_s"].tolist() == [0.1, 10.5]
    assert str(frame["from_s"].dtype) == "float64"


def test_without_the_package_pyarrow_the_remedy_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("pyarrow", "pyarrow.parquet"):
        monkeypatch.setitem(sys.modules, name, None)
    mission = Mission(ApplicationSpec("yard", "Yard"), ArchitectureSpec("x", "X", Taxonomy()), ())
    with pytest.raises(MissingDependencyError, match=r"pip install 'rqt_mrta_py\[parquet\]'$"):
        ParquetExporter(ExporterSetup(mission))
