from __future__ import annotations

from typing import Collection, Optional, Tuple

import pytest

from rqt_mrta_py.model import Task
from rqt_mrta_py.robot.charges import lacking_capabilities, undone_predecessors


@pytest.mark.parametrize(
    ("asked", "has", "lacking"),
    [
        ((), frozenset(), ()),
        (("arm", "lamp"), frozenset({"lamp", "arm", "wheels"}), ()),
        (("wheels", "lamp", "arm"), frozenset({"lamp"}), ("wheels", "arm")),
        (("arm",), None, ()),
    ],
)
def test_robot_lacks_what_a_task_asks_for_and_it_cannot_do(
    asked: Tuple[str, ...], has: Optional[Collection[str]], lacking: Tuple[str, ...]
) -> None:
    assert lacking_capabilities(Task("a", "go", capabilities=asked), has) == lacking


@pytest.mark.parametrize(
    ("before", "done", "undone"),
    [((), set(), ()), (("b", "c"), {"c", "b", "d"}, ()), (("d", "b", "c"), {"b"}, ("d", "c"))],
)
def test_task_waits_for_the_predecessors_that_are_not_done(
    before: Tuple[str, ...], done: Collection[str], undone: Tuple[str, ...]
) -> None:
    assert undone_predecessors(Task("a", "go", predecessors=before), done) == undone
