"""Plans and supplies as files, and the verb ``plan-build``."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any, Dict

import pytest
from block_construction.diagram.table import diagram_document
from block_construction.errors import ConstructionError
from block_construction.execution.plan_file import plan_csv, plan_document, read_plan
from block_construction.execution.planners import plan_build
from block_construction.execution.supply_file import Supply, read_supply, supply_document, supply_named
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.app.cli.main import main
from tests.plugins.block_construction.builds import RING, RING_BLOCKS, problem

pytest.importorskip("scipy", reason="SciPy finds ways")

SUPPLY = """
arena: {side: 2.4, start: [1.2, 0.3]}
places:
  - {x: 0.2, y: 0.2, blocks: {2: 3, 1: null}}
  - {x: 2.2, y: 2.2, yaw: 0.5, blocks: [2]}
"""


def test_a_supply_is_read_from_yaml_and_from_json() -> None:
    arena, places = read_supply("supply.yaml", SUPPLY)
    assert (arena.side, arena.start, arena.cell) == (2.4, (1.2, 0.3), 0.04)
    assert [(each.number, each.x, each.stock) for each in places] == [(1, 0.2, {2: 3, 1: None}), (2, 2.2, {2: None})]
    # Out from the middle at (1.2, 1.2), or as the file says.
    assert [each.yaw for each in places] == [pytest.approx(-2.3562, abs=1e-4), 0.5]
    assert read_supply("supply.json", json.dumps(supply_document(Supply(arena, places)))) == (arena, places)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[", "s: neither YAML nor JSON (while parsing a flow node"),
        ("7", "s: the file: must be a mapping of arena, places (found 7)"),
        ("{places: []}", "s: places: must be a list of 1 to 100 places"),
        ("{places: [{x: 1, y: 1}]}", "s: places[0]: blocks: missing; a place has x, y and blocks"),
        ("{places: [{x: 1, y: .nan, blocks: [1]}]}", "s: places[0].y: must be a finite number (found nan)"),
        ("{places: [{x: 1, y: 1, blocks: [1], w: 2}]}", "s: places[0]: 'w': unknown; accepted are x, y, yaw, blocks"),
        (
            "{places: [{x: 1, y: 1, blocks: [0]}]}",
            "s: places[0].blocks: found 0: None; accepted are lengths of 1 to 16",
        ),
        ("{places: [{x: 1, y: 1, blocks: {1: -1}}]}", "s: places[0].blocks: found 1: -1; accepted are lengths"),
        ("{places: [{x: 1, y: 1, blocks: {1: yes}}]}", "s: places[0].blocks: found 1: True; accepted are lengths"),
        ("{places: [{x: 1, y: 1, blocks: [1, 1]}]}", "s: places[0].blocks: found 1: None; accepted are lengths"),
        ("{places: [{x: 1, y: 1, blocks: {}}]}", "s: places[0].blocks: must be a list of lengths"),
        ("{arena: {side: -1}, places: 1}", "s: arena: side: must be finite and above 0 m (found -1.0)"),
        ("{arena: {side: 1.0e+300}, places: 1}", "s: arena: side: 1e+300 m; at most 100 m are accepted"),
        (
            "places: [{x: 1, y: 1, yaw: 1.0e+300, blocks: [1]}]",
            "s: places[0].yaw: found 1e+300 rad; accepted are 10 turns at most",
        ),
        ("{arena: {start: 1}, places: 1}", "s: arena.start: must be [x, y] in metres (found 1)"),
        ("{arena: !!timestamp x, places: 1}", "s: neither YAML nor JSON (a value is not what its tag says)"),
        ("{arena: !!bool x, places: 1}", "s: neither YAML nor JSON (a value is not what its tag says)"),
        ("arena: &a {side: 2}\nplaces: [{<<: *a}]", "s: neither YAML nor JSON (<< is not accepted"),
        ("{places: [{x: 1, x: 2, y: 1, blocks: [1]}]}", "s: neither YAML nor JSON ('x' comes twice"),
        ("&a [*a]", "s: the file: must be a mapping of arena, places (found [[[[[[[...]]]]]]])"),
    ],
)
def test_what_is_no_supply_is_told_where(text: str, message: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        read_supply("s", text)
    assert str(caught.value).startswith(message)


def test_merges_that_would_double_with_every_line_are_not_carried_out() -> None:
    lines = [f"a{each}: &a{each} {{<<: [*a{each - 1}, *a{each - 1}]}}" for each in range(1, 60)]
    with pytest.raises(ConstructionError, match="<< is not accepted"):
        read_supply("s", "\n".join(["a0: &a0 {x: 1}", *lines]))


def test_of_a_device_no_more_is_read_than_of_a_file() -> None:
    endless = Path("/dev/zero")
    if not endless.exists():
        pytest.skip("there is no such device here")
    with pytest.raises(ConstructionError, match=r"^/dev/zero: 1000001 bytes; at most 1000000 are accepted"):
        supply_named(str(endless))


@given(st.text(max_size=60))
def test_any_text_is_a_supply_or_an_error_in_one_line(text: str) -> None:
    told = "s: "
    try:
        read_supply("s", text)
    except ConstructionError as error:
        told = str(error)
    assert told.startswith("s: ")
    assert "\n" not in told


def test_a_plan_reads_back_as_it_was() -> None:
    plan = plan_build("exact", problem(RING, RING_BLOCKS)).plan
    assert read_plan("plan.json", json.dumps(plan_document(plan))) == plan


def test_the_table_lists_steps_with_slots_poses_and_ways() -> None:
    """Three cells of 8 cm in the middle of 2.2 m begin at 0.98 m: the lower block's slot ends at 1.14 m."""
    plan = plan_build("exact", problem(RING, RING_BLOCKS)).plan
    rows = list(csv.DictReader(plan_csv(plan).splitlines()))
    assert [int(row["block"]) for row in rows] == list(plan.alternating[1::2])
    (lower,) = [row for row in rows if row["block"] == "1"]
    assert [lower[key] for key in ("type", "x", "y", "z", "orientation_deg")] == ["2", "1.060", "1.020", "0.040", "0"]
    assert [lower[key] for key in ("robot_x", "robot_y", "heading_deg")] == ["1.060", "0.720", "90"]
    assert sum(float(row["fetching"]) for row in rows) == pytest.approx(plan.cost.fetching, abs=0.002)


def changed(**changes: Any) -> str:
    document = plan_document(plan_build("exact", problem(RING, RING_BLOCKS)).plan)
    return json.dumps({**document, **changes})


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"schema": 1}, "p: schema: found 1; accepted is 'rqt_mrta_py/build_plan/1'"),
        ({"method": None}, "p: method: must be a text (found None)"),
        ({"steps": 1}, "p: steps: must be a list (found int)"),
        ({"steps": [{"place": 1}]}, "p: steps[0]: must have whole numbers place, block, heading_deg"),
        (
            {"steps": [{"place": 1, "block": 1, "heading_deg": 45}]},
            "p: steps[0]: heading_deg: found 45; accepted are 0, 90, 180, 270",
        ),
        ({"steps": []}, "p: left_out: block 1: no step places it"),
        ({"diagram": {}}, "p: diagram: schema: found None"),
        ({"supply": {"places": []}}, "p: supply: places: must be a list of 1 to 100 places"),
    ],
)
def test_what_is_no_plan_is_told_where(changes: Dict[str, Any], message: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        read_plan("p", changed(**changes))
    assert str(caught.value).startswith(message)


@pytest.fixture
def diagram(tmp_path: Path) -> str:
    path = tmp_path / "diagram.json"
    path.write_text(json.dumps(diagram_document(problem(RING, RING_BLOCKS).diagram)), encoding="utf-8")
    return str(path)


def test_the_verb_prints_the_plan_and_leaves_it(
    diagram: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert (
        main(["plan-build", diagram, "--supply", "corners_all", "--method", "exact", "--json", "--out", str(out)]) == 0
    )
    document = json.loads(capsys.readouterr().out)
    assert (document["schema"], document["proved"]) == ("rqt_mrta_py/plan_build/1", True)
    assert document["length"] == pytest.approx(document["fetching"] + document["placing"], abs=1e-5)
    assert sorted(document["plan"][1::2]) == [1, 2, 3, 4]
    plan = read_plan("plan.json", (out / "plan.json").read_text(encoding="utf-8"))
    assert list(plan.alternating) == document["plan"]
    assert len((out / "plan.csv").read_text(encoding="utf-8").splitlines()) == 5


@pytest.mark.parametrize(
    ("arguments", "status", "message"),
    [
        (("--supply", "corners", "--method", "wish"), 2, "mrta: --method wish: no such method; there are: "),
        (
            ("--supply", "nowhere"),
            3,
            "mrta: nowhere: cannot be read: No such file or directory; accepted",
        ),
        (("--supply", "corners", "--set", "beam=x"), 3, "mrta: setting beam: 'x'; accepted is a whole number"),
        (("--supply", "corners", "--set", "beam=-5"), 3, "mrta: setting beam: must be 1 or more (found -5)"),
    ],
)
def test_the_verb_refuses_in_one_line(
    diagram: str, arguments: Any, status: int, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["plan-build", diagram, *arguments]) == status
    said = capsys.readouterr()
    assert said.err.startswith(message)
    assert (said.out, said.err.count("\n")) == ("", 1)


def test_exact_claims_no_more_than_it_proves(diagram: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["plan-build", diagram, "--supply", "corners_all", "--method", "exact"]) == 0
    assert (
        capsys.readouterr()
        .out.splitlines()[0]
        .endswith(" m by exact, the shortest for these groups and one side a block")
    )


def test_supplies_of_the_package_have_four_corners() -> None:
    assert [each.stock for each in supply_named("corners").places] == [{2: None}, {1: None}, {3: None}, {3: None}]
    assert [sorted(each.stock) for each in supply_named("corners_all").places] == [[1, 2, 3]] * 4
