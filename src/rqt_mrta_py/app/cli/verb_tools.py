"""What verbs of plugins can make use of."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Any, Callable, List, Mapping, Union

from rqt_mrta_py.app.guard import checked_drawing, checked_figures
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.hooks import Drawing, Figure, VerbFolder
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.render.drawings import drawing_png
from rqt_mrta_py.render.figures import figure_png

__all__ = ["HostTools"]


class _Folder:
    """A folder that one verb leaves."""

    def __init__(self, who: str, folder: OutputFolder) -> None:
        self._who = who
        self._folder = folder

    def write(self, name: str, content: Union[str, bytes]) -> None:
        """Write a file, whole or not at all."""
        if isinstance(content, str):
            self._folder.write_text(name, content)
        else:
            self._folder.write_bytes(name, content)

    def draw(self, picture: Union[Figure, Drawing]) -> None:
        """Draw a figure or drawing to a file of its name."""
        if isinstance(picture, Drawing):
            drawing = checked_drawing(self._who, picture)
            self._folder.write_bytes(f"{drawing.name}.png", drawing_png(drawing))
            return
        (figure,) = checked_figures(self._who, (picture,))
        self._folder.write_bytes(f"{figure.name}.png", figure_png(figure))


class HostTools:
    """The tools of one verb.

    Args:
        who: names the verb.
        manager: plugins, loaded.
        progress: shows what is done of what is planned [%].
    """

    def __init__(self, who: str, manager: PluginManager, progress: Callable[[float, float], None]) -> None:
        self._who = who
        self._manager = manager
        self._progress = progress
        self._made: List[Path] = []

    def registered(self, hook: str) -> Mapping[str, Any]:
        """Give what all plugins register by one hook."""
        return self._manager.registered(hook)

    def folder(self, path: Path, *, force: bool = False) -> VerbFolder:
        """Make a folder for what the verb leaves."""
        is_new = not Path(path).exists()
        folder = OutputFolder.create(Path(path), "", force)
        if is_new:
            self._made.append(folder.path)
        return _Folder(self._who, folder)

    def take_back(self) -> None:
        """Remove folders that were made and hold nothing, for the verb has failed before it left anything."""
        for path in self._made:
            # What is in use, or holds anything, stays.
            with contextlib.suppress(OSError):
                path.rmdir()

    def progress(self, share: float) -> None:
        """Show which part of the work is done."""
        self._progress(100.0 * share, 100.0)
