from __future__ import annotations

import csv
import dataclasses
import io
import math
from typing import List, Mapping, Tuple

import pytest
from csv_tables.exporter import CsvExporter
from csv_tables.table import csv_bytes
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import ExporterSetup, Heard
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, Mission, MissionRecord, Taxonomy
from tests.plugins.csv_tables.missions import RECORD


@pytest.fixture
def exporter() -> CsvExporter:
    mission = Mission(ApplicationSpec("yard", "Yard"), ArchitectureSpec("x", "X", Taxonomy()), ())
    return CsvExporter(ExporterSetup(mission))


def pose(robot: str, receipt: float, x: float, y: float, yaw: float) -> Heard:
    fields = {
        "pose/position/x": x,
        "pose/position/y": y,
        "pose/orientation/x": 0.0,
        "pose/orientation/y": 0.0,
        "pose/orientation/z": math.sin(yaw / 2),
        "pose/orientation/w": math.cos(yaw / 2),
    }
    return Heard(f"/{robot}/pose", "geometry_msgs/PoseStamped", receipt, fields, robot=robot)


def rows(files: Mapping[str, bytes], name: str) -> List[List[str]]:
    return list(csv.reader(io.StringIO(files[name].decode("utf-8"), newline="")))


def test_tables_count_seconds_from_the_streams_start(exporter: CsvExporter) -> None:
    files = exporter.export(RECORD)
    assert files["robots.csv"] == (b"robot,state,from [s],to [s]\r\na,offline,0.0,0.1\r\na,idle,0.1,10.5\r\n")
    assert files["tasks.csv"] == b"task,state,from [s],to [s]\r\nt,waiting,0.0,2.25\r\nt,done,2.25,10.5\r\n"
    assert files["allocations.csv"] == b"task,robot,from [s],to [s],outcome\r\nt,a,0.2,2.25,done\r\n"


def test_texts_with_commas_quotes_and_lines_stay_in_one_cell(exporter: CsvExporter) -> None:
    files = exporter.export(RECORD)
    assert files["incidents.csv"].splitlines(keepends=True)[1:] == [
        b'odd,warning,1.0,2.0,a b,t,"a says ""no"", b too,\n',
        b'and leaves",\r\n',
    ]


def test_incidents_say_what_usually_causes_them(exporter: CsvExporter) -> None:
    record = dataclasses.replace(RECORD, incidents=(dataclasses.replace(RECORD.incidents[0], causes="rain, snow"),))
    head, row = rows(exporter.export(record), "incidents.csv")
    assert (head[-1], row[-1]) == ("causes", "rain, snow")


def test_texts_that_would_be_formulas_are_made_harmless(exporter: CsvExporter) -> None:
    assert rows(exporter.export(RECORD), "events.csv") == [
        ["time [s]", "kind", "severity", "robot", "task", "state", "text"],
        ["0.1", "robot_state", "info", "a", "", "idle", "a is idle"],
        ["2.25", "unreadable", "warning", "", "", "", "'=HYPERLINK(1)"],
    ]


def test_poses_are_listed_in_the_order_of_the_stream_and_numbers_keep_their_sign(exporter: CsvExporter) -> None:
    (wish,) = exporter.subscriptions()
    assert (wish.topic, wish.type) == ("/@robot_id@/pose", "geometry_msgs/PoseStamped")
    exporter.hear(pose("b", 1.5, -2.0, 0.25, math.pi / 2))
    exporter.hear(pose("a", 1.5, 3.0, math.nan, 0.0))
    exporter.hear(pose("a", 2.0, 3.0, 0.0, -1.0))
    assert rows(exporter.export(RECORD), "poses.csv") == [
        ["robot", "time [s]", "x [m]", "y [m]", "yaw [rad]"],
        ["b", "0.5", "-2.0", "0.25", "1.570796"],
        ["a", "1.0", "3.0", "0.0", "-1.0"],
    ]


def test_mission_of_which_nothing_is_known_gives_headers_only(exporter: CsvExporter) -> None:
    empty = MissionRecord(None, None, Taxonomy(), None, None, None, (), (), (), (), ())
    files = exporter.export(empty)
    assert list(files) == ["robots.csv", "tasks.csv", "allocations.csv", "incidents.csv", "events.csv", "poses.csv"]
    assert all(len(rows(files, name)) == 1 for name in files)


def test_cells_are_written_by_their_kind() -> None:
    assert csv_bytes(("a", "b", "c", "d", "e"), [(None, True, -3, -0.5, "é")]) == (
        "a,b,c,d,e\r\n,true,-3,-0.5,é\r\n".encode()
    )


@given(st.lists(st.tuples(st.text(), st.text()), max_size=5))
def test_any_text_comes_back_save_for_apostrophe_and_nul(cells: List[Tuple[str, str]]) -> None:
    read = list(csv.reader(io.StringIO(csv_bytes(("a", "b"), cells).decode("utf-8"), newline="")))
    kept = [[cell.replace("\0", "\ufffd") for cell in row] for row in cells]
    expected = [[f"'{cell}" if cell[:1] in tuple("=+-@\t\r\n") else cell for cell in row] for row in kept]
    assert read[1:] == expected
    assert not [cell for row in read for cell in row if cell.startswith(("=", "+", "-", "@"))]
