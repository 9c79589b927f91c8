"""The messages are those of the original: their md5 as the reference gives them."""

from __future__ import annotations

from pathlib import Path

import pytest

from rqt_mrta_py.transport import RosCodec
from tests.app.doctor.corpus import told

MD5 = {
    "Acknowledgment": "5f44ad83f433a094741911f100fc4aca",
    "Auction": "480b638b6caf5ecec02f206426bf3532",
    "Behavior": "acac8125ce273d45c9a34bd3afe3f617",
    "Bid": "81309a9ea13a3e1040a03c732704554a",
    "Contract": "87ad90621779cc60c99ef24053b2c26b",
    "Feature": "c0c1dd53a63442de691d2199231856f2",
    "Task": "c4c24ebf9aa39c599e92dcdf5b063c1b",
}


@pytest.mark.parametrize("name", MD5)
def test_a_message_is_the_originals(name: str, root: Path) -> None:
    def find(type_name: str) -> Path:
        package, _, message = type_name.partition("/")
        return root / "plugins" / "messages" / package / "msg" / f"{message}.msg"

    codec = RosCodec(
        lambda type_name: find(type_name).read_text(encoding="utf-8") if find(type_name).exists() else None
    )

    assert codec.connection("/topic", f"talmech_msgs/{name}").md5 == MD5[name]


def test_every_message_is_built(root: Path) -> None:
    package = root / "plugins" / "messages" / "talmech_msgs"

    assert sorted(path.stem for path in (package / "msg").iterdir()) == sorted(MD5)
    built = (package / "CMakeLists.txt").read_text(encoding="utf-8")
    assert all(f"\n  {name}.msg\n" in built for name in MD5)


def test_the_architecture_is_sound_and_holds_no_code(root: Path) -> None:
    package = root / "plugins" / "architectures" / "talmech_auction"

    assert told(package) == []
    assert sorted(path.name for path in package.iterdir()) == ["CMakeLists.txt", "package.xml", "rqt_mrta.xml"]
