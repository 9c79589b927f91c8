"""A package's folder that is there whole or not at all."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import List, Mapping, Tuple

from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["build_package", "listing"]


def listing(files: Mapping[str, str]) -> Tuple[str, ...]:
    """List files and folders of a package, sorted; folders end in a slash."""
    folders = {f"{parent.as_posix()}/" for path in files for parent in Path(path).parents if parent.name}
    return tuple(sorted({*files, *folders}))


def build_package(folder: Path, files: Mapping[str, str], links: Mapping[Path, Path]) -> None:
    """Make a package: written in a folder beside, then renamed.

    Args:
        folder: of the package, which must not exist; folders above are made where they are missing.
        files: text by path relative to it.
        links: symbolic links that are made too, target by path; such as that of a workspace.

    Raises:
        ConfigError: it exists, or cannot be written; everything is as it was before.
    """
    made: List[Path] = []
    path = folder
    try:
        _make_folders(folder.parent, made)
        with tempfile.TemporaryDirectory(prefix=f".{folder.name}.", dir=folder.parent) as aside:
            package = Path(aside) / folder.name
            for name, text in files.items():
                path = folder / name
                (package / name).parent.mkdir(parents=True, exist_ok=True)
                (package / name).write_bytes(text.encode("utf-8"))
            for path, target in links.items():
                path.symlink_to(target)
                made.append(path)
            path = folder
            if folder.exists() or folder.is_symlink():
                raise FileExistsError
            package.rename(folder)
    except BaseException as error:
        for each in reversed(made):
            _remove(each)
        if isinstance(error, FileExistsError) and path == folder:
            message = f"The given package [{folder.name}] already exists."
            raise ConfigError([Problem(str(folder), 0, "", message)]) from error
        if isinstance(error, OSError):
            message = f"cannot be written: {error.strerror or error}; nothing was changed"
            raise ConfigError([Problem(str(path), 0, "", message)]) from error
        raise


def _make_folders(folder: Path, made: List[Path]) -> None:
    """Make a folder and those above; notes those that were not there."""
    missing = []
    while not os.path.lexists(folder):
        missing.append(folder)
        folder = folder.parent
    for each in reversed(missing):
        try:
            each.mkdir()
        except FileExistsError:
            # Somebody made it just now, such as another package's maker.
            continue
        made.append(each)


def _remove(path: Path) -> None:
    try:
        if path.is_symlink():
            path.unlink()
        else:
            path.rmdir()
    except OSError:
        # Somebody put something into it meanwhile.
        pass
