from __future__ import annotations

import itertools
import json
import math

import pytest
from block_construction.diagram.actions import actions_by_cell
from block_construction.diagram.block_set import block_lengths, body_size
from block_construction.diagram.codes import FAULTS
from block_construction.diagram.cost import connection_faults, diagram_cost
from block_construction.diagram.diagram import assembly_diagram
from block_construction.diagram.planning import read_settings
from block_construction.diagram.table import diagram_csv, diagram_document, read_diagram
from block_construction.errors import ConstructionError
from block_construction.structure.library import library_structure
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import BlockPlacement, Structure, Voxel

# The wall as the source lists it: no fault, 1 block of one unit, 2 of two, 3 of three.
WALL = (
    BlockPlacement(1, 1, 1, 3),
    BlockPlacement(3, 2, 1, -3),
    BlockPlacement(1, 4, 1, 2),
    BlockPlacement(2, 1, 2, 1),
    BlockPlacement(3, 1, 2, -3),
    BlockPlacement(2, 4, 2, 2),
)


def test_the_sources_wall_costs_six_without_a_fault() -> None:
    assert connection_faults(WALL) == ()
    assert diagram_cost(WALL) == 6
    assert assembly_diagram(library_structure("wall"), (1, 2, 3), WALL).counts == {1: 1, 2: 2, 3: 3}


def test_faults_are_thirteen_and_symmetric() -> None:
    assert len(FAULTS) == 13
    assert {(above, below) for below, above in FAULTS} == FAULTS


def test_ends_that_coincide_are_faults_and_crossed_ends_are_none() -> None:
    # Two blocks of two, one above the other: both ends coincide. A single above a middle: none.
    assert connection_faults((BlockPlacement(1, 1, 1, 2), BlockPlacement(1, 1, 2, 2))) == (
        Voxel(1, 1, 1),
        Voxel(2, 1, 1),
    )
    assert connection_faults((BlockPlacement(1, 1, 1, 3), BlockPlacement(2, 1, 2, 1))) == ()
    # An end along x above an end along y: 5 below 2.
    assert connection_faults((BlockPlacement(1, 1, 1, -2), BlockPlacement(1, 1, 2, 2))) == ()
    # A single above an end, and below one.
    assert connection_faults((BlockPlacement(1, 1, 1, -2), BlockPlacement(1, 1, 2, 1))) == (Voxel(1, 1, 1),)
    assert connection_faults((BlockPlacement(1, 1, 1, 1), BlockPlacement(1, 1, 2, -2))) == (Voxel(1, 1, 1),)


@pytest.mark.parametrize(
    ("name", "cells", "actions"),
    [
        ("wall", 14, 32),
        ("dam", 48, 124),
        ("tower", 80, 216),
        ("cistern", 96, 272),
        ("pyramid", 120, 320),
        ("vertical_extension", 336, 952),
        ("horizontal_extension", 480, 1424),
    ],
)
def test_actions_are_as_many_as_counted_for_the_source(name: str, cells: int, actions: int) -> None:
    found = actions_by_cell(library_structure(name), (1, 2, 3))
    assert (len(found), sum(map(len, found.values()))) == (cells, actions)


def test_no_action_crosses_layers_or_leaves_the_structure() -> None:
    structure = Structure("square", ((1, 1, 1), (1, 1, 1), (1, 1, 1)))
    found = actions_by_cell(structure, (1, 2, 3))
    assert found[Voxel(1, 1, 1)] == (1, 2, 3, -2, -3)
    assert found[Voxel(2, 1, 1)] == (1, 2)
    assert found[Voxel(2, 2, 1)] == (1,)
    assert found[Voxel(3, 2, 1)] == (1, -2)


def test_the_middle_of_a_slot_lies_between_its_cells() -> None:
    first, second, third = assembly_diagram(library_structure("wall"), (1, 2, 3), WALL).blocks[:3]
    assert (first.number, first.x, first.y, first.z, first.yaw) == pytest.approx((1, 0.12, 0.04, 0.04, 0.0))
    assert (second.x, second.y, second.yaw) == pytest.approx((0.20, 0.20, math.pi / 2))
    # A block of two sits between its two cells.
    assert (third.x, third.y) == pytest.approx((0.08, 0.28))


def test_bodies_are_shorter_than_their_slots() -> None:
    assert body_size(3) == pytest.approx((0.18, 0.07, 0.07))


@pytest.mark.parametrize(
    ("placements", "complaint"),
    [
        (WALL[1:], "no block covers cell x 1, y 1, level 1"),
        ((*WALL, BlockPlacement(2, 1, 2, 1)), "covered by another block already"),
        ((BlockPlacement(1, 1, 1, 4),), "there are blocks of 1, 2, 3 units only"),
        ((BlockPlacement(1, 1, 1, -2),), "cell x 1, y 2, level 1 is not part of wall"),
        ((BlockPlacement(1, 1, 1, 0),), "there are blocks of 1, 2, 3 units only"),
    ],
)
def test_placements_that_do_not_cover_are_refused(placements: tuple[BlockPlacement, ...], complaint: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        assembly_diagram(library_structure("wall"), (1, 2, 3), placements)
    assert complaint in str(caught.value)


def test_a_block_across_layers_is_refused() -> None:
    structure = Structure("square", ((1, 1, 1), (1, 1, 1), (1, 1, 1)))
    with pytest.raises(ConstructionError, match="cell x 2, y 2, level 1 is of another concentric layer"):
        assembly_diagram(structure, (1, 2, 3), (BlockPlacement(1, 2, 1, 2),))


@given(st.permutations(WALL))
def test_a_diagram_has_one_order_whatever_that_of_its_placements(shuffled: list[BlockPlacement]) -> None:
    diagram = assembly_diagram(library_structure("wall"), (1, 2, 3), shuffled)
    # Level, layer, row, column of the first cell.
    assert diagram.placements == WALL


def test_a_diagram_reads_back_from_its_document() -> None:
    diagram = assembly_diagram(library_structure("wall"), (1, 2, 3), WALL)
    assert read_diagram("d", json.dumps(diagram_document(diagram))) == diagram


def test_the_table_names_slots_in_metres() -> None:
    lines = diagram_csv(assembly_diagram(library_structure("wall"), (1, 2, 3), WALL)).splitlines()
    assert lines[0] == "number,x,y,z,orientation_deg,type,layer,level"
    assert lines[1:3] == ["1,0.120,0.040,0.040,0,3,1,1", "2,0.200,0.200,0.040,90,3,1,1"]


_DOCUMENT = diagram_document(assembly_diagram(library_structure("wall"), (1, 2, 3), WALL))


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        ({"schema": "x"}, "schema: found 'x'"),
        ({"heights": [["a"]]}, "heights[0]: must be whole numbers"),
        ({"heights": [[1, 2], [1]]}, "its rows differ in length"),
        ({"heights": []}, "has no cells"),
        ({"heights": [[10**9]]}, "at most 1000000 are accepted"),
        ({"placements": [3]}, "placements[0]: must be an object"),
        ({"placements": [{"x": 1}]}, "placements[0]: must be whole numbers"),
        ({"placements": [{"x": 1, "y": 1, "level": 1, "length": 0}]}, "length must not be 0"),
        ({"placements": []}, "no block covers cell"),
        ({"lengths": [2, 3]}, "a block of 1 unit must be among them"),
    ],
)
def test_wrong_documents_are_refused_in_one_line(change: dict[str, object], complaint: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        read_diagram("d.json", json.dumps({**_DOCUMENT, **change}))
    assert str(caught.value).startswith("d.json: ")
    assert complaint in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("lengths", [(), (2, 3), (0, 1), (1, 17)])
def test_sets_of_blocks_that_cannot_be_are_refused(lengths: tuple[int, ...]) -> None:
    with pytest.raises(ConstructionError):
        block_lengths(lengths)


def test_every_pair_of_codes_that_is_no_fault_is_good() -> None:
    good = set(itertools.product(range(1, 7), repeat=2)) - FAULTS
    assert (2, 3) in good
    assert (2, 5) in good
    assert (1, 4) in good


def test_settings_of_yes_and_no_are_read_as_such() -> None:
    assert [read_settings({"swift": True}, [f"swift={word}"]) for word in ("yes", "no")] == [
        {"swift": True},
        {"swift": False},
    ]
    with pytest.raises(ConstructionError) as caught:
        read_settings({"swift": True}, ["swift=maybe"])
    assert str(caught.value) == "setting swift: 'maybe'; accepted is yes or no"


@pytest.mark.parametrize("called", [None, 3, "", "two\nlines", "bell\a", "x" * 256])
def test_a_diagram_without_a_name_that_can_be_shown_is_refused(called: object) -> None:
    document = {**diagram_document(assembly_diagram(library_structure("wall"), (1, 2, 3), WALL)), "name": called}
    with pytest.raises(ConstructionError) as caught:
        read_diagram("d.json", json.dumps(document))
    assert str(caught.value).startswith("d.json: name: must be one line of 1 to 255 printable characters (found ")
    assert str(caught.value).isprintable()
