"""``mrta review --why``: who could have had a task, who took it when, and on what grounds."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Callable, Dict, List, Tuple

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Mrta, Outputs

TOLERANCE = 0.06
"""The reference gives some of its times in tenths of a second."""


def why(folder: Path, task: str) -> Dict[str, Any]:
    document = json.loads((folder / "why.json").read_text(encoding="utf-8"))
    assert document["schema"] == "rqt_mrta_py/why/1"
    (found,) = [each for each in document["tasks"] if each["id"] == task]
    return dict(found)


def start_of(folder: Path) -> float:
    return float(json.loads((folder / "summary.json").read_text(encoding="utf-8"))["time"]["start"])


@pytest.fixture
def original(mrta: Mrta, shared_data: Callable[[str], Path], tmp_path: Path) -> Path:
    """Review the recording of the original nodes, section 7.7 of the reference."""
    bag, folder = str(shared_data("alliance_two_robots.bag")), tmp_path / "review"
    options = ("--architecture", "mrta_alliance", "--pictures", "0", "--out", str(folder))
    assert mrta("review", bag, *options, "--why", "patrol", "--why", "/inspect") == (0, [])
    return folder


def grounds(folder: Path, task: str, robot: str) -> List[Tuple[float, str]]:
    start = start_of(folder)
    told = [each for each in why(folder, task)["grounds"] if each["robot"] == robot]
    return [(round(each["time"] - start, 2), each["text"]) for each in told]


def test_who_took_a_task_of_the_original_nodes_is_told_with_the_times_between(original: Path) -> None:
    """robot1 had patrol from 4.12 to 43.5 s and from 48.12 s until it was lost, when nobody took it over.

    Of a task that no application lists nothing is known before it is announced.
    """
    start, task = start_of(original), why(original, "patrol")

    assert [(each["robot"], each["outcome"]) for each in task["spells"]] == [
        ("robot1", "gave_up"),
        (None, None),
        ("robot1", "lost"),
        (None, None),
    ]
    begins = [each["from"] - start for each in task["spells"]]
    assert begins == pytest.approx([4.12, 43.5, 48.12, 75.72], abs=TOLERANCE)
    assert task["spells"][0]["why"] == "acquiescent: nobody else is on the task"
    assert [(each["robot"], each["able"]) for each in task["candidates"]] == [("robot1", True), ("robot2", None)]
    # While nobody had it robot2 was on inspect, but for the time from 91.37 to 94.77 s.
    last = [each for each in task["spells"][-1]["others"] if each["robot"] == "robot2"]
    assert [(each["state"], each["tasks"]) for each in last][-1] == ("busy", ["inspect"])


def test_motivations_of_the_original_nodes_are_told_as_the_reference_tells_them(original: Path) -> None:
    patrol1, inspect2 = grounds(original, "patrol", "robot1"), grounds(original, "inspect", "robot2")

    assert patrol1[0][1] == "motivation grows by 1.5 a cycle towards the threshold 30"
    active = [time for time, text in patrol1 if "becomes active" in text]
    assert active == pytest.approx([3.5, 47.5], abs=TOLERANCE)
    assert [time for time, text in patrol1 if text.startswith("acquiescent: gives it up")] == pytest.approx(
        [43.5], abs=TOLERANCE
    )
    assert [time for time, text in inspect2 if "becomes active" in text] == pytest.approx(
        [4.37, 49.4, 94.2], abs=TOLERANCE
    )
    assert [time for time, text in inspect2 if text.startswith("acquiescent")] == pytest.approx(
        [44.6, 89.4], abs=TOLERANCE
    )


def test_why_the_other_robot_of_the_original_nodes_did_not_take_a_task_is_told(original: Path) -> None:
    """robot2's patrol: slow at 4.37 s, fast at 47.16, slow at 48.36, fast again at 64.4 after phi = 60 s."""
    told = grounds(original, "patrol", "robot2")
    moves = [(time, text) for time, text in told if "impatience" in text and "grows" not in text]

    assert [time for time, _ in moves[:4]] == pytest.approx([4.37, 47.16, 48.36, 64.4], abs=TOLERANCE)
    words = [("falls from 1 to 0.5", "while robot1"), ("rises from 0.5 to 1", "nobody else")]
    words += [("falls from 1 to 0.5", "while robot1"), ("rises from 0.5 to 1", "though robot1")]
    assert [change in text and reason in text for (_, text), (change, reason) in zip(moves, words)] == [True] * 4
    assert "reset to 0: robot1 has announced it" in moves[0][1]
    assert any("suppressed by its inspect" in text for time, text in told if time < 5.0)


def test_why_can_be_asked_of_a_part_of_a_recording(
    mrta: Mrta, shared_data: Callable[[str], Path], tmp_path: Path
) -> None:
    bag, folder = str(shared_data("alliance_two_robots.bag")), tmp_path / "part"
    options = ("--architecture", "mrta_alliance", "--pictures", "0", "--out", str(folder))
    assert mrta("review", bag, *options, "--from", "40", "--to", "60", "--why", "patrol")[0] == 0

    told = why(folder, "patrol")
    times = [each["time"] for each in told["grounds"]]
    texts = [each["text"] for each in told["grounds"] if each["robot"] == "robot1"]
    assert times
    assert max(times) - start_of(folder) <= 20.0
    assert texts[0].startswith("active when it was first heard of")
    assert [each["outcome"] for each in told["spells"] if each["robot"]] == ["gave_up", "open"]


def test_terminal_page_and_file_tell_the_same(
    short_patrol: Outputs, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "review"
    capsys.readouterr()
    bag = ["review", str(short_patrol.bag), "--pictures", "0", "--out", str(folder)]
    assert main([*bag, "--why", "wander"]) == 0

    out = capsys.readouterr().out
    page = (folder / "report.html").read_text(encoding="utf-8")
    told = why(folder, "wander")
    assert out.count("why wander: ") == 1
    assert 'id="why"' in page
    for ground in told["grounds"][:5]:
        assert ground["text"] in page
        assert " ".join(ground["text"].split()) in " ".join(out.split())

    assert main([*bag, "--force", "--why", "wander", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert (printed["schema"], printed["why"]["tasks"]) == ("rqt_mrta_py/review/1", [told])


def test_asking_why_changes_nothing_else(short_patrol: Outputs, mrta: Mrta, tmp_path: Path) -> None:
    plain, asked = tmp_path / "plain", tmp_path / "asked"
    for folder, more in ((plain, ()), (asked, ("--why", "*"))):
        assert mrta("review", str(short_patrol.bag), "--pictures", "0", "--out", str(folder), *more)[0] == 0
    names = sorted(path.name for path in plain.iterdir())
    assert sorted(path.name for path in asked.iterdir()) == sorted([*names, "why.json"])
    for name in set(names) - {"report.html", "run.log"}:
        assert (plain / name).read_bytes() == (asked / name).read_bytes(), name
    assert 'id="why"' not in (plain / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "architecture", ["mrta_alliance", "mrta_l_alliance", "mrta_demir_cf", "nearest_robot", "mrta_baselines"]
)
def test_every_architecture_tells_on_what_grounds_each_task_was_taken(
    architecture: str, mrta: Mrta, tmp_path: Path
) -> None:
    """Of each robot that took a task something was said that speaks for it, no later than it did so."""
    run, folder = tmp_path / "run", tmp_path / "review"
    short = ("--world", "planar", "--pictures", "0", "--out", str(run))
    assert mrta("run", "border_patrol", "--architecture", architecture, "--duration", "12", *short)[0] == 0
    options = ("--pictures", "0", "--out", str(folder), "--why", "*")
    assert mrta("review", str(run / "mission.bag"), *options) == (0, [])

    document = json.loads((folder / "why.json").read_text(encoding="utf-8"))
    taken = [(task, spell) for task in document["tasks"] for spell in task["spells"] if spell["robot"]]
    assert taken
    for task, spell in taken:
        before = [each for each in task["grounds"] if each["robot"] == spell["robot"] and each["time"] <= spell["from"]]
        assert before, (task["id"], spell)
    assert {each["able"] for task in document["tasks"] for each in task["candidates"]} <= {True, False}


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("wandr", "--why 'wandr': the mission has no such task; nearest is 'wander'; all else was reviewed: "),
        ("q*", "--why 'q*': the mission has no such task; accepted: wander, border_protection, report; "),
    ],
)
def test_a_task_that_there_is_none_of_is_told_in_one_line_once_all_else_is_done(
    name: str, told: str, short_patrol: Outputs, mrta: Mrta, tmp_path: Path
) -> None:
    folder = tmp_path / "review"
    status, lines = mrta("review", str(short_patrol.bag), "--pictures", "0", "--out", str(folder), "--why", name)
    assert (status, len(lines)) == (2, 1)
    assert lines[0].startswith(f"mrta: {told}")
    assert (folder / "summary.json").exists()


BAD = """
from rqt_mrta_py.hooks import *
from rqt_mrta_py.model import Ground


class Part:
    def __init__(self, setup):
        {made}

    def subscriptions(self):
        return {wishes}

    def hear(self, heard):
        return {answer}


@hookimpl
def mrta_register_grounds_readers():
    return {{"mrta_alliance": Part}}
"""
WISHES = "[Subscription('/@robot_id@/alliance/motivation/@task_id@')]"


@pytest.mark.parametrize(
    ("parts", "told"),
    [
        ({"made": "1 / 0"}, "ZeroDivisionError: division by zero"),
        ({"wishes": "[3]"}, "TypeError: wants to hear 3; a Subscription is needed"),
        ({"answer": "1 / 0"}, "ZeroDivisionError: division by zero"),
        ({"answer": "None"}, "answers None; a sequence of Grounds is needed"),
        ({"answer": "['because']"}, "answers 'because'; a Ground is needed"),
        ({"answer": "[Ground(1.0, 3, 'x')]"}, "a time and texts are needed"),
        ({"answer": "[Ground(float('nan'), 'wander', 'x')]"}, "its value is no plain JSON"),
        ({"answer": "[Ground(1.0, 'wander', 'x', values={'a': object()})]"}, "its value is no plain JSON"),
    ],
)
def test_a_reader_of_grounds_that_fails_is_told_once_and_the_review_goes_on(
    parts: Dict[str, str], told: str, short_patrol: Outputs, stranger: Path, mrta: Mrta
) -> None:
    stranger.write_text(BAD.format(**{"made": "pass", "wishes": WISHES, "answer": "()", **parts}))
    folder = Path("review")
    bag = ("review", str(short_patrol.bag), "--pictures", "0", "--out", str(folder))

    status, lines = mrta(*bag, "--why", "wander")

    assert status == 0
    (line,) = [each for each in lines if each.startswith("mrta: grounds reader of mrta_alliance: ")]
    assert told in line
    assert why(folder, "wander")["note"] == f"not all grounds were read: {line[len('mrta: ') :]}"
    assert why(folder, "wander")["spells"]
