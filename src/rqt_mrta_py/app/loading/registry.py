"""Which packages take part, as this process's environment has it."""

from __future__ import annotations

import os

from rqt_mrta_py.config import Registry, discover

__all__ = ["registry_only"]


def registry_only() -> Registry:
    """Look for packages without importing any plugin's code."""
    return discover(os.environ)
