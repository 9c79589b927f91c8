"""Layers that a config of the whole team lists for tasks, as the package alliance has it."""

from __future__ import annotations

from typing import Sequence, Tuple

import pytest

from rqt_mrta_py.config.parameters.task_layers import with_layers
from rqt_mrta_py.model import Task

KINDS = ("avoid", "follow", "wander")


@pytest.mark.parametrize(
    ("kind", "listed", "expected"),
    [
        # Its own kind is the lowest layer, listed or not.
        ("wander", ["wander", "avoid"], ("wander", ("avoid",))),
        ("wander", ["follow", "avoid"], ("wander", ("follow", "avoid"))),
        # A kind that is no behaviour, such as the id of a task without a tasks.yaml.
        ("border_protection", ["follow", "avoid"], ("follow", ("avoid",))),
        ("border_protection", ["follow"], ("follow", ())),
        # Names as pluginlib has them.
        ("border_protection", ["alliance_test/follow", "other/avoid"], ("follow", ("avoid",))),
        ("wander", [], ("wander", ())),
        # Nobody provides it: named as it stands, so that whoever looks for it can say so.
        ("border_protection", ["alliance_test/fly"], ("alliance_test/fly", ())),
    ],
)
def test_the_first_layer_listed_is_the_lowest(
    kind: str, listed: Sequence[str], expected: Tuple[str, Tuple[str, ...]]
) -> None:
    task = with_layers(Task("t", kind), listed, KINDS)
    assert (task.kind, task.layers) == expected


def test_a_name_with_a_slash_may_be_a_kind_itself() -> None:
    assert with_layers(Task("t", "t"), ["p/avoid"], ("avoid", "p/avoid")).kind == "p/avoid"


def test_what_the_task_itself_says_comes_first() -> None:
    task = Task("t", "wander", layers=("avoid",))
    assert with_layers(task, ["follow"], KINDS) == task
