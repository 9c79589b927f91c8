"""Packages that are wrong in one way each, and the one thing said of each; sound ones, of which nothing is said."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Dict

import pytest
import yaml

from tests.app.doctor.corpus import broken, told
from tests.app.outputs import Mrta

DATA = Path(__file__).resolve().parents[2] / "data"
TOLD: Dict[str, str] = yaml.safe_load((DATA / "bad" / "expected.yaml").read_text(encoding="utf-8"))
SOUND = sorted(path.name for path in (DATA / "sound").iterdir() if path.is_dir())


def test_bad_files_are_all_in_the_table() -> None:
    found = {path.name for path in (DATA / "bad").iterdir() if path.name != "expected.yaml"}

    assert found == set(TOLD)


def test_corpus_is_large_enough() -> None:
    assert len(TOLD) >= 60
    assert len(SOUND) >= 8


@pytest.mark.parametrize("name", sorted(name for name in TOLD if not name.startswith("answers_")))
def test_doctor_tells_what_is_wrong_once_and_nothing_else(name: str, tmp_path: Path) -> None:
    package = broken(DATA / "bad" / name, DATA / "sound", tmp_path / "workspace")

    assert told(package) == [TOLD[name]]


@pytest.mark.parametrize("name", sorted(name for name in TOLD if name.startswith("answers_")))
def test_new_tells_what_is_wrong_with_answers_and_writes_nothing(name: str, mrta: Mrta) -> None:
    """Answers are no part of a package: who asks for them tells of them."""
    shutil.copyfile(str(DATA / "bad" / name), "answers.yaml")

    assert mrta("new", "application", "--answers", "answers.yaml", "--yes") == (3, [f"mrta: {TOLD[name]}"])
    assert [path.name for path in Path().iterdir()] == ["answers.yaml"]


@pytest.mark.parametrize("name", SOUND)
def test_doctor_says_nothing_of_a_sound_package(name: str) -> None:
    assert told(DATA / "sound" / name) == []
