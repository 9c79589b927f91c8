"""Verbs that plugins add: listed, run, and told apart when they fail."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import List, Optional

import pytest

from tests.app.cli.conftest import Command

VERB = """
import sys
from rqt_mrta_py.hooks import UsageError, Verb, hookimpl


def add_arguments(parser):
    parser.add_argument("--times", type=int, default=1, help="100%% of it")


def main(options, tools):
{main}


@hookimpl
def mrta_register_verbs():
    return {{{name!r}: Verb("Greet 100% of the team.", add_arguments, main)}}
"""


def verb(main: str, name: str = "greet-all") -> str:
    return VERB.format(main=f"    {main}", name=name)


def test_a_verb_of_a_plugin_is_run_with_its_arguments_and_gives_its_status(command: Command, stranger: Path) -> None:
    stranger.write_text(verb("print('hello ' * options.times + str(options.verbose)); return 1"))

    assert command("greet-all", "--times", "2", "-v") == (1, "hello hello 1\n", "")


def test_the_help_page_lists_verbs_of_plugins(command: Command, stranger: Path) -> None:
    stranger.write_text(verb("return 0"))

    told = command("--help")

    assert told.status == 0
    section = told.out.partition("verbs of plugins:\n")[2]
    assert ("greet-all", "Greet 100% of the team.") in [
        (name, says.strip()) for name, _, says in (line.strip().partition(" ") for line in section.splitlines())
    ]


def test_a_verb_of_a_plugin_has_a_help_page_of_its_own(command: Command, stranger: Path) -> None:
    stranger.write_text(verb("return 0"))

    told = command("greet-all", "--help")

    assert told.status == 0
    assert "Greet 100% of the team." in told.out
    assert "--times TIMES" in told.out


def test_the_help_page_stands_even_if_a_plugin_is_broken(command: Command, stranger: Path) -> None:
    stranger.write_text("from rqt_mrta_py.hooks import hookimpl\n\n\n@hookimpl\ndef mrta_on_evnt(event):\n    pass\n")

    told = command("--help")

    assert told.status == 0
    assert "verbs of plugins cannot be told: plugin 'stranger_plugin': mrta_on_evnt(event)" in told.out


@pytest.mark.parametrize(
    ("main", "status", "message"),
    [
        ("raise UsageError('greet-all: whom?')", 2, "greet-all: whom?"),
        ("return [][0]", 3, "plugin 'stranger_plugin': verb 'greet-all': IndexError: list index out of range"),
        ("return None", 3, "plugin 'stranger_plugin': verb 'greet-all': returned None; an exit status is needed"),
    ],
)
def test_a_verb_that_fails_is_told_in_one_line(
    command: Command, stranger: Path, main: str, status: int, message: str
) -> None:
    stranger.write_text(verb(main))

    assert command("greet-all") == (status, "", f"mrta: {message}\n")


@pytest.mark.parametrize(("first", "left"), [("", None), ("folder.write('x', ''); ", ["x"])])
def test_a_verb_that_fails_leaves_no_empty_folder(
    command: Command, stranger: Path, tmp_path: Path, first: str, left: Optional[List[str]]
) -> None:
    out = tmp_path / "out"
    stranger.write_text(
        verb(f"from pathlib import Path; folder = tools.folder(Path({str(out)!r})); {first}raise UsageError('no')")
    )

    assert command("greet-all") == (2, "", "mrta: no\n")
    assert (sorted(each.name for each in out.iterdir()) if out.exists() else None) == left


def test_a_folder_that_was_there_before_stays(command: Command, stranger: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.mkdir()
    stranger.write_text(verb(f"from pathlib import Path; tools.folder(Path({str(out)!r})); raise UsageError('no')"))

    assert command("greet-all") == (2, "", "mrta: no\n")
    assert out.exists()


def test_a_verb_whose_help_page_cannot_be_written_is_told_by_name(command: Command, stranger: Path) -> None:
    stranger.write_text(verb("return 0").replace("100%% of it", "100% done"))

    told = command("greet-all", "--help")

    assert (told.status, told.out) == (3, "")
    assert told.err.startswith("mrta: plugin 'stranger_plugin': verb 'greet-all': its help page: ")


def test_a_verb_whose_arguments_clash_is_told_by_name(command: Command, stranger: Path) -> None:
    stranger.write_text(verb("return 0").replace('"--times"', '"-v"'))

    told = command("greet-all")

    assert told.status == 3
    assert told.err.startswith("mrta: plugin 'stranger_plugin': verb 'greet-all': add_arguments: ArgumentError: ")
    assert len(told.err.splitlines()) == 1


def test_wrong_usage_of_a_verb_exits_with_2_and_one_line(command: Command, stranger: Path) -> None:
    stranger.write_text(verb("return 0"))

    told = command("greet-all", "--tims", "2")

    assert (told.status, told.err) == (
        2,
        "mrta greet-all: unrecognized arguments: --tims 2; see mrta greet-all --help\n",
    )


def test_a_mistyped_verb_exits_with_2_and_names_the_nearest(command: Command, stranger: Path) -> None:
    stranger.write_text(verb("return 0"))

    assert command("greet-al") == (2, "", "mrta: greet-al: there is no such verb; nearest is 'greet-all'\n")
    assert command("reviwe") == (2, "", "mrta: reviwe: there is no such verb; nearest is 'review'\n")


def test_a_verb_named_like_one_of_ours_is_left_out_with_a_warning(
    command: Command, stranger: Path, caplog: pytest.LogCaptureFixture
) -> None:
    stranger.write_text(verb("return 0", name="list"))

    told = command("--help")

    assert "Greet" not in told.out
    assert caplog.messages == ["plugin 'stranger_plugin': verb 'list' is one of the command's own and is left out"]


def test_our_own_verbs_load_no_plugin(command: Command, stranger: Path) -> None:
    stranger.write_text("raise RuntimeError('imported')\n")

    assert (command("list").err, command("list", "--help").err) == ("", "")
    assert "stranger_plugin" not in sys.modules


def test_a_reader_who_has_gone_is_no_error_of_a_verb(stranger: Path) -> None:
    stranger.write_text(verb("print('x' * 1000000); return 0"))
    reading, writing = os.pipe()
    os.close(reading)

    with os.fdopen(writing, "wb") as pipe:
        done = subprocess.run(
            [sys.executable, "-m", "rqt_mrta_py", "greet-all"], check=False, stdout=pipe, stderr=subprocess.PIPE
        )

    assert (done.returncode, done.stderr) == (0, b"")


def test_an_interrupted_verb_exits_with_130(stranger: Path) -> None:
    stranger.write_text(verb("print('ready', flush=True); import time; time.sleep(60)"))
    process = subprocess.Popen(
        [sys.executable, "-m", "rqt_mrta_py", "greet-all"], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    with process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"ready\n"
        time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=30)

    assert (process.returncode, errors) == (130, b"")
