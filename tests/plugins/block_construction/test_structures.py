from __future__ import annotations

import io
import struct
from pathlib import Path
from typing import List, Tuple

import numpy as np
import pytest
from block_construction.errors import ConstructionError
from block_construction.structure.drawings import read_structure
from block_construction.structure.layers import cells_in_order, layer_count, layer_of
from block_construction.structure.level_maps import read_level_maps, write_level_maps
from block_construction.structure.library import library_structure, structure_names
from block_construction.structure.npy_file import read_npy, write_npy
from block_construction.structure.vox_file import read_vox, write_vox
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Structure, Voxel

heights = st.integers(1, 6).flatmap(
    lambda columns: st.lists(
        st.lists(st.integers(0, 5), min_size=columns, max_size=columns).map(tuple), min_size=1, max_size=6
    )
)
# As they are read: without empty columns or rows around them.
structures = (
    heights.filter(
        lambda rows: any(rows[0]) and any(rows[-1]) and any(row[0] for row in rows) and any(row[-1] for row in rows)
    )
    .map(tuple)
    .map(lambda rows: Structure("drawn", rows))
)


def test_cells_layers_and_levels_are_those_of_the_source() -> None:
    # Cells, non-empty layers, levels; Dantas 2017, tables 1, 9, 11, 13 and 15.
    expected = {
        "wall": (14, 1, 2),
        "cistern": (96, 1, 4),
        "pyramid": (120, 4, 4),
        "tower": (80, 1, 4),
        "dam": (48, 1, 4),
        "vertical_extension": (336, 1, 14),
        "horizontal_extension": (480, 1, 4),
        "station": (52, 4, 4),
        "station_b": (52, 4, 4),
    }
    found = {}
    for name in structure_names():
        structure = library_structure(name)
        layers = {layer_of(cell.x, cell.y, structure.columns, structure.rows) for cell in cells_in_order(structure)}
        found[name] = (structure.size, len(layers), structure.levels)
    assert found == expected


def test_the_wall_stands_where_the_source_lists_it() -> None:
    assert write_level_maps(library_structure("wall")) == "###\n..#\n..#\n###\n\n.##\n..#\n..#\n.##\n"


def test_four_by_three_cells_have_two_layers() -> None:
    assert layer_count(4, 3) == 2
    layers = [[layer_of(x, y, 4, 3) for x in range(1, 5)] for y in range(1, 4)]
    assert layers == [[1, 1, 1, 1], [1, 2, 2, 1], [1, 1, 1, 1]]


def test_cells_are_numbered_by_level_layer_row_and_column() -> None:
    structure = Structure("block", ((1, 1, 1), (1, 2, 1), (1, 1, 1)))
    assert cells_in_order(structure) == (
        Voxel(1, 1, 1),
        Voxel(2, 1, 1),
        Voxel(3, 1, 1),
        Voxel(1, 2, 1),
        Voxel(3, 2, 1),
        Voxel(1, 3, 1),
        Voxel(2, 3, 1),
        Voxel(3, 3, 1),
        Voxel(2, 2, 1),
        Voxel(2, 2, 2),
    )


@pytest.mark.parametrize(
    ("name", "size"), [("wall", 116), ("dam", 252), ("tower", 380), ("cistern", 444), ("pyramid", 540)]
)
def test_vox_files_have_as_many_bytes_as_a_smallest_file_has(name: str, size: int) -> None:
    assert len(write_vox(library_structure(name))) == size


@given(structures)
def test_every_form_reads_back_what_it_wrote(structure: Structure) -> None:
    assert read_vox("drawn", write_vox(structure)) == structure
    assert read_npy("drawn", write_npy(structure)) == structure
    assert read_level_maps("drawn", write_level_maps(structure)) == structure


def test_rows_of_an_array_count_from_y_1() -> None:
    cells = np.zeros((1, 2, 3))
    cells[0, 0, :] = 1
    cells[0, 1, 2] = 7
    content = io.BytesIO()
    np.save(content, cells)
    assert read_npy("a", content.getvalue()).heights == ((1, 1, 1), (0, 0, 1))


def test_unknown_chunks_of_a_vox_file_are_passed_over() -> None:
    whole = write_vox(library_structure("wall"))
    children = whole[20:]
    extra = struct.pack("<4sii", b"nTRN", 4, 0) + b"abcd"
    longer = whole[:8] + struct.pack("<4sii", b"MAIN", 0, len(children) + len(extra)) + extra + children
    assert read_vox("wall", longer) == library_structure("wall")


def test_a_floating_voxel_is_named() -> None:
    with pytest.raises(ConstructionError, match=r"^bridge: the voxel at x 2, y 1, level 2 floats: .*; 1 in all"):
        read_level_maps("bridge", "#.#\n\n###\n")


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("", "holds no map"),
        ("..\n..\n", "no cell is filled"),
        ("#x\n", "m:1: 'x' in a map"),
        ("##\n#\n", "m:2: 1 cells in a line; the first line has 2"),
        ("##\n##\n\n##\n", "the map of level 2 has 1 lines; level 1 has 2"),
    ],
)
def test_wrong_maps_are_refused_in_one_line(text: str, complaint: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        read_level_maps("m", text)
    assert complaint in str(caught.value)
    assert "\n" not in str(caught.value)


def _vox(chunks: bytes, version: int = 150, main: bytes = b"MAIN") -> bytes:
    return b"VOX " + struct.pack("<i", version) + struct.pack("<4sii", main, 0, len(chunks)) + chunks


_SIZE = struct.pack("<4siiiii", b"SIZE", 12, 0, 2, 2, 2)
_ONE = struct.pack("<4siiiBBBB", b"XYZI", 8, 0, 1, 0, 0, 0, 1)


@pytest.mark.parametrize(
    ("content", "complaint"),
    [
        (b"", "0 bytes"),
        (b"VOX!" + bytes(16), "begins with b'VOX!'"),
        (_vox(b"", version=1), "version 1"),
        (_vox(b"", main=b"XXXX"), "the first chunk must be MAIN"),
        (_vox(_SIZE), "holds 0 models"),
        (_vox(_SIZE + _ONE + _SIZE + _ONE), "holds 2 models"),
        (_vox(_ONE), "XYZI without a SIZE"),
        (_vox(_SIZE + _ONE[:-2]), "says 8 and 0 bytes; 6 are left"),
        (_vox(_SIZE + struct.pack("<4siii", b"XYZI", 4, 0, 2**31 - 1)), "tells of 2147483647 voxels but has 0 bytes"),
        (_vox(_SIZE + struct.pack("<4siii", b"XYZI", 4, 0, -1)), "tells of -1 voxels"),
        (_vox(_SIZE + struct.pack("<4siiiBBBB", b"XYZI", 8, 0, 1, 2, 0, 0, 1)), "x 3, y 1, level 1 lies outside"),
        (_vox(struct.pack("<4siiiii", b"SIZE", 12, 0, 2**30, 2**30, 2) + _ONE), "at most 1000000 are accepted"),
        (_vox(struct.pack("<4siiiii", b"SIZE", 12, 0, 0, 1, 1) + _ONE), "each side must be 1 or more"),
    ],
)
def test_broken_vox_files_are_refused_in_one_line(content: bytes, complaint: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        read_vox("drawing.vox", content)
    assert complaint in str(caught.value)
    assert "\n" not in str(caught.value)


_WALL = library_structure("wall")
_FORMS = {".vox": write_vox(_WALL), ".npy": write_npy(_WALL), ".txt": write_level_maps(_WALL).encode()}


def is_read_or_refused(path: Path, content: bytes) -> bool:
    """Tell whether a drawing gives a structure or one line that can be shown."""
    path.write_bytes(content)
    try:
        return read_structure(str(path)).size > 0
    except ConstructionError as error:
        return str(error).isprintable()


@given(st.sampled_from(sorted(_FORMS)), st.binary(max_size=200))
def test_no_bytes_break_the_readers(tmp_path_factory: pytest.TempPathFactory, form: str, noise: bytes) -> None:
    assert is_read_or_refused(tmp_path_factory.getbasetemp() / f"noise{form}", noise)


@settings(max_examples=400)
@given(
    st.sampled_from(sorted(_FORMS)),
    st.lists(st.tuples(st.integers(0, 2**16), st.integers(0, 255)), max_size=4),
    st.integers(0, 2**16),
)
def test_a_damaged_drawing_is_read_or_refused_in_one_line(
    tmp_path_factory: pytest.TempPathFactory, form: str, changes: List[Tuple[int, int]], cut: int
) -> None:
    changed = bytearray(_FORMS[form])
    for place, value in changes:
        changed[place % len(changed)] = value
    del changed[cut % (2 * len(changed)) :]
    assert is_read_or_refused(tmp_path_factory.getbasetemp() / f"damaged{form}", bytes(changed))


def _npy(header: str, cells: bytes = bytes([1])) -> bytes:
    line = f"{header}\n".encode("latin-1")
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(line)) + line + cells


@pytest.mark.parametrize(
    ("header", "complaint"),
    [
        ("{'descr': '|b1', 'fortran_order': False, 'shape': (1, 1, 1", "no NumPy array"),
        ("{'descr': '|b1', 'fortran_order': False, 'shape': (True, True, True)}", "no whole number"),
        ("{'descr': '|b1', 'fortran_order': False, 'shape': (-1, 1, -1)}", "each side must be 1 or more"),
        ("{'descr': '|b1', 'fortran_order': False, 'shape': (1, 2, 1)}", "cut off: 1 bytes of cells, and there must"),
        ("{'descr': '|b1', 'fortran_order': False, 'shape': (1, 1, 0x1" + 4000 * "0" + ")}", "no whole number"),
        ("{'descr': '\\d', 'fortran_order': False, 'shape': (1, 1, 1)}", "no NumPy array"),
    ],
    ids=["bracket", "truth", "negative", "cut", "endless", "escape"],
)
def test_arrays_with_wrong_headers_are_refused_in_one_line(header: str, complaint: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        read_npy("a.npy", _npy(header))
    assert complaint in str(caught.value)
    assert str(caught.value).isprintable()


def test_arrays_may_be_kept_by_columns() -> None:
    content = io.BytesIO()
    np.save(content, np.asfortranarray([[[1, 0], [1, 1]]]))
    assert read_npy("a", content.getvalue()).heights == ((1, 0), (1, 1))


@pytest.mark.parametrize(
    ("array", "complaint"),
    [
        (np.zeros((2, 2)), "an array of shape (2, 2)"),
        (np.array([[["a"]]]), "accepted are numbers"),
        (np.full((1, 1, 1), np.nan), "a cell is not finite"),
        (np.zeros((1, 1, 1)), "no cell is filled"),
    ],
)
def test_wrong_arrays_are_refused(array: np.ndarray, complaint: str) -> None:
    content = io.BytesIO()
    np.save(content, array)
    with pytest.raises(ConstructionError) as caught:
        read_npy("a.npy", content.getvalue())
    assert complaint in str(caught.value)


def test_an_array_that_promises_too_much_is_not_read() -> None:
    content = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        content, {"descr": "|b1", "fortran_order": False, "shape": (10**6, 10**6, 10**6)}
    )
    with pytest.raises(ConstructionError, match="at most 1000000 are accepted"):
        read_npy("a.npy", content.getvalue())


def test_a_pickle_is_never_read() -> None:
    content = io.BytesIO()
    np.save(content, np.array([[[object()]]], dtype=object), allow_pickle=True)
    with pytest.raises(ConstructionError, match="accepted are numbers"):
        read_npy("a.npy", content.getvalue())


def test_structures_are_found_by_name_and_by_file(tmp_path) -> None:  # type: ignore[no-untyped-def]
    (tmp_path / "drawn.vox").write_bytes(write_vox(library_structure("dam")))
    assert read_structure(str(tmp_path / "drawn.vox")).heights == library_structure("dam").heights
    assert read_structure("dam") == library_structure("dam")
    with pytest.raises(ConstructionError, match=r"nowhere: neither a file \*\.npy, \*\.txt, \*\.vox nor one of"):
        read_structure("nowhere")
    with pytest.raises(ConstructionError, match="cannot be read: No such file"):
        read_structure(str(tmp_path / "none.txt"))


def test_a_byte_order_mark_before_level_maps_is_passed_over(tmp_path: Path) -> None:
    drawing = tmp_path / "marked.txt"
    drawing.write_bytes(b"\xef\xbb\xbf" + b"##\r\n.#\r\n")
    assert read_structure(str(drawing)).heights == ((0, 1), (1, 1))


def test_a_drawing_with_a_name_of_two_lines_is_told_in_one(tmp_path: Path) -> None:
    drawing = tmp_path / "two\nlines.txt"
    with pytest.raises(ConstructionError, match=r"two\?lines\.txt: cannot be read"):
        read_structure(str(drawing))
    drawing.write_text("#")
    assert read_structure(str(drawing)).name == "two?lines.txt"
