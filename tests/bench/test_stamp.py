"""How the stamp of a set-up is measured."""

from __future__ import annotations

import pytest

from bench.stamp import measure_stamp
from tests.bootstrap.conftest import Miniature, miniature

__all__ = ["miniature"]


def test_a_stamp_is_looked_at_without_setting_anything_up(miniature: Miniature) -> None:
    miniature.run("list")
    row = measure_stamp(miniature.folder, turns=2)
    assert miniature.set_ups() == ["run all"]
    assert row.stamp > row.bash > 0
    assert row.ratio == pytest.approx(row.stamp / row.bash)


def test_a_checkout_that_is_not_set_up_is_refused(miniature: Miniature) -> None:
    with pytest.raises(RuntimeError, match="is not set up"):
        measure_stamp(miniature.folder, turns=1)
    assert miniature.set_ups() == []
