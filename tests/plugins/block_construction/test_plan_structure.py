"""The verb ``plan-structure``, as somebody types it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict

import pytest
from block_construction.diagram.table import read_diagram
from block_construction.structure.drawings import read_structure, structure_files
from block_construction.structure.level_maps import read_level_maps
from block_construction.structure.library import library_structure

from rqt_mrta_py.app.cli.main import main


def told(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """Carry the verb out, which must succeed, and give what it prints."""
    assert main(["plan-structure", *arguments]) == 0
    return capsys.readouterr().out


def refused(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """Let the verb refuse, and give its one line."""
    assert main(["plan-structure", *arguments]) in (2, 3)
    said = capsys.readouterr()
    assert (said.out, said.err.count("\n")) == ("", 1)
    return said.err


def test_the_document_holds_cost_blocks_faults_and_counts(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("ortools", reason="OR-tools proves optima")
    document: Dict[str, Any] = json.loads(told(capsys, "wall", "--method", "exact", "--json"))
    assert document.pop("seconds") >= 0.0
    assert document == {
        "schema": "rqt_mrta_py/plan_structure/1",
        "cost": 6,
        "blocks": 6,
        "faults": 0,
        "counts": {"1": 1, "2": 2, "3": 3},
        "proved": True,
    }


def test_the_diagram_that_is_left_is_the_one_that_is_told(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    pytest.importorskip("ortools", reason="OR-tools proves optima")
    assert "cost 6, proved" in told(capsys, "wall", "--out", str(tmp_path / "out"))
    diagram = read_diagram("diagram.json", (tmp_path / "out/diagram.json").read_text(encoding="utf-8"))
    assert (diagram.structure.name, diagram.cost, diagram.counts) == ("wall", 6, {1: 1, 2: 2, 3: 3})
    assert len((tmp_path / "out/diagram.csv").read_text(encoding="utf-8").splitlines()) == 7
    assert json.loads((tmp_path / "out/summary.json").read_text(encoding="utf-8"))["cost"] == 6
    assert not (tmp_path / "out/plan.json").exists()
    forms = [read_structure(str(tmp_path / f"out/structure.{form}")) for form in ("vox", "npy", "txt")]
    assert {each.heights for each in forms} == {library_structure("wall").heights}


def test_a_structure_too_long_for_vox_is_left_in_the_other_forms() -> None:
    row = read_level_maps("row", "#" * 257)
    assert sorted(structure_files(row)) == ["structure.npy", "structure.txt"]
    assert "structure.vox" in structure_files(read_level_maps("row", "#" * 256))


def test_a_drawing_of_ones_own_is_planned(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    pytest.importorskip("ortools", reason="OR-tools proves optima")
    drawing = tmp_path / "bench.txt"
    drawing.write_text("##\n", encoding="utf-8")
    assert json.loads(told(capsys, str(drawing), "--blocks", "1", "--json"))["counts"] == {"1": 2}
    assert json.loads(told(capsys, str(drawing), "--blocks", "1,2", "--json"))["counts"] == {"1": 0, "2": 1}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("igloo",), "mrta: igloo: neither a file *.npy, *.txt, *.vox nor one of the structures "),
        (("wall", "--method", "guess"), "mrta: --method guess: no such planner; there are: "),
        (("wall", "--blocks", "2"), "mrta: --blocks 2: blocks of 2 units; a block of 1 unit must be among them"),
        (("wall", "--blocks", "one"), "mrta: --blocks one: units of blocks are expected, for instance 1,2,3"),
        (("wall", "--set", "haste=1"), "mrta: setting 'haste=1': accepted are layer_seconds=..."),
        (("wall", "--set", "layer_seconds=nan"), "mrta: setting layer_seconds: 'nan'; accepted is a finite number"),
        (("wall", "--set", "layer_seconds=-1"), "mrta: setting layer_seconds: must be 0 or more (found -1.0)"),
    ],
)
def test_what_cannot_be_planned_is_told_in_one_line(
    capsys: pytest.CaptureFixture[str], arguments: Any, message: str
) -> None:
    assert refused(capsys, *arguments).startswith(message)


def test_a_folder_that_holds_something_is_left_alone(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine", encoding="utf-8")
    assert "the folder is not empty" in refused(capsys, "wall", "--out", str(tmp_path))
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]
