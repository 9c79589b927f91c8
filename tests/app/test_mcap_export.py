"""``--export mcap``: runs and reviews as MCAP files, read back by the reader of MCAP's own project."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Tuple

import pytest

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.transport import BagWriter, read_bag
from tests.app.outputs import Mrta, Outputs

pytest.importorskip("mcap.reader", reason="the package mcap is not installed (extra mcap)")

OURS = {"/mrta/allocation", "/mrta/event", "/mrta/robot_state", "/mrta/task_state"}


def of_file(folder: Path) -> List[Tuple[str, int, bytes]]:
    from mcap.reader import make_reader

    (path,) = (folder / "export" / "mcap").iterdir()
    with path.open("rb") as file:
        found = make_reader(file, validate_crcs=True).iter_messages(log_time_order=False)
        return [(channel.topic, message.log_time, message.data) for _, channel, message in found]


def of_bag(path: Path) -> List[Tuple[str, int, bytes]]:
    return [(each.connection.topic, each.receipt_ns, each.raw) for each in read_bag(path)]


def decoded(folder: Path, topic: str) -> List[Any]:
    decoder = pytest.importorskip("mcap_ros1.decoder")
    from mcap.reader import make_reader

    with (folder / "export" / "mcap" / "mission.mcap").open("rb") as file:
        reader = make_reader(file, decoder_factories=[decoder.DecoderFactory()])
        return [message for _, _, _, message in reader.iter_decoded_messages(topics=[topic])]


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Run border_patrol for a second and a half, in which every task is allocated."""
    folder = tmp_path_factory.mktemp("mcap") / "run"
    quick = ("--duration", "1.5", "--world", "planar", "--architecture", "nearest_robot", "--pictures", "0", "-q")
    assert main(["run", "border_patrol", *quick, "--export", "mcap", "--out", str(folder)]) == 0
    return Outputs(folder)


def test_a_run_leaves_what_its_bag_holds(run: Outputs) -> None:
    assert of_file(run.folder) == of_bag(run.bag)


def test_a_review_of_a_runs_bag_adds_nothing_to_it(mrta: Mrta, run: Outputs, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert mrta("review", str(run.bag), "--pictures", "0", "--export", "mcap", "--out", str(out)) == (0, [])
    assert of_file(out) == of_bag(run.bag)


def test_a_review_of_another_bag_adds_what_a_supervisor_would_have_said(
    mrta: Mrta, run: Outputs, tmp_path: Path
) -> None:
    bag = tmp_path / "foreign.bag"
    with BagWriter(bag) as writer:
        for stamped in read_bag(run.bag):
            if stamped.connection.topic not in OURS:
                writer.write(stamped)
    out = tmp_path / "out"
    assert mrta("review", str(bag), "--pictures", "0", "--export", "mcap", "--out", str(out)) == (0, [])
    found = of_file(out)
    assert [each for each in found if each[0] not in OURS] == of_bag(bag)
    assert [receipt_ns for _, receipt_ns, _ in found] == sorted(receipt_ns for _, receipt_ns, _ in found)
    counts: Dict[str, int] = {}
    for topic, _, _ in of_bag(run.bag):
        counts[topic] = counts.get(topic, 0) + 1
    # The run told on its bus what the review tells here: as much on each topic.
    told = {topic: sum(each[0] == topic for each in found) for topic in OURS}
    assert told == {topic: counts[topic] for topic in OURS}
    events = Outputs(out).lines("events.jsonl")
    said = sorted((event.header.stamp.to_sec(), event.kind, event.text) for event in decoded(out, "/mrta/event"))
    assert said == sorted((event["time"], event["kind"], event["text"]) for event in events)
