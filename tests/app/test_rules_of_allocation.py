"""Rules of allocation on a recording of original nodes to which words were added that cannot be right."""

from __future__ import annotations

from pathlib import Path
from typing import Callable

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.model import Progress
from rqt_mrta_py.transport import read_bag
from rqt_mrta_py.transport.bags.writer import BagWriter
from tests.app.outputs import Outputs

APPLICATION = """<rqt_mrta format="application"><application><name>Yard</name><architecture>mrta_alliance</architecture>
<robots><robot_0><id>robot1</id><tasks>
<task_0><id>patrol</id></task_0><task_1><id>report</id></task_1>
</tasks></robot_0></robots></application></rqt_mrta>"""


def test_words_that_cannot_be_right_are_found_in_a_recording(
    shared_data: Callable[[str], Path], tmp_path: Path
) -> None:
    """robot1 holds patrol from 4.1 to 43.5 s; robot2 and its inspect are not listed.

    Patrol is told done at 20 and at 40 s, and failed at 60 s.
    """
    codec = compose().codec()
    messages = list(read_bag(shared_data("alliance_two_robots.bag")))
    connection = codec.connection("/mrta/task_progress", "rqt_mrta_py/TaskProgress", "/robot1/agent")
    for second, progress in ((20, Progress.DONE), (40, Progress.DONE), (60, Progress.FAILED)):
        receipt_ns = messages[0].receipt_ns + second * 10**9
        told = {"task_id": "patrol", "robot_id": "robot1", "progress": progress.code, "detail": ""}
        fields = {"header": {"stamp": receipt_ns / 1e9, "frame_id": ""}, **told}
        messages.append(Stamped(connection, receipt_ns, codec.encode("rqt_mrta_py/TaskProgress", fields)))
    with BagWriter(tmp_path / "odd.bag") as writer:
        for message in sorted(messages, key=lambda each: each.receipt_ns):
            writer.write(message)
    application = tmp_path / "rqt_mrta.xml"
    application.write_text(APPLICATION, encoding="utf-8")
    bag, out = str(tmp_path / "odd.bag"), tmp_path / "review"
    told_by = ["--application", str(application), "--pictures", "0", "--out", str(out), "-q"]
    assert main(["review", bag, *told_by]) == 0

    found = {each["rule"]: each["text"] for each in Outputs(out).summary["incidents"]}
    assert found["task_completed_twice"] == "robot1 has completed patrol at 40.0 s, which robot1 had done at 20.0 s"
    assert found["illegal_state_change"].startswith("patrol was done at 20.0 s, but at ")
    assert found["unknown_robot"].endswith(
        "names robot 'robot2', which is none of the mission's; perhaps robot1 is meant"
    )
    assert found["unknown_task"] == "robot2 names task 'inspect', which is none of the mission's"
    assert "busy_without_task" not in found
    assert all(each["causes"] for each in Outputs(out).summary["incidents"])
