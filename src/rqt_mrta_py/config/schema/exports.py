"""What a package.xml exports to take part."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Tuple

__all__ = ["EXPORTS", "ExportForm"]


@dataclass(frozen=True)
class ExportForm:
    """One attribute of the export tag.

    Attributes:
        name: as written.
        value: what it holds.
        summary: one sentence.
        ours: True if the original does not know it.
    """

    name: str
    value: str
    summary: str
    ours: bool = True


EXPORTS: Tuple[ExportForm, ...] = (
    ExportForm("architecture", "a file", "The package is an architecture; its rqt_mrta.xml.", ours=False),
    ExportForm("application", "a file", "The package is an application; its rqt_mrta.xml.", ours=False),
    ExportForm("plugin", "a dotted module", "The package implements hooks, in this module."),
    ExportForm("tasks", "a file", "The tasks.yaml of the application."),
    ExportForm("scenario", "a file", "The scenario.yaml of the application, if it can be simulated."),
)
"""In the order of the documentation."""
