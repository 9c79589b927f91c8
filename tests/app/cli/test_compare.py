"""``mrta compare``: what it prints, writes and answers."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.app.cli.conftest import Command
from tests.app.compare.summaries import allocation, folder, incident, summary


@pytest.fixture(autouse=True)
def two_missions(tmp_path: Path) -> None:
    """Two runs: in the second r1 falls silent, r2 takes over, and travels a little more."""
    folder(
        tmp_path,
        "a",
        summary(
            allocations=[allocation("dig", "r1", 2.0, 41.0), allocation("haul", "r2", 3.0, 61.0)],
            statistics={"travel": 20.5},
        ),
    )
    folder(
        tmp_path,
        "b",
        summary(
            allocations=[
                allocation("dig", "r1", 2.0, 21.0, "lost"),
                allocation("dig", "r2", 24.0, 70.0),
                allocation("haul", "r2", 3.0, 61.5),
            ],
            incidents=[incident("robot_silent_with_task", "error", 21.0, ["r1"], ["dig"])],
            statistics={"travel": 21},
        ),
    )


def test_equal_missions_are_told_in_few_lines_and_exit_0(command: Command) -> None:
    told = command("compare", "../a", "../a")
    assert (told.status, told.err) == (0, "")
    assert told.out == (
        "A: yard under nearest_robot, seed 7, 100.0 s (../a)\n"
        "B: yard under nearest_robot, seed 7, 100.0 s (../a)\n"
        "\n"
        "all figures are equal\n"
        "\n"
        "0 of 2 tasks were given out differently; in other hands or none for 0.0 of 97.0 s (0.0 %)\n"
        "\n"
        "B is not worse than the tolerances allow\n"
    )


def test_whatever_differs_is_a_line_and_a_worse_mission_exits_1(command: Command) -> None:
    told = command("compare", "../a", "../b/summary.json")
    assert (told.status, told.err) == (1, "")
    # In other hands: dig from 20 to 69 s of 1 to 69 s, haul for half a second of 58.5 s.
    assert told.out.splitlines()[3:] == [
        "FIGURE                                    A     B         CHANGE     ALLOWED",
        "incidents.error                           0     1         +1         0        worse",
        "allocations                               2     3         +1         any",
        "differences.new_incidents.error           0     1         +1         any",
        "differences.share_of_time_held_otherwise  0     0.391304  +0.391304  any",
        "incidents                                 0     1         +1         any",
        "incidents.rule.robot_silent_with_task     0     1         +1         any",
        "statistics.travel                         20.5  21        +0.5       any",
        "",
        "1 of 2 tasks were given out differently; in other hands or none for 49.5 of 126.5 s (39.1 %)",
        "  dig: done in both; in other hands or none for 49.0 of 68.0 s",
        "TASK  ROBOT  NO.  A                    B",
        "dig   r1     1    1.0 to 40.0 s, done  1.0 to 20.0 s, lost",
        "dig   r2     1    -                    23.0 to 69.0 s, done",
        "",
        "incidents of one mission only (+ B, - A):",
        "+     20.0 s  error: r1: robot_silent_with_task",
        "",
        "B is worse than the tolerances allow: incidents.error",
    ]


def test_tolerances_of_a_file_judge_first_and_those_that_match_nothing_are_told(
    command: Command, tmp_path: Path
) -> None:
    (tmp_path / "t.yaml").write_text(
        "tolerances:\n- {figure: 'incidents.*', worse: never}\n- {figure: travel, worse: higher}\n"
        "- {figure: statistics.travel, worse: higher, relative: 0.025}\n",
        encoding="utf-8",
    )
    told = command("compare", "../a", "../b", "--tolerances", "../t.yaml")
    assert (told.status, told.err) == (0, "mrta: ../t.yaml:3: 'travel' matches no figure\n")


def test_a_faulty_file_of_tolerances_is_told_with_its_line(command: Command, tmp_path: Path) -> None:
    (tmp_path / "t.yaml").write_text("tolerances:\n- {figure: x, worse: up}\n", encoding="utf-8")
    told = command("compare", "../a", "../b", "--tolerances", "../t.yaml")
    assert told == (
        3,
        "",
        "mrta: ../t.yaml:2: tolerances[0]/worse: must be one of higher, lower, either, never (got 'up')\n",
    )


def test_json_names_its_schema_and_what_is_worse(command: Command) -> None:
    told = command("compare", "../a", "../b", "--json")
    document = json.loads(told.out)
    assert (told.status, document["schema"], document["worse"]) == (1, "rqt_mrta_py/compare/1", ["incidents.error"])
    assert list(document) == ["schema", "worse", "a", "b", "figures", "tasks", "incidents"]
    assert [each["differs"] for each in document["tasks"][1]["allocations"]] == [False]


def test_the_page_is_written_but_not_over_another(command: Command, tmp_path: Path) -> None:
    assert command("compare", "../a", "../b", "--html", "page.html").status == 1
    page = tmp_path / "here" / "page.html"
    assert page.read_text(encoding="utf-8").startswith("<!doctype html>")
    page.write_text("mine", encoding="utf-8")
    told = command("compare", "../a", "../b", "--html", "page.html")
    assert told == (2, "", "mrta: --html page.html: is there already; --force writes over it\n")
    assert page.read_text(encoding="utf-8") == "mine"
    assert command("compare", "../a", "../a", "--html", "page.html", "--force").status == 0
    assert page.read_text(encoding="utf-8") != "mine"
    told = command("compare", "../a", "../b", "--html", "nowhere/page.html")
    assert (told.status, told.err) == (3, "mrta: nowhere/page.html: cannot be written: No such file or directory\n")


def test_a_folder_without_a_summary_is_told(command: Command) -> None:
    told = command("compare", "../a", ".")
    assert told == (3, "", "mrta: summary.json: cannot be read: No such file or directory\n")
