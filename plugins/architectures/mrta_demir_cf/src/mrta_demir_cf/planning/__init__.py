"""Rough schedules, cost functions and incremental selection: arrays in, choices out."""

from __future__ import annotations
