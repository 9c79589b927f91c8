"""Exporters of messages: what they are handed, and what is left when they fail."""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO, Callable, Iterator, List, Tuple

import pytest

from rqt_mrta_py.app.guard import GuardedExporter, GuardedMessageExporter
from rqt_mrta_py.app.outputs.exports import exporters_for
from rqt_mrta_py.app.outputs.folder import OutputError, OutputFolder
from rqt_mrta_py.app.outputs.message_exports import with_news, write_message_exports
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import Connection, Exporter, ExporterSetup, Outgoing, Stamped, hookimpl
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.hooks.patience import Patience
from rqt_mrta_py.model import MissionRecord, Taxonomy
from rqt_mrta_py.transport import RosCodec
from tests.hooks.garden import MISSION

RECORD = MissionRecord("yard", None, Taxonomy(), None, 1.0, 2.0, (), (), (), (), ())
NEWS = Connection("/news", "std_msgs/String", "0" * 32, "string data\n")
CODEC = RosCodec(lambda _: None)
SECOND = 10**9


class Copy:
    """Writes down the bytes of every message; fails where it is told to."""

    def __init__(self, fails: str = "", name: str = "copy.bin") -> None:
        self.fails = fails
        self.name = name

    def begin(self, record: MissionRecord, create: Callable[[str], BinaryIO]) -> None:
        self.file = create(self.name)
        self._maybe("begin")

    def take(self, stamped: Stamped) -> None:
        self.file.write(stamped.raw)
        self._maybe("take")

    def end(self) -> None:
        self._maybe("end")

    def _maybe(self, moment: str) -> None:
        if self.fails == moment:
            raise ValueError("no more")
        if self.fails == f"{moment}: full":
            raise OSError(28, "No space left on device")


def stream(count: int = 3) -> Iterator[Stamped]:
    return (Stamped(NEWS, SECOND + number, bytes([number % 256])) for number in range(count))


def written(tmp_path: Path, *copies: Copy, count: int = 3) -> List[Tuple[str, bytes]]:
    exporters = {f"copy{number}": GuardedMessageExporter(f"copy{number}", copy) for number, copy in enumerate(copies)}
    try:
        write_message_exports(OutputFolder(tmp_path), exporters, RECORD, lambda: stream(count), Patience(0))
    finally:
        found = sorted(path for path in tmp_path.rglob("*") if path.is_file())
    return [(path.relative_to(tmp_path / "export").as_posix(), path.read_bytes()) for path in found]


def test_every_exporter_is_handed_every_message_once(tmp_path: Path) -> None:
    everything = bytes(number % 256 for number in range(2500))
    found = written(tmp_path, Copy(), Copy(name="other.bin"), count=2500)
    assert found == [("copy0/copy.bin", everything), ("copy1/other.bin", everything)]


@pytest.mark.parametrize("moment", ["begin", "take", "end"])
def test_an_exporter_that_fails_is_named_and_no_file_is_left(moment: str, tmp_path: Path) -> None:
    with pytest.raises(HookError) as caught:
        written(tmp_path, Copy(), Copy(moment))
    assert str(caught.value) == "exporter copy1: ValueError: no more"
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


def test_a_full_disk_is_told_as_such(tmp_path: Path) -> None:
    with pytest.raises(OutputError) as caught:
        written(tmp_path, Copy("take: full"))
    assert str(caught.value) == f"{tmp_path / 'export' / 'copy0'}: cannot be written: No space left on device"


@pytest.mark.parametrize("name", ["../copy.bin", "a/b", "", ".."])
def test_files_stay_in_the_exporters_folder(name: str, tmp_path: Path) -> None:
    with pytest.raises(HookError, match="is no file name"):
        written(tmp_path, Copy(name=name))


def test_an_earlier_file_stays_until_the_new_one_is_complete(tmp_path: Path) -> None:
    before = tmp_path / "export" / "copy0" / "copy.bin"
    before.parent.mkdir(parents=True)
    before.write_bytes(b"before")
    with pytest.raises(HookError):
        written(tmp_path, Copy("end"))
    assert before.read_bytes() == b"before"
    assert written(tmp_path, Copy()) == [("copy0/copy.bin", b"\x00\x01\x02")]


def test_the_stream_is_not_read_where_nobody_wants_it(tmp_path: Path) -> None:
    def read() -> Iterator[Stamped]:
        raise AssertionError("nobody asked for it")

    write_message_exports(OutputFolder(tmp_path), {}, RECORD, read, Patience(0))


class Mixed:
    """A plugin with exporters of both kinds, and what is neither."""

    @hookimpl
    def mrta_register_exporters(self) -> object:
        return {"copy": lambda setup: Copy(), "text": Text, "half": lambda setup: HalfACopy()}


class Text:
    """An exporter that hears nothing."""

    def __init__(self, setup: ExporterSetup) -> None:
        self.subscriptions = list
        self.hear = print
        self.export = dict


class HalfACopy:
    """Takes messages and cannot end."""

    def begin(self, record: MissionRecord, create: Callable[[str], BinaryIO]) -> None:
        """Begin nothing."""

    def take(self, stamped: Stamped) -> None:
        """Take nothing."""


def test_both_kinds_of_exporters_are_told_apart_by_what_they_can_do() -> None:
    manager = PluginManager()
    manager.register(Mixed(), "mixed")
    made = exporters_for(MISSION, ["copy", "text"], manager)
    kinds: List[type[Exporter]] = [type(each) for each in made.values()]
    assert kinds == [GuardedMessageExporter, GuardedExporter]
    with pytest.raises(HookError, match=r"^exporter half: made <.*HalfACopy .*, which has no 'end'$"):
        exporters_for(MISSION, ["half"], manager)


def told(topic: str, stamp: float, text: str) -> Outgoing:
    return Outgoing(topic, "rqt_mrta_py/Event", {"header": {"stamp": stamp}, "text": text})


def test_news_stand_at_their_time_behind_what_was_recorded_then() -> None:
    recorded = [Stamped(NEWS, SECOND, b"a"), Stamped(NEWS, 2 * SECOND, b"b"), Stamped(NEWS, 3 * SECOND, b"c")]
    codec = RosCodec(message_text)
    news = [told("/mrta/event", 2.5, "late"), told("/mrta/event", 2.0, "early"), told("/known", 1.0, "said already")]
    found = list(with_news(recorded, news, codec, {"/news", "/known"}))
    assert [(each.connection.topic, each.receipt_ns) for each in found] == [
        ("/news", SECOND),
        ("/news", 2 * SECOND),
        ("/mrta/event", 2 * SECOND),
        ("/mrta/event", 2_500_000_000),
        ("/news", 3 * SECOND),
    ]
    assert codec.decode(found[2].connection, found[2].raw)["text"] == "early"
    assert (found[2].connection.caller, found[2].connection.type) == ("/supervisor", "rqt_mrta_py/Event")


def message_text(type_name: str) -> str | None:
    path = Path(__file__).resolve().parents[2] / "msg" / f"{type_name.partition('/')[2]}.msg"
    return path.read_text(encoding="utf-8") if path.exists() else None
