"""The plugins within this package: its rooms register what they bring through the hooks that everybody uses."""

from __future__ import annotations

__all__ = ["OWN_PACKAGE", "OWN_PLUGINS"]

OWN_PACKAGE = "rqt_mrta_py"

OWN_PLUGINS = (
    "rqt_mrta_py.sim.plugin",
    "rqt_mrta_py.supervisor.plugin",
    "rqt_mrta_py.render.plugin",
    "rqt_mrta_py.robot.plugin",
    "rqt_mrta_py.app.bench.plugin",
)
"""Modules, in the order in which they are asked: after all packages, so that a package may replace a name."""
