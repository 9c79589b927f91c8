from __future__ import annotations

import csv
import io
import json
from argparse import ArgumentParser
from pathlib import Path
from typing import Any, Dict, List
from unittest.mock import Mock

import csv_tables.plugin
import pytest
from csv_tables.exporter import CsvExporter
from csv_tables.tabulate import TABULATE

from rqt_mrta_py.hooks import MrtaError, UsageError, VerbTools
from rqt_mrta_py.hooks.manager import PluginManager

SUMMARY: Dict[str, Any] = {
    "schema": "rqt_mrta_py/summary/1",
    "application": "yard",
    "architecture": "mrta_alliance",
    "taxonomy": "ST-SR-IA",
    "seed": 3,
    "time": {"start": 1.0, "end": 181.0},
    "robots": [{"id": "a", "states": []}, {"id": "b", "states": []}],
    "tasks": [{"id": "t", "state": "done"}, {"id": "u", "state": "done"}, {"id": "v", "state": "failed"}],
    "allocations": [{}, {}, {}],
    "incidents": [{"severity": "error"}],
    "statistics": {"reached": 2, "share": {"a": 0.5, "deep": {"b": None, "c": "x"}}, "list": [1, 2], "all": True},
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return write(tmp_path / "one", SUMMARY)


def write(folder: Path, summary: Any) -> Path:
    folder.mkdir()
    text = summary if isinstance(summary, str) else json.dumps(summary)
    (folder / "summary.json").write_text(text, encoding="utf-8")
    return folder


def tabulate(*arguments: object) -> int:
    parser = ArgumentParser()
    TABULATE.add_arguments(parser)
    return TABULATE.main(parser.parse_args([str(argument) for argument in arguments]), Mock(spec=VerbTools))


def read(content: bytes) -> List[Dict[str, str]]:
    return list(csv.DictReader(io.StringIO(content.decode("utf-8"), newline="")))


def test_run_is_one_line(folder: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    assert tabulate(folder) == 0
    head, line = capfdbinary.readouterr().out.split(b"\r\n")[:2]
    assert head == (
        b"folder,application,architecture,taxonomy,seed,duration [s],robots,tasks.waiting,tasks.allocated,"
        b"tasks.executing,tasks.done,tasks.failed,tasks.withdrawn,allocations,incidents.info,incidents.warning,"
        b"incidents.error,statistics.all,statistics.reached,statistics.share.a,statistics.share.deep.c"
    )
    assert line == f"{folder},yard,mrta_alliance,ST-SR-IA,3,180.0,2,0,0,0,2,1,0,3,0,0,1,true,2,0.5,x".encode()


def test_runs_that_tell_different_things_share_one_table(folder: Path, tmp_path: Path) -> None:
    other = write(tmp_path / "two", {"schema": SUMMARY["schema"], "time": {"start": None}, "statistics": {"z": 1.5}})
    assert tabulate(folder, other, "--out", tmp_path / "all.csv") == 0
    first, second = read((tmp_path / "all.csv").read_bytes())
    assert (first["statistics.reached"], first["statistics.z"]) == ("2", "")
    assert second == {**dict.fromkeys(first, ""), "folder": str(other), "statistics.z": "1.5"}


def test_file_is_written_whole_and_not_over_another(folder: Path, tmp_path: Path) -> None:
    out = tmp_path / "all.csv"
    out.write_text("precious")
    with pytest.raises(UsageError, match="is there already; --force writes over it"):
        tabulate(folder, "--out", out)
    assert out.read_text() == "precious"
    assert tabulate(folder, "--out", out, "--force") == 0
    assert len(read(out.read_bytes())) == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["all.csv", "one"]


def test_file_that_cannot_be_written_is_told_in_one_line(folder: Path, tmp_path: Path) -> None:
    with pytest.raises(MrtaError, match=r"no/all\.csv: cannot be written: No such file or directory"):
        tabulate(folder, "--out", tmp_path / "no" / "all.csv")


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("", "Expecting value"),
        ("{", "Expecting property name"),
        ("[]", "its schema is 'list'"),
        ("{}", "its schema is 'None'"),
        ('{"schema": "rqt_mrta_py/run/1"}', "its schema is 'rqt_mrta_py/run/1'"),
        ('{"schema": "rqt_mrta_py/summary/1", "seed": NaN}', "NaN is no JSON"),
        ("[" * 200_000, "nested too deeply"),
    ],
    ids=["empty", "cut off", "list", "no schema", "other schema", "not a number", "deep"],
)
def test_foreign_file_is_told_in_one_line(tmp_path: Path, content: str, reason: str) -> None:
    broken = write(tmp_path / "broken", content)
    with pytest.raises(MrtaError) as caught:
        tabulate(broken)
    (line,) = str(caught.value).splitlines()
    assert line.startswith(f"{broken}/summary.json: is no summary of a run or review: ")
    assert reason in line
    assert caught.value.exit_code == 3


def test_all_broken_files_are_told_at_once_and_nothing_is_written(
    folder: Path, tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]
) -> None:
    broken = write(tmp_path / "broken", "{}")
    with pytest.raises(MrtaError) as caught:
        tabulate(broken, folder, tmp_path / "missing")
    lines = str(caught.value).splitlines()
    assert [line.split(": ")[0] for line in lines] == [f"{broken}/summary.json", f"{tmp_path}/missing/summary.json"]
    assert capfdbinary.readouterr().out == b""


@pytest.mark.parametrize(
    "changes",
    [
        {"robots": 3, "tasks": {"a": 1}, "incidents": "none", "allocations": None},
        {"tasks": [1, None, {"state": ["done"]}], "incidents": [[]]},
        {"statistics": [1]},
        {"time": [1, 2], "seed": {"a": 1}, "application": []},
        {"time": {"start": 1, "end": "later"}},
    ],
    ids=str,
)
def test_summary_of_strange_shape_leaves_cells_empty(tmp_path: Path, changes: Dict[str, Any]) -> None:
    strange = write(tmp_path / "strange", {**SUMMARY, **changes})
    assert tabulate(strange, "--out", tmp_path / "all.csv") == 0
    (row,) = read((tmp_path / "all.csv").read_bytes())
    assert row["folder"] == str(strange)


def test_numbers_of_no_sound_size_are_left_out(tmp_path: Path) -> None:
    text = json.dumps(SUMMARY).replace("181.0", "1e999").replace('"reached": 2', '"reached": 1' + "0" * 400)
    strange = write(tmp_path / "strange", text)
    assert tabulate(strange, "--out", tmp_path / "all.csv") == 0
    (row,) = read((tmp_path / "all.csv").read_bytes())
    assert (row["duration [s]"], row.get("statistics.reached", "")) == ("", "")


def test_names_that_would_be_formulas_are_made_harmless(tmp_path: Path) -> None:
    write(tmp_path / "x", {**SUMMARY, "application": "=1+1", "statistics": {"s": "@cmd"}})
    assert tabulate(tmp_path / "x", "--out", tmp_path / "all.csv") == 0
    (row,) = read((tmp_path / "all.csv").read_bytes())
    assert (row["application"], row["statistics.s"]) == ("'=1+1", "'@cmd")


def test_plugin_registers_exporter_and_verb() -> None:
    manager = PluginManager()
    manager.register(csv_tables.plugin, "csv_tables")
    assert manager.registered("mrta_register_exporters") == {"csv": CsvExporter}
    assert manager.registered("mrta_register_verbs") == {"tabulate": TABULATE}
