"""Fixtures and options for the whole suite."""

from __future__ import annotations

import gc
import importlib
import os
import sys
from pathlib import Path
from typing import Callable, List

import pytest
from hypothesis import settings

ROOT = Path(__file__).resolve().parent.parent
SHARED_DATA = ROOT.parent / "shared" / "data"

# Plugins are ROS packages: their Python folders are on no path until the host appends them.
for source in sorted((ROOT / "plugins").glob("*/*/src")):
    if str(source) not in sys.path:
        sys.path.append(str(source))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--long", action="store_true", help="run the long campaigns too")


def pytest_configure(config: pytest.Config) -> None:
    # A machine that is busy is no reason to fail.
    settings.register_profile("patient", deadline=None)
    # For properties that do not say themselves how many examples they need.
    settings.register_profile("long", deadline=None, max_examples=400)
    settings.load_profile("long" if config.getoption("--long") else "patient")
    if not config.getoption("--long"):
        # Compiling takes a minute; what would be compiled gives the same numbers as it stands.
        os.environ["NUMBA_DISABLE_JIT"] = "1"


def pytest_collection_modifyitems(config: pytest.Config, items: List[pytest.Item]) -> None:
    if config.getoption("--long"):
        return
    skip = pytest.mark.skip(reason="a long campaign; ./test --long runs it")
    for item in items:
        if item.get_closest_marker("long"):
            item.add_marker(skip)


def pytest_collection_finish() -> None:
    # What collecting tests leaves in memory is looked through by every full collection of garbage, of which each
    # mission makes some, unless it is set apart.
    gc.collect()
    gc.freeze()


@pytest.fixture
def root() -> Path:
    """Give the root of the checkout."""
    return ROOT


@pytest.fixture
def shared_data() -> Callable[[str], Path]:
    """Find recorded data that is not part of the repository; skip the test where it is missing."""

    def find(name: str) -> Path:
        path = SHARED_DATA / name
        if not path.exists():
            pytest.skip(f"recorded data {name} is not on this machine")
        return path

    return find


def require_module(name: str) -> object:
    """Import a module that a test needs, or skip the test naming it."""
    try:
        return importlib.import_module(name)
    except ImportError:
        pytest.skip(f"{name} is not installed")
