"""Experiments with DEMiR-CF.

* ``point_team``: agents that move as points and hear one another over a radio that loses messages
"""

from __future__ import annotations
