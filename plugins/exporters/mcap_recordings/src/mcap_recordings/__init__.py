"""Missions as MCAP files.

* ``exporter``: a stream to one file
* ``plugin``: the hook
"""

from __future__ import annotations
