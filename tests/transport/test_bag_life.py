"""A bag from its first message to its end, whatever that is."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport import BagWriter, read_bag, read_bag_info
from rqt_mrta_py.transport.bags import writer as bag_writer
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk
from tests.transport.recordings import mission, names


def test_a_bag_is_active_until_it_is_closed(tmp_path: Path) -> None:
    writer = BagWriter(tmp_path / "m.bag")
    assert names(tmp_path) == ["m.bag.active"]
    writer.close()
    writer.close()
    assert names(tmp_path) == ["m.bag"]
    assert read_bag_info(tmp_path / "m.bag").messages == 0
    with pytest.raises(TransportError, match="is closed; a message of /mrta/mission came too late"):
        writer.write(mission(0)[0])


def test_the_index_is_complete_when_the_body_raises(tmp_path: Path) -> None:
    stream = mission(50)

    def record() -> None:
        with BagWriter(tmp_path / "m.bag") as writer:
            for stamped in stream:
                writer.write(stamped)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        record()
    assert list(read_bag(tmp_path / "m.bag")) == stream


@pytest.mark.parametrize("step", ["build_chunk", "compress", "chunk_info"])
def test_a_chunk_that_is_interrupted_is_written_once_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    """The last of the steps comes when the chunk stands in the file already."""
    stream = mission(10)

    def interrupted(*arguments: Any) -> None:
        raise KeyboardInterrupt

    with BagWriter(tmp_path / "m.bag") as writer:
        for stamped in stream[:8]:
            writer.write(stamped)
        with monkeypatch.context() as patch:
            patch.setattr(bag_writer, step, interrupted)
            with pytest.raises(KeyboardInterrupt):
                writer.checkpoint()
        for stamped in stream[8:]:
            writer.write(stamped)
    assert list(read_bag(tmp_path / "m.bag")) == stream
    assert list(ChunkWalk(tmp_path / "m.bag")) == stream


def test_a_bag_that_may_be_replaced_stays_until_the_new_one_is_complete(tmp_path: Path) -> None:
    path = tmp_path / "mission.bag"
    path.write_bytes(b"precious")
    path.with_name("mission.bag.active").write_bytes(b"left by a killed run")
    stream = mission(30)
    with BagWriter(path, replace=True) as bag:
        for stamped in stream:
            bag.write(stamped)
        assert path.read_bytes() == b"precious"
    assert len(list(read_bag(path))) == len(stream)
    assert [entry.name for entry in tmp_path.iterdir()] == ["mission.bag"]


def test_a_bag_that_is_given_up_leaves_nothing_and_what_it_was_to_replace(tmp_path: Path) -> None:
    (tmp_path / "m.bag").write_bytes(b"old")
    with BagWriter(tmp_path / "m.bag", replace=True) as writer:
        for stamped in mission(50):
            writer.write(stamped)
        writer.discard()
    assert names(tmp_path) == ["m.bag"]
    assert (tmp_path / "m.bag").read_bytes() == b"old"
    with pytest.raises(TransportError, match="is closed"):
        writer.write(mission(1)[0])


def test_giving_up_a_complete_bag_leaves_it(tmp_path: Path) -> None:
    with BagWriter(tmp_path / "m.bag") as writer:
        writer.write(mission(1)[0])
    writer.discard()
    assert list(read_bag(tmp_path / "m.bag")) == mission(1)[:1]


def test_an_existing_bag_is_never_overwritten(tmp_path: Path) -> None:
    (tmp_path / "m.bag").write_bytes(b"precious")
    with pytest.raises(TransportError, match=r"m\.bag: exists already; choose another name or remove it"):
        BagWriter(tmp_path / "m.bag")
    (tmp_path / "n.bag.active").write_bytes(b"precious")
    with pytest.raises(
        TransportError, match=r"n\.bag\.active: cannot be written: exists already; a recording of this name"
    ):
        BagWriter(tmp_path / "n.bag")
    with pytest.raises(TransportError, match="cannot be written"):
        BagWriter(tmp_path / "missing" / "m.bag")
