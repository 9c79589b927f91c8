"""``mrta list --type``: which architectures and applications fit a taxonomy."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.app.catalogue.taxonomy_filter import parse_filter
from rqt_mrta_py.errors import UsageError
from tests.app.cli.conftest import Command

ARCHITECTURE = """<rqt_mrta><architecture><name>{name}</name>
  <robots><type>{robots}</type></robots> <tasks><type>{tasks}</type></tasks>
  <allocations><type>{allocations}</type></allocations></architecture></rqt_mrta>"""
APPLICATION = """<rqt_mrta><application><name>{name}</name><architecture>{architecture}</architecture>
  <robots><robot_0><id>robot1</id></robot_0></robots></application></rqt_mrta>"""

OF_ARCHITECTURES = {
    "plain": ("ST", "SR", "IA"),
    "spelt_out": ("multi_task", "Multi Robot (MR)", "Time-Extended Assignment"),
    "half_known": ("ST", "", "IA"),
    "unknown": ("STX", "", ""),
}


@pytest.fixture
def packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Put four architectures on the path, and an application of each and one of none of them."""
    folder = tmp_path / "packages"
    for name, (robots, tasks, allocations) in OF_ARCHITECTURES.items():
        text = ARCHITECTURE.format(name=name, robots=robots, tasks=tasks, allocations=allocations)
        register(folder / name, "architecture", text)
    for name in (*OF_ARCHITECTURES, "gone"):
        register(folder / f"on_{name}", "application", APPLICATION.format(name=name, architecture=name))
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(folder))
    return folder


def register(folder: Path, kind: str, text: str) -> None:
    folder.mkdir(parents=True)
    export = f'<rqt_mrta_py {kind}="${{prefix}}/rqt_mrta.xml"/>'
    (folder / "package.xml").write_text(
        f"<package><name>{folder.name}</name><depend>rqt_mrta_py</depend><export>{export}</export></package>"
    )
    (folder / "rqt_mrta.xml").write_text(text)


def fitting(command: Command, *arguments: str) -> List[str]:
    """List the packages of the fixture that are let through."""
    document: Dict[str, Any] = json.loads(command("list", *arguments, "--json").out)
    names = [entry["name"] for kind in ("architectures", "applications") for entry in document[kind]]
    return [name for name in names if name.replace("on_", "") in (*OF_ARCHITECTURES, "gone")]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("ST-SR-IA", ["plain"]),
        ("st-sr-ia", ["plain"]),
        ("-SR-", ["plain"]),
        ("ST--", ["half_known", "plain"]),
        ("ST- -IA", ["half_known", "plain"]),
        ("ST-*-*", ["half_known", "plain"]),
        ("--TA", ["spelt_out"]),
        ("MultiTask-multi robot-Time-Extended Assignment (TA)", ["spelt_out"]),
        ("MT-SR-", []),
        (" - - ", ["half_known", "plain", "spelt_out", "unknown"]),
        ("*", ["half_known", "plain", "spelt_out", "unknown"]),
        ("", ["half_known", "plain", "spelt_out", "unknown"]),
    ],
)
def test_a_type_lets_through_what_fits_every_axis_that_is_given(
    command: Command, packages: Path, text: str, expected: List[str]
) -> None:
    assert packages.is_dir()
    everything = not text.strip("-* ")
    applications = sorted(f"on_{name}" for name in (*expected, *(["gone"] if everything else [])))

    assert fitting(command, f"--type={text}") == [*expected, *applications]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("ST-SR", "--type 'ST-SR': is not a taxonomy"),
        ("XX-SR-IA", "--type 'XX-SR-IA': 'XX' is no type of robots; accepted: ST, MT"),
        ("ST-SRR-", "--type 'ST-SRR-': 'SRR' is no type of tasks; nearest is 'SR'"),
        ("ST-SR-IA-TA", "--type 'ST-SR-IA-TA': 'IA-TA' is no type of allocations; accepted: IA, TA"),
        ("SR-ST-IA", "--type 'SR-ST-IA': 'SR' is no type of robots; accepted: ST, MT"),
    ],
)
def test_a_type_that_is_none_says_what_is_accepted(command: Command, text: str, said: str) -> None:
    how = "give robots-tasks-allocations, such as ST-SR-IA; any of them may be left blank or be *"

    with pytest.raises(UsageError) as caught:
        parse_filter(text)
    told = command("list", f"--type={text}")

    assert str(caught.value) == f"{said}; {how}"
    assert (told.status, told.out, told.err) == (2, "", f"mrta: {said}; {how}\n")


def test_list_marks_what_cannot_be_used_and_says_why_on_stderr(command: Command, packages: Path) -> None:
    file = packages / "plain" / "rqt_mrta.xml"
    file.write_text("<rqt_mrta>\n<architecture/><robots/></rqt_mrta>")
    (packages / "unknown" / "package.xml").write_text("<package>")

    told = command("list", "architectures")

    assert told.status == 0
    lines = {line.split()[1]: line for line in told.out.splitlines()}
    assert "  ! cannot be used: " in lines["plain"]
    assert "!" not in lines["spelt_out"]
    assert "unknown" not in lines
    said = told.err.splitlines()
    assert said[0] == (
        f"mrta: skipped: {packages / 'unknown' / 'package.xml'}:1: is not well-formed XML: "
        "Premature end of data in tag package line 1"
    )
    assert {line.split(": ")[2].partition(".xml")[0] for line in said[1:]} == {str(file)[: -len(".xml")]}


def test_list_reads_an_architecture_once_for_all_its_applications(
    command: Command, packages: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(50):
        register(packages / f"more_{number}", "application", APPLICATION.format(name=number, architecture="plain"))
    read: List[str] = []
    whole = Path.read_bytes

    def noted(path: Path) -> bytes:
        read.append(str(path))
        return whole(path)

    monkeypatch.setattr(Path, "read_bytes", noted)

    assert command("list", "applications").status == 0

    assert read.count(str(packages / "plain" / "rqt_mrta.xml")) == 1
