"""States speak the numbers of messages."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rqt_mrta_py.model import Progress

DEFINED = re.findall(
    r"^uint8 (\w+)=(\d+)$",
    (Path(__file__).resolve().parents[2] / "msg" / "TaskProgress.msg").read_text(encoding="utf-8"),
    re.MULTILINE,
)


def test_every_progress_has_its_constant_in_the_message() -> None:
    assert {progress.name: progress.code for progress in Progress} == {name: int(code) for name, code in DEFINED}


@pytest.mark.parametrize(("name", "code"), DEFINED)
def test_a_constant_of_the_message_is_read_as_its_progress(name: str, code: str) -> None:
    assert Progress.of_code(int(code)) is Progress[name]


@pytest.mark.parametrize("code", [-1, len(DEFINED), 255])
def test_a_number_that_nobody_has_defined_is_no_progress(code: int) -> None:
    assert Progress.of_code(code) is None
