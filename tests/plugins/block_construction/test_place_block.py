"""One robot fetches blocks and places them, in BulletWorld, as anybody would run it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.transport import RosCodec, read_bag
from tests.plugins.block_construction.sites import block_at, block_body, write_site
from tests.transport.support import lookup

LEFT, RIGHT = math.atan2(-0.9, -0.9), math.atan2(-0.9, 0.9)
UP = math.pi / 2
CELLS = [(3, 1), (4, 1), (5, 1)]


class Build:
    """What is in the bag of a build."""

    def __init__(self, folder: Path) -> None:
        self.said: Dict[str, List[Dict[str, Any]]] = {}
        codec = RosCodec(lookup)
        for connection, _, raw in read_bag(folder / "mission.bag"):
            if connection.topic in ("/rosout", "/simulation/bodies") or connection.topic.endswith("builder_state"):
                self.said.setdefault(connection.topic, []).append(codec.decode(connection, raw))

    @property
    def blocks(self) -> Dict[str, Any]:
        """Where blocks are in the end [m]."""
        newest = self.said["/simulation/bodies"][-1]["detections"]
        return {each["id"]: tuple(each["position"][axis] for axis in "xyz") for each in newest}

    @property
    def states(self) -> List[Dict[str, Any]]:
        """What the builder told of itself."""
        return self.said["/robot1/builder_state"]

    @property
    def logs(self) -> List[str]:
        """Lines for people."""
        return [each["msg"] for each in self.said["/rosout"]]


def build(folder: Path, *arguments: str, **site: Any) -> Build:
    path = write_site(folder / "small_site", **site)
    assert main(["run", path, "--pictures", "0", "--out", str(folder / "out"), "-q", *arguments]) == 0
    return Build(folder / "out")


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> Build:
    """Let one robot place two blocks, one on the other."""
    bodies = [block_body("b1", 3, 0.2, 0.2, LEFT), block_body("b2", 3, 2.0, 0.2, RIGHT)]
    tasks = [
        block_at(1, 3, 1, (1.02, 0.86), heading=UP, cells=CELLS, supply=[[1, 0.2, 0.2, LEFT]]),
        block_at(2, 3, 2, (1.02, 0.86), heading=UP, cells=CELLS, supply=[[2, 2.0, 0.2, RIGHT]]),
    ]
    return build(tmp_path_factory.mktemp("pair"), bodies=bodies, tasks=tasks, duration=260.0)


def test_two_blocks_lie_one_on_the_other_within_a_millimetre(pair: Build) -> None:
    assert pair.blocks == {
        "b1": pytest.approx((1.02, 0.86, 0.035), abs=0.001),
        "b2": pytest.approx((1.02, 0.86, 0.105), abs=0.001),
    }


def test_builder_tells_what_it_does_in_this_order(pair: Build) -> None:
    told = [(each["task"], each["activity"], each["action"]) for each in pair.states]
    order = [each for number, each in enumerate(told) if number == 0 or each != told[number - 1]]
    fetching = [("fetching", each) for each in ("position", "lower", "approach", "raise", "retreat", "raise")]
    placing = [("placing", each) for each in ("position", "lower", "approach", "lower", "retreat", "raise")]
    trip = [("driving", ""), *fetching, ("driving", ""), *placing]
    assert order == [
        *(("block1", *each) for each in trip),
        ("", "idle", ""),
        *(("block2", *each) for each in trip),
        ("", "idle", ""),
    ]
    assert [each["placed"] for each in pair.states][-1] == [1, 2]


def test_builder_stands_off_what_it_placed(pair: Build) -> None:
    pose = pair.states[-1]["pose"]
    assert (pose["x"], pose["y"]) == pytest.approx((1.02, 0.86 - 0.55), abs=0.01)
