"""What ROS's own tools make of recordings."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from rqt_mrta_py.transport import BagWriter, Compression, read_bag
from tests.transport.recordings import SECOND, ballast, mission
from tests.transport.support import ROOT, ROS_PYTHON, require_ros, run_ros, write_together

pytestmark = pytest.mark.ros


def test_a_killed_recording_keeps_what_was_checkpointed(tmp_path: Path) -> None:
    require_ros("rosbag")
    script = (
        "import os, sys, pathlib\n"
        "from tests.transport.recordings import mission\n"
        "from rqt_mrta_py.transport import BagWriter\n"
        "writer = BagWriter(pathlib.Path(sys.argv[1]))\n"
        "for stamped in mission(250): writer.write(stamped)\n"
        "os._exit(9)\n"
    )
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'src'}{os.pathsep}{ROOT}"}
    subprocess.run([sys.executable, "-c", script, str(tmp_path / "m.bag")], check=False, env=environment, timeout=60)
    active = tmp_path / "m.bag.active"
    mended = active.rename(tmp_path / "mended.bag")
    run_ros(["rosbag", "reindex", "-q", str(mended)])
    assert list(read_bag(mended)) == mission(250)[:201]


@pytest.mark.parametrize("compression", list(Compression))
def test_ros_reads_reindexes_and_appends_to_our_bags(tmp_path: Path, compression: Compression) -> None:
    require_ros("rosbag")
    path = tmp_path / "m.bag"
    # The first chunk is as large as chunks get.
    stream = sorted([*ballast(), *mission(300)], key=lambda stamped: stamped.receipt_ns)
    with BagWriter(path, compression) as writer:
        write_together(writer, stream)
    ours = [[s.connection.topic, s.connection.md5, s.receipt_ns, s.raw.hex()] for s in stream]

    script = (
        "import json, sys, rosbag\n"
        "bag = rosbag.Bag(sys.argv[1])\n"
        "print(json.dumps([[topic, raw[2], t.to_nsec(), raw[1].hex()]"
        " for topic, raw, t in bag.read_messages(raw=True)]))\n"
    )

    def read_by_ros() -> Any:
        return json.loads(run_ros([ROS_PYTHON, "-c", script, str(path)]).stdout)

    assert sorted(read_by_ros()) == sorted(ours)
    assert run_ros(["rosbag", "info", "-y", "-k", "messages", str(path)]).stdout.strip() == str(len(stream))
    assert run_ros(["rosbag", "info", "-y", "-k", "compression", str(path)]).stdout.strip() == compression.value
    run_ros(["rosbag", "check", str(path)])
    run_ros(["rosbag", "reindex", "-q", str(path)])
    assert sorted(read_by_ros()) == sorted(ours)
    append = (
        "import sys, rosbag, rospy\nfrom std_msgs.msg import String\n"
        "with rosbag.Bag(sys.argv[1], 'a') as bag: bag.write('/late', String('x'), rospy.Time(100))\n"
    )
    run_ros([ROS_PYTHON, "-c", append, str(path)])
    back = list(read_bag(path))
    assert back[:-1] == stream
    assert (back[-1].connection.topic, back[-1].receipt_ns, back[-1].raw) == ("/late", 100 * SECOND, b"\1\0\0\0x")


def test_rosbag_plays_our_bags(tmp_path: Path) -> None:
    require_ros("rosmaster.master")
    path = tmp_path / "m.bag"
    with BagWriter(path) as writer:
        # What is played lies around and between chunks as large as they get.
        write_together(writer, mission(90)[:30])
        write_together(writer, ballast())
        write_together(writer, mission(90)[30:])
    master = (
        "import sys\nfrom rosmaster.master import Master\n"
        "master = Master(0); master.start(); print(master.uri, flush=True); sys.stdin.read(); master.stop()\n"
    )
    listener = (
        "import rospy, threading\nfrom std_msgs.msg import String\n"
        "heard, done = [], threading.Event()\n"
        "def hear(message):\n"
        "    heard.append(message.data)\n"
        "    if len(heard) == 60: done.set()\n"
        "rospy.init_node('listener', disable_signals=True)\n"
        "rospy.Subscriber('/chatter', String, hear)\n"
        "done.wait(30)\n"
        "print(len(set(heard)))\n"
    )
    environment = {**os.environ, "ROS_HOSTNAME": "127.0.0.1", "ROS_HOME": str(tmp_path), "ROS_LOG_DIR": str(tmp_path)}
    with subprocess.Popen(
        [ROS_PYTHON, "-c", master], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment
    ) as served:
        assert served.stdin is not None
        assert served.stdout is not None
        environment["ROS_MASTER_URI"] = served.stdout.readline().strip()
        with subprocess.Popen(
            [ROS_PYTHON, "-c", listener], stdout=subprocess.PIPE, text=True, env=environment
        ) as listening:
            play = ["rosbag", "play", "-q", "--wait-for-subscribers", "--topics", "/chatter", "--bags", str(path)]
            run_ros(play, env=environment)
            answer, _ = listening.communicate(timeout=60)
        served.stdin.close()
    assert answer.strip() == "60"
