"""Figures that runs and reviews leave, as their makers give them."""

from __future__ import annotations

import logging
from typing import Dict, Mapping, Sequence, Tuple

from rqt_mrta_py.app.guard import GuardedFigureMaker, made
from rqt_mrta_py.app.outputs.asked_for import asked_for
from rqt_mrta_py.app.outputs.folder import OutputFolder, safe_file_name
from rqt_mrta_py.hooks import Figure, FigureMaker, FigureMakerFactory, FigureSetup
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission, MissionRecord
from rqt_mrta_py.render.figures import figure_png, require_figures

__all__ = ["figure_makers_for", "figures_of", "write_figures"]

_log = logging.getLogger("rqt_mrta_py.app")


def figure_makers_for(mission: Mission, names: Sequence[str], manager: PluginManager) -> Dict[str, FigureMaker]:
    """Make the makers of figures that the user asks for.

    Args:
        mission: as far as it is known.
        names: of makers; one named twice counts once.
        manager: plugins, loaded.

    Returns:
        By name, in the order given.

    Raises:
        UsageError: there are no such figures.
        HookError: a maker cannot be made; names it.
        MissingDependencyError: figures cannot be drawn here.
    """
    if not names:
        return {}
    factories: Mapping[str, FigureMakerFactory] = manager.registered("mrta_register_figures")
    chosen = asked_for("--figures", "there are no such figures", names, factories)
    require_figures()
    setup = FigureSetup(mission)
    needs = ("subscriptions", "hear", "figures")
    return {name: GuardedFigureMaker(name, made(f"figures {name}", factories[name], setup, *needs)) for name in chosen}


def figures_of(makers: Mapping[str, FigureMaker], record: MissionRecord) -> Dict[str, Tuple[Figure, ...]]:
    """Ask makers for their figures.

    Args:
        makers: by name, all messages heard.
        record: everything known of the mission.

    Raises:
        HookError: one raises, or gives what cannot be drawn; names it.
    """
    asked = {name: tuple(maker.figures(record)) for name, maker in makers.items()}
    for name, figures in asked.items():
        if not figures:
            _log.warning("figures=%s nothing heard of what they show, so there are none", name)
    return asked


def write_figures(folder: OutputFolder, figures: Mapping[str, Sequence[Figure]]) -> None:
    """Draw figures to ``figures/<name of their maker>/<name>.png``.

    Args:
        folder: of the outputs.
        figures: by the name of their maker.

    Raises:
        RenderError: one has too many charts.
        OutputError: a file cannot be written.
    """
    for name, each in figures.items():
        for figure in each:
            folder.write_bytes(f"figures/{safe_file_name(name)}/{figure.name}.png", figure_png(figure))
