"""The hook: exporter ``parquet``."""

from __future__ import annotations

from typing import Mapping

from parquet_tables.exporter import ParquetExporter
from rqt_mrta_py.hooks import ExporterFactory, hookimpl

__all__ = ["mrta_register_exporters"]


@hookimpl
def mrta_register_exporters() -> Mapping[str, ExporterFactory]:
    """Name the exporter."""
    return {"parquet": ParquetExporter}
