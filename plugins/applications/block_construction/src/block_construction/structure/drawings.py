"""Structures as files: reading one of any of the three forms, or one that comes with the package, and writing all."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict, Mapping, Union

from block_construction.documents import bounded_bytes, one_line
from block_construction.errors import ConstructionError
from block_construction.structure.level_maps import read_level_maps, write_level_maps
from block_construction.structure.library import library_structure, structure_names
from block_construction.structure.npy_file import read_npy, write_npy
from block_construction.structure.vox_file import LONGEST_SIDE, read_vox, write_vox
from rqt_mrta_py.hooks import Structure

__all__ = ["MOST_BYTES", "read_structure", "structure_files"]

MOST_BYTES = 32_000_000
"""A drawing may have so many bytes."""
_MARK = "\ufeff"
"""Some editors begin a text with it, to say that it is UTF-8."""


def _read_text(name: str, content: bytes) -> Structure:
    try:
        return read_level_maps(name, content.decode("utf-8").lstrip(_MARK))
    except UnicodeDecodeError as error:
        raise ConstructionError(f"{name}: byte {error.start} is not UTF-8; level maps are text") from error


_READERS: Mapping[str, Callable[[str, bytes], Structure]] = {".npy": read_npy, ".txt": _read_text, ".vox": read_vox}


def read_structure(given: str) -> Structure:
    """Read a structure.

    Args:
        given: the name of one that comes with the package, or a path to a ``.vox``, ``.npy`` or ``.txt`` file.

    Raises:
        ConstructionError: there is no such structure, or it cannot be read; says what is accepted.
    """
    if given in structure_names():
        return library_structure(given)
    path = Path(given)
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        known = ", ".join(structure_names())
        raise ConstructionError(
            f"{one_line(given)}: neither a file *{', *'.join(_READERS)} nor one of the structures {known}"
        )
    return reader(one_line(path.name), bounded_bytes(path, MOST_BYTES))


def structure_files(structure: Structure) -> Mapping[str, Union[str, bytes]]:
    """Write a structure in all forms: content by the file's name.

    ``.vox`` is left out where a side is too long for it.
    """
    files: Dict[str, Union[str, bytes]] = {
        "structure.npy": write_npy(structure),
        "structure.txt": write_level_maps(structure),
    }
    if max(structure.columns, structure.rows, structure.levels) <= LONGEST_SIDE:
        files["structure.vox"] = write_vox(structure)
    return files
