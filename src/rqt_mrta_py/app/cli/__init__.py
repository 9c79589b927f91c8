"""The command ``mrta``: one verb to a file, each with ``add_arguments`` and ``main``."""

from __future__ import annotations
