"""What the collector of garbage looks at during a mission, and after it."""

from __future__ import annotations

import gc
from typing import Iterator

import pytest

from rqt_mrta_py.app.run.collector import rare_collections


@pytest.fixture
def nothing_set_apart() -> Iterator[None]:
    """Undo what the suite has set apart, for one test."""
    gc.unfreeze()
    yield
    gc.collect()
    gc.freeze()


@pytest.mark.usefixtures("nothing_set_apart")
def test_what_is_there_is_set_apart_for_the_mission_only() -> None:
    before = gc.get_threshold()
    with rare_collections():
        assert gc.get_freeze_count() > 10_000
        assert gc.get_threshold() != before
    assert (gc.get_freeze_count(), gc.get_threshold()) == (0, before)


@pytest.mark.usefixtures("nothing_set_apart")
def test_what_the_caller_has_set_apart_stays_so() -> None:
    gc.freeze()
    before = gc.get_freeze_count()
    with rare_collections():
        assert gc.get_freeze_count() == before
    assert gc.get_freeze_count() == before


@pytest.mark.usefixtures("nothing_set_apart")
def test_a_mission_that_fails_leaves_the_collector_as_it_was() -> None:
    before = gc.get_threshold()
    with pytest.raises(ValueError, match="no"), rare_collections():
        raise ValueError("no")
    assert (gc.get_freeze_count(), gc.get_threshold()) == (0, before)
