"""Catkin workspaces: whether a folder is one, and what makes it one."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Dict, Mapping, NamedTuple, Optional

__all__ = ["Workspace", "find_toplevel", "look_at_workspace"]

_TOPLEVEL = Path("share", "catkin", "cmake", "toplevel.cmake")


class Workspace(NamedTuple):
    """A folder as a catkin workspace.

    Attributes:
        folder: absolute.
        exists: True if it is one already.
        toplevel: what its src/CMakeLists.txt links to; None if it is one already, or without catkin.
    """

    folder: Path
    exists: bool
    toplevel: Optional[Path] = None

    @property
    def links(self) -> Dict[Path, Path]:
        """The link that makes a folder a workspace, as catkin_init_workspace makes it."""
        return {} if self.toplevel is None else {self.folder / "src" / "CMakeLists.txt": self.toplevel}


def look_at_workspace(folder: Path, environ: Mapping[str, str]) -> Workspace:
    """Look what there is, and what is missing.

    Args:
        folder: that is, or shall become, a workspace.
        environ: the environment; ``CMAKE_PREFIX_PATH`` says where catkin may be.
    """
    folder = Path(os.path.abspath(folder))  # noqa: PTH100 - resolve() would follow links
    initialised = (folder / "src" / "CMakeLists.txt").exists() or (folder / ".catkin_tools").is_dir()
    return Workspace(folder, True) if initialised else Workspace(folder, False, find_toplevel(environ))


def find_toplevel(environ: Mapping[str, str]) -> Optional[Path]:
    """Find catkin's toplevel.cmake, that of the environment first; None without catkin."""
    prefixes = [Path(each) for each in environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if each]
    found = (prefix / _TOPLEVEL for prefix in [*prefixes, Path("/usr")])
    return next((path for path in found if path.is_file()), None)
