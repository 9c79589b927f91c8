"""A recording beside the stream."""

from __future__ import annotations

import logging
from pathlib import Path

import pytest

from rqt_mrta_py.app.live.recording import Recording, free_bag
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import read_bag
from tests.growing_bags import written_so_far
from tests.ros_process import wait_for

NEWS = Connection("/news", "std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", "string data\n", "/somebody")


def message(number: int) -> Stamped:
    return Stamped(NEWS, 10**9 + number, b"\1\0\0\0x")


def test_everything_is_in_the_bag_in_order(tmp_path: Path) -> None:
    recording = Recording(tmp_path / "a.bag")
    for number in range(50):
        recording.take((message(number),))
    assert recording.close() == tmp_path / "a.bag"
    assert list(read_bag(tmp_path / "a.bag")) == [message(number) for number in range(50)]
    assert (recording.messages, recording.dropped, recording.backlog) == (50, 0, 0)


def test_messages_stand_in_the_file_before_the_bag_is_complete(tmp_path: Path) -> None:
    recording = Recording(tmp_path / "a.bag")
    recording.take((message(1), message(2)))
    active = tmp_path / "a.bag.active"
    wait_for(lambda: written_so_far(active) == [message(1), message(2)])
    recording.close()


def test_recording_of_a_full_disk_ends_and_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    recording = Recording(tmp_path / "a.bag")

    def refuse() -> None:
        raise TransportError("a.bag.active: cannot be written: No space left on device")

    monkeypatch.setattr(recording._bag, "checkpoint", refuse)
    with caplog.at_level(logging.ERROR):
        recording.take((message(1),))
        wait_for(lambda: recording.failure)
    recording.take((message(2),))
    assert recording.dropped == 1
    assert recording.close() is None
    assert "No space left on device" in caplog.text


def test_bag_takes_nobodys_place(tmp_path: Path) -> None:
    wanted = tmp_path / "bags" / "a.bag"
    assert free_bag(wanted, "any") == wanted
    wanted.touch()
    assert free_bag(wanted, "any") == tmp_path / "bags" / "a-2.bag"
    (tmp_path / "bags" / "a-2.bag.active").touch()
    assert free_bag(wanted, "any") == tmp_path / "bags" / "a-3.bag"


def test_bag_in_a_folder_is_named(tmp_path: Path) -> None:
    assert free_bag(tmp_path / "new", "border/patrol") == tmp_path / "new" / "border_patrol.bag"
    (tmp_path / "taken").touch()
    with pytest.raises(TransportError, match="cannot be made"):
        free_bag(tmp_path / "taken" / "a.bag", "a")
