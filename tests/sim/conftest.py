"""Fixtures of the sim room."""

from __future__ import annotations

from typing import Iterator

import pytest

from rqt_mrta_py.hooks import World
from tests.sim.worlds import WORLDS


@pytest.fixture(params=sorted(WORLDS))
def world_name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def world(world_name: str) -> Iterator[World]:
    """Give each world in turn, not yet built."""
    built = WORLDS[world_name]()
    yield built
    built.close()
