from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from rqt_mrta_py.errors import MissingDependencyError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter, Compression, RosCodec, read_bag, rosbags_door
from tests.transport.support import ROOT, connection


@pytest.fixture
def _without_rosbags(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("rosbags", "rosbags.rosbag1", "rosbags.typesys"):
        monkeypatch.setitem(sys.modules, name, None)
    monkeypatch.setattr(rosbags_door, "_noetic_store", rosbags_door._noetic_store.__wrapped__)


@pytest.mark.usefixtures("_without_rosbags")
def test_standard_types_say_what_to_install_where_rosbags_is_missing() -> None:
    with pytest.raises(MissingDependencyError, match=r"install it with: pip install 'rqt_mrta_py\[bag\]'"):
        RosCodec({}.get).connection("/s", "std_msgs/String")


@pytest.mark.usefixtures("_without_rosbags")
def test_bags_are_written_and_read_without_rosbags(tmp_path: Path) -> None:
    stamped = Stamped(connection("/t", "x/Y", "uint8 a"), 5, b"\7")
    with BagWriter(tmp_path / "x.bag", Compression.NONE) as bag:
        bag.write(stamped)
    assert list(read_bag(tmp_path / "x.bag")) == [stamped]


@pytest.mark.usefixtures("_without_rosbags")
def test_messages_of_strangers_are_read_without_rosbags() -> None:
    assert RosCodec({}.get).compile(connection("/t", "x/Y", "uint8 a"), ("a",))(b"\7") == (7,)


def test_importing_the_room_imports_neither_rosbags_nor_ros() -> None:
    script = (
        "import sys, rqt_mrta_py.transport\n"
        "print([name for name in ('rosbags', 'lz4', 'rospy', 'genpy') if name in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        check=True,
        capture_output=True,
        text=True,
        env={"PYTHONPATH": str(ROOT / "src")},
        timeout=60,
    )
    assert done.stdout.strip() == "[]"
