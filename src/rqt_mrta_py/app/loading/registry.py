"""Which packages take part, as this process's environment has it."""

from __future__ import annotations

import os

from rqt_mrta_py.config.discovery.registration import Registry
from rqt_mrta_py.config.discovery.search import discover

__all__ = ["registry_only"]


def registry_only() -> Registry:
    """Look for packages without importing any plugin's code."""
    return discover(os.environ)
