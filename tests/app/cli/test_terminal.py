"""Names from bags that hold a terminal's commands are shown, and do nothing."""

from __future__ import annotations

import io
import json
import logging
import sys
from pathlib import Path
from typing import Any, Dict, Optional, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console

from rqt_mrta_py.app.cli.common import ProgressLine
from rqt_mrta_py.app.cli.log_format import LogFormatter
from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.cli.table import table_lines
from rqt_mrta_py.app.cli.terminal import as_json, commanded, guarded_streams
from rqt_mrta_py.app.cli.watch_screen import ScreenDisplay
from rqt_mrta_py.app.outputs.results import MissionResult
from rqt_mrta_py.app.watch.view import WatchView
from rqt_mrta_py.model import (
    Allocation,
    ApplicationSpec,
    ArchitectureSpec,
    Incident,
    Mission,
    MissionRecord,
    Outcome,
    RobotRecord,
    Severity,
    Taxonomy,
)
from rqt_mrta_py.wording import printable
from tests.app.bag_mutations import injected
from tests.app.cli.conftest import Command
from tests.conftest import ROOT

RED = "\x1b[31mred\x07"
ESCAPED = r"\x1b[31mred\x07"
TAXONOMY = Taxonomy.parse("ST-SR-IA")


@pytest.fixture(scope="module")
def injected_bag(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Record robots, tasks, topics and nodes whose names nobody would choose who means well."""
    path = tmp_path_factory.mktemp("injected") / "m.bag"
    injected(ROOT, path)
    return path


@pytest.fixture(scope="module")
def injected_review(injected_bag: Path) -> Path:
    folder = injected_bag.parent / "review"
    wishes = ("--architecture", "mrta_alliance", "--pictures", "0", "-q")
    assert main(["review", str(injected_bag), *wishes, "--out", str(folder)]) == 0
    return folder


def test_characters_that_are_not_printable_are_escaped_as_python_does() -> None:
    assert printable("a\tb\nc") == r"a\tb\nc"
    assert printable("a\tb\nc", kept="\n") == "a\\tb\nc"
    assert printable("\x1b]0;title\x07 \x9b31m \u202e \udcff") == r"\x1b]0;title\x07 \x9b31m \u202e \udcff"
    assert printable("Größe 大 €") == "Größe 大 €"


@pytest.mark.parametrize(
    "wishes",
    [
        ("review", "--architecture", "mrta_alliance", "--pictures", "0"),
        ("review", "--architecture", "mrta_alliance", "--pictures", "0", "--json"),
        ("watch", "--architecture", "mrta_alliance", "--graph", "--no-follow"),
        ("watch", "--architecture", "mrta_alliance", "--graph", "--no-follow", "--json"),
        ("salvage", "--out", "saved.bag"),
        ("salvage", "--out", "saved.bag", "--json"),
    ],
    ids=" ".join,
)
def test_what_a_bag_holds_is_shown_as_text(injected_bag: Path, command: Command, wishes: Tuple[str, ...]) -> None:
    verb, *further = wishes
    told = command(verb, str(injected_bag), *further)
    assert told.status == 0, told.err
    for line in (*told.out.split("\n"), *told.err.split("\n")):
        assert line.isprintable(), repr(line)
    if "--json" in wishes:
        for document in [told.out] if verb != "watch" else told.out.splitlines():
            json.loads(document)
    elif verb != "review":
        # Nothing goes wrong in it that a review would tell of.
        assert ESCAPED in told.out


def test_a_line_of_the_bag_is_no_line_of_ours(injected_bag: Path, command: Command) -> None:
    r"""``a\nb`` is a robot, a task and a topic of that bag."""
    told = command("watch", str(injected_bag), "--architecture", "mrta_alliance", "--graph", "--no-follow")
    assert r"a\nb\tc" in told.out
    assert not [line for line in told.out.split("\n") if line.startswith("b")]


@pytest.mark.parametrize("wishes", [(), ("--json",)], ids=["text", "json"])
def test_what_a_summary_holds_is_shown_as_text(
    injected_review: Path, command: Command, tmp_path: Path, wishes: Tuple[str, ...]
) -> None:
    summary = json.loads((injected_review / "summary.json").read_text(encoding="utf-8"))
    other = tmp_path / "other.json"
    for allocation in summary["allocations"]:
        allocation["robot"] = "another"
    other.write_text(json.dumps({**summary, "application": RED}), encoding="utf-8")
    told = command("compare", str(injected_review), str(other), *wishes)
    assert told.status in (0, 1), told.err
    assert all(line.isprintable() for line in told.out.split("\n"))
    assert ESCAPED in told.out or json.loads(told.out)


def test_an_error_shows_the_name_it_is_about(command: Command) -> None:
    told = command("review", f"{RED}.bag")
    assert told.status == 3
    assert ESCAPED in told.err
    assert all(line.isprintable() for line in told.err.split("\n"))


def test_an_argument_that_is_refused_is_shown_as_text(command: Command) -> None:
    told = command("review", "m.bag", "--from", RED)
    assert told.status == 2
    assert all(line.isprintable() for line in told.err.split("\n"))


def test_a_log_line_is_one_line_of_text() -> None:
    record = logging.LogRecord("rqt_mrta_py.app", logging.WARNING, "f.py", 1, "topic=%s", (f"/a\n{RED}",), None)
    assert LogFormatter(tracebacks=False).format(record) == rf"WARNING rqt_mrta_py.app: topic=/a\n{ESCAPED}"


def test_a_cell_with_commands_is_as_wide_as_it_is_shown() -> None:
    assert table_lines(("TOPIC", "TYPE"), [(RED, "a/B"), ("/b", "c\nd")]) == [
        "TOPIC            TYPE",
        rf"{ESCAPED}  a/B",
        r"/b               c\nd",
    ]


def mission_record() -> MissionRecord:
    return MissionRecord(
        application=RED,
        architecture="auction",
        taxonomy=TAXONOMY,
        seed=None,
        start=10.0,
        end=25.0,
        robots=(RobotRecord("[bold]robot", (), 24.5), RobotRecord(RED, (), 24.5)),
        tasks=(),
        allocations=(Allocation(RED, RED, 12.0, 25.0, Outcome.OPEN),),
        incidents=(Incident("rule", Severity.ERROR, 12.0, 25.0, (), (), f"{RED}\nfell silent."),),
        events=(),
    )


def test_the_lines_of_a_review_are_those_of_its_incidents() -> None:
    result = MissionResult(Path("out"), mission_record(), {}, 15.0, 1.0)
    assert result.text().split("\n")[2:] == [rf"     2.0 s  error: {ESCAPED}\nfell silent.", "outputs: out"]


def test_tables_on_a_terminal_hold_neither_its_commands_nor_markup() -> None:
    mission = Mission(ApplicationSpec(RED, RED), ArchitectureSpec("auction", "Auction", TAXONOMY), ())
    written = io.StringIO()
    console = Console(file=written, width=120, height=30, highlight=False, force_terminal=False)
    with ScreenDisplay(console=console) as display:
        display.end(WatchView(mission, mission_record(), 7, None))
    assert "[bold]robot" in written.getvalue()
    assert written.getvalue().count(ESCAPED) >= 4
    assert all(line.rstrip().isprintable() for line in written.getvalue().split("\n"))


def test_what_is_printed_above_a_progress_bar_is_text(monkeypatch: pytest.MonkeyPatch) -> None:
    """While it draws its bar, rich takes over what is printed."""

    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setenv("TERM", "xterm")
    with guarded_streams(), ProgressLine("m.bag", quiet=0) as progress:
        progress(1.0, 10.0)
        sys.stderr.write(f"mrta: {RED}\n")
    assert sys.stderr is terminal
    assert ESCAPED in terminal.getvalue()
    assert "\x1b[31m" not in terminal.getvalue()
    assert "\x1b[" in terminal.getvalue(), "the bar is drawn by commands"


def test_guarded_streams_are_as_before_afterwards(monkeypatch: pytest.MonkeyPatch) -> None:
    out = io.StringIO()
    monkeypatch.setattr(sys, "stdout", out)
    with guarded_streams():
        sys.stdout.write(f"a\t{RED}\nb\n")
        assert commanded(sys.stdout) is out
        assert not sys.stdout.isatty()
    assert sys.stdout is out
    assert out.getvalue() == f"a\t{ESCAPED}\nb\n"
    assert commanded(out) is out


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text(),
    lambda values: st.lists(values, max_size=3) | st.dictionaries(st.text(), values, max_size=3),
    max_leaves=8,
)


@given(st.dictionaries(st.text(), JSON, max_size=3), st.sampled_from([None, 2]))
def test_json_of_any_text_is_printable_and_means_the_same(document: Dict[str, Any], indent: Optional[int]) -> None:
    text = as_json(document, indent)
    assert all(line.isprintable() for line in text.split("\n"))
    assert json.loads(text) == document
