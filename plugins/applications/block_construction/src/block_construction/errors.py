"""What makes a structure, a diagram or a plan impossible, told in one line."""

from __future__ import annotations

from rqt_mrta_py.hooks import MrtaError

__all__ = ["ConstructionError"]


class ConstructionError(MrtaError):
    """A structure cannot be read, planned or built; says where, what was found, and what is accepted."""
