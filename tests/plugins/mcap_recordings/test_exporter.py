"""MCAP files, read back by the readers of MCAP's own project and, here and there, byte by byte."""

from __future__ import annotations

import io
import struct
import sys
from typing import Any, Dict, Iterable, List, Tuple

import pytest
from mcap_recordings.exporter import McapExporter

from rqt_mrta_py.errors import MissingDependencyError, MrtaError
from rqt_mrta_py.hooks import Connection, ExporterSetup, Stamped
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, Mission, MissionRecord, Taxonomy
from rqt_mrta_py.transport import RosCodec
from tests.plugins.csv_tables.missions import RECORD

pytest.importorskip("mcap.reader", reason="the package mcap is not installed (extra mcap)")

MISSION = Mission(ApplicationSpec("yard", "Yard"), ArchitectureSpec("x", "X", Taxonomy()), ())
CODEC = RosCodec(lambda _: None)
STRING = CODEC.connection("/news", "std_msgs/String", "/robot1/agent", latched=True)
POSE = CODEC.connection("/robot1/pose", "geometry_msgs/PoseStamped")
SECOND = 10**9


def exported(messages: Iterable[Stamped], record: MissionRecord = RECORD) -> bytes:
    exporter = McapExporter(ExporterSetup(MISSION))
    created: Dict[str, io.BytesIO] = {}

    def create(name: str) -> io.BytesIO:
        return created.setdefault(name, io.BytesIO())

    exporter.begin(record, create)
    for stamped in messages:
        exporter.take(stamped)
    exporter.end()
    assert list(created) == ["mission.mcap"]
    return created["mission.mcap"].getvalue()


def news(text: str, receipt_ns: int, connection: Connection = STRING) -> Stamped:
    return Stamped(connection, receipt_ns, CODEC.encode("std_msgs/String", {"data": text}))


def read(content: bytes) -> List[Tuple[Any, Any, Any]]:
    from mcap.reader import make_reader

    return list(make_reader(io.BytesIO(content), validate_crcs=True).iter_messages(log_time_order=False))


def test_bytes_times_and_definitions_come_back_as_they_were() -> None:
    messages = [news("a", SECOND), news("b", SECOND), Stamped(POSE, SECOND + 1, bytes(72)), news("c", 3 * SECOND)]
    found = read(exported(messages))
    assert [(channel.topic, message.log_time, message.data) for _, channel, message in found] == [
        (each.connection.topic, each.receipt_ns, each.raw) for each in messages
    ]
    assert [message.publish_time for _, _, message in found] == [each.receipt_ns for each in messages]
    assert [message.sequence for _, _, message in found] == [0, 1, 0, 2]
    schema, channel, _ = found[0]
    assert (schema.name, schema.encoding, schema.data.decode()) == ("std_msgs/String", "ros1msg", STRING.definition)
    assert (channel.message_encoding, channel.metadata) == (
        "ros1",
        {"callerid": "/robot1/agent", "latching": "1", "md5sum": STRING.md5},
    )
    assert found[2][1].metadata == {"latching": "0", "md5sum": POSE.md5}


def test_publishers_of_a_topic_keep_channels_of_their_own_and_share_a_schema() -> None:
    other = Connection("/news", "std_msgs/String", STRING.md5, STRING.definition, "/robot2/agent")
    found = read(exported([news("a", 1), news("b", 2, other)]))
    assert [channel.metadata["callerid"] for _, channel, _ in found] == ["/robot1/agent", "/robot2/agent"]
    assert len({channel.id for _, channel, _ in found}) == 2
    assert len({schema.id for schema, _, _ in found}) == 1


def test_two_definitions_of_one_type_stay_two_schemas() -> None:
    other = Connection("/news", "std_msgs/String", "1" * 32, "string data\nstring more\n")
    found = read(exported([news("a", 1), Stamped(other, 2, bytes(8))]))
    assert [schema.data.decode() for schema, _, _ in found] == [STRING.definition, other.definition]


def test_fields_are_decoded_by_the_readers_own_decoder_of_ros_messages() -> None:
    decoder = pytest.importorskip("mcap_ros1.decoder")
    from mcap.reader import make_reader

    fields = {
        "header": {"stamp": 12.5, "frame_id": "map"},
        "pose": {"position": {"x": 1.5, "y": -2.0, "z": 0.25}, "orientation": {"w": 1.0}},
    }
    messages = [Stamped(POSE, SECOND, CODEC.encode("geometry_msgs/PoseStamped", fields)), news("hello", 2 * SECOND)]
    reader = make_reader(io.BytesIO(exported(messages)), decoder_factories=[decoder.DecoderFactory()])
    pose, text = [decoded for _, _, _, decoded in reader.iter_decoded_messages()]
    assert (pose.header.stamp.to_sec(), pose.header.frame_id) == (12.5, "map")
    assert (pose.pose.position.x, pose.pose.position.y, pose.pose.orientation.w) == (1.5, -2.0, 1.0)
    assert text.data == "hello"


def test_the_file_says_what_it_is_byte_by_byte() -> None:
    """The header's record as the specification has it: opcode 1, length, profile, library."""
    content = exported([])
    assert content[:8] == content[-8:] == b"\x89MCAP0\r\n"
    text = [struct.pack("<I", len(each)) + each for each in (b"ros1", b"rqt_mrta_py")]
    assert content[8:].startswith(b"\x01" + struct.pack("<Q", len(b"".join(text))) + b"".join(text))


@pytest.mark.parametrize(
    ("record", "told"),
    [
        (RECORD, {"application": "yard", "architecture": "nearest_robot", "taxonomy": "ST-SR-IA", "seed": "7"}),
        (
            MissionRecord(None, None, Taxonomy.parse("ST-SR-IA"), None, None, None, (), (), (), (), ()),
            {"taxonomy": "ST-SR-IA"},
        ),
    ],
)
def test_what_is_known_of_the_mission_is_metadata(record: MissionRecord, told: Dict[str, str]) -> None:
    from mcap.reader import make_reader

    reader = make_reader(io.BytesIO(exported([news("a", 1)], record)))
    assert [(each.name, each.metadata) for each in reader.iter_metadata()] == [("rqt_mrta_py", told)]
    summary = reader.get_summary()
    assert summary is not None
    assert summary.statistics is not None
    assert (summary.statistics.message_count, summary.statistics.channel_count) == (1, 1)


def test_the_same_messages_give_the_same_bytes() -> None:
    messages = [news(str(number), number) for number in range(3000)]
    assert exported(messages) == exported(messages)
    assert [message.data for _, _, message in read(exported(messages))] == [each.raw for each in messages]


def test_more_publishers_than_numbers_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mcap_recordings.exporter._CHANNELS", 2)
    several = [Connection(f"/news{number}", "std_msgs/String", "", "string data") for number in range(3)]
    with pytest.raises(MrtaError, match=r"^exporter mcap: /news2: the stream has more than 2 publishers of topics"):
        exported([news("a", 1, connection) for connection in several])


def test_without_the_package_mcap_the_remedy_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("mcap", "mcap.writer"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(MissingDependencyError, match=r"pip install 'rqt_mrta_py\[mcap\]'$"):
        McapExporter(ExporterSetup(MISSION))
