"""What ROS users are given beside launch files: the node review, and what RViz shows of a bag that is played."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, List

import yaml

from rqt_mrta_py.app.nodes.review import main as review
from rqt_mrta_py.app.nodes.review import options_of
from rqt_mrta_py.transport import read_bag_info
from tests.app.outputs import Outputs
from tests.conftest import ROOT


def test_private_parameters_are_the_arguments_of_review() -> None:
    parameters = {"bag": "a.bag", "out": "", "pictures": 0.0, "video": True, "force": "false", "fail_on": "error"}
    assert options_of(parameters) == ["a.bag", "--pictures", "0.0", "--fail-on", "error", "--video"]


def test_the_review_node_needs_no_master_for_what_its_command_line_says(short_patrol: Outputs, tmp_path: Path) -> None:
    out = tmp_path / "review"
    status = review(["__name:=here", f"_bag:={short_patrol.bag}", f"_out:={out}", "_pictures:=0", "__log:=/dev/null"])
    assert status == 0
    assert (out / "summary.json").read_bytes() == (short_patrol.folder / "summary.json").read_bytes()
    assert review([str(short_patrol.bag), "--pictures", "0", "--out", str(out), "__name:=here"]) == 2


def displays(path: Path) -> List[Dict[str, object]]:
    return list(yaml.safe_load(path.read_text(encoding="utf-8"))["Visualization Manager"]["Displays"])


def test_rviz_shows_what_the_supervisor_says(patrol: Outputs) -> None:
    found = {str(display["Class"]): display for display in displays(ROOT / "config" / "rviz" / "team.rviz")}
    types = {connection.topic: connection.type for connection, _ in read_bag_info(patrol.bag).connections}
    assert types[str(found["rviz/MarkerArray"]["Marker Topic"])] == "visualization_msgs/MarkerArray"
    # image_transport adds the transport's name to the topic.
    picture = found["rviz/Image"]
    assert types[f"{picture['Image Topic']}/{picture['Transport Hint']}"] == "sensor_msgs/CompressedImage"
    assert types["/tf"] == "tf2_msgs/TFMessage"
