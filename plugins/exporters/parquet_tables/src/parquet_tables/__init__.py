"""Missions as Parquet files.

* ``tables``: what a mission's tables hold, column by column
* ``exporter``: the tables as files
* ``plugin``: the hook
"""

from __future__ import annotations
