from __future__ import annotations

import pytest

from rqt_mrta_py.model import normalise_id, wire_id


@pytest.mark.parametrize(
    ("text", "normalised", "on_the_wire"),
    [("/robot1", "robot1", "/robot1"), ("robot1", "robot1", "/robot1"), ("//r", "/r", "//r"), ("", "", "/")],
)
def test_ids_lose_one_slash_and_gain_one(text: str, normalised: str, on_the_wire: str) -> None:
    assert normalise_id(text) == normalised
    assert wire_id(text) == on_the_wire
