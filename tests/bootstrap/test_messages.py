"""Message classes as genpy makes them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import List

import pytest

from bootstrap import messages

GENERATOR = Path(messages.__file__).with_name("generate.py")


def package(folder: Path, name: str, **definitions: str) -> List[str]:
    (folder / "msg").mkdir(parents=True)
    (folder / "package.xml").write_text(f"<package><name>{name}</name></package>", encoding="utf-8")
    for definition, text in definitions.items():
        (folder / "msg" / f"{definition}.msg").write_text(text, encoding="utf-8")
    return [str(path) for path in sorted((folder / "msg").iterdir())]


def generate(out: Path, files: List[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, str(GENERATOR), str(out), *files], capture_output=True, text=True, check=False
    )


def test_definitions_of_the_main_package_and_of_plugins_are_found(tmp_path: Path) -> None:
    main = package(tmp_path, "rqt_mrta_py", Event="string text\n")
    other = package(tmp_path / "plugins/messages/other_msgs", "other_msgs", Bid="float64 cost\n")
    app = package(tmp_path / "plugins/applications/app", "app", Progress="string text\n")
    package(tmp_path / "elsewhere/app", "elsewhere", Unasked="string text\n")
    (tmp_path / "msg/README.md").write_text("not a definition", encoding="utf-8")
    assert [str(path) for path in messages.message_files(tmp_path)] == [*main, *app, *other]


@pytest.mark.ros
def test_classes_carry_the_md5_of_their_definition(tmp_path: Path) -> None:
    pytest.importorskip("genpy")
    files = package(tmp_path / "one", "one_msgs", Bid="float64 cost\n", Bids="Bid[] bids\n")
    files += package(tmp_path / "a folder", "two_msgs", Offer="one_msgs/Bid bid\nstring from\n")
    result = generate(tmp_path / "out", files)
    assert result.returncode == 0, result.stderr
    question = "import one_msgs.msg as o, two_msgs.msg as t; print(o.Bid._md5sum, o.Bids().bids, t.Offer().bid.cost)"
    answer = subprocess.run(
        [sys.executable, "-c", question],
        env={"PYTHONPATH": str(tmp_path / "out")},
        capture_output=True,
        text=True,
        check=True,
    )
    # printf 'float64 cost' | md5sum
    assert answer.stdout == "bff9a2439f6a3b435a395e2c861c4c14 [] 0.0\n"


@pytest.mark.ros
def test_a_definition_that_cannot_be_understood_is_named(tmp_path: Path) -> None:
    pytest.importorskip("genpy")
    result = generate(tmp_path / "out", package(tmp_path / "one", "one_msgs", Bid="no_such_msgs/Thing thing\n"))
    assert result.returncode == 1
    assert "Bid.msg" in result.stderr


@pytest.mark.ros
def test_a_package_of_the_users_own_goes_before_the_generated_one(tmp_path: Path) -> None:
    pytest.importorskip("genpy")
    assert generate(tmp_path / "out", package(tmp_path / "one", "one_msgs", Bid="float64 cost\n")).returncode == 0
    own = tmp_path / "own/one_msgs/msg"
    own.mkdir(parents=True)
    (own.parent / "__init__.py").touch()
    (own / "__init__.py").write_text("Bid = 'the user\\'s'\n", encoding="utf-8")
    search = f"{tmp_path}/out:{tmp_path}/own"
    question = "import one_msgs.msg; print(one_msgs.msg.Bid)"
    answer = subprocess.run(
        [sys.executable, "-c", question], env={"PYTHONPATH": search}, capture_output=True, text=True, check=True
    )
    assert answer.stdout == "the user's\n"
