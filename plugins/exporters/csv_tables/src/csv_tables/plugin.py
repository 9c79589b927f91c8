"""The hooks: exporter ``csv``, verb ``tabulate``."""

from __future__ import annotations

from typing import Mapping

from csv_tables.exporter import CsvExporter
from csv_tables.tabulate import TABULATE
from rqt_mrta_py.hooks import ExporterFactory, Verb, hookimpl

__all__ = ["mrta_register_exporters", "mrta_register_verbs"]


@hookimpl
def mrta_register_exporters() -> Mapping[str, ExporterFactory]:
    """Name the exporter."""
    return {"csv": CsvExporter}


@hookimpl
def mrta_register_verbs() -> Mapping[str, Verb]:
    """Name the verb."""
    return {"tabulate": TABULATE}
