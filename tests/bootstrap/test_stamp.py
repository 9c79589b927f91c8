"""When a set-up is made again, and what it is told to do."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import time
from pathlib import Path
from typing import Callable

import pytest

from tests.bootstrap.conftest import Miniature


def wait_until(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + 30
    while not condition():
        assert time.monotonic() < deadline, "it did not come to pass within 30 s"
        time.sleep(0.01)


def test_a_second_call_sets_nothing_up(miniature: Miniature) -> None:
    miniature.run("list")
    miniature.run("list")
    assert miniature.set_ups() == ["run all"]


def test_a_set_up_for_tests_serves_run_but_not_the_other_way_round(miniature: Miniature) -> None:
    miniature.shell("bootstrap run")
    miniature.shell("bootstrap test")
    miniature.shell("bootstrap run")
    assert miniature.set_ups() == ["run all", "test all"]


def test_what_was_ready_for_tests_stays_so_when_run_renews_it(miniature: Miniature) -> None:
    miniature.shell("bootstrap test")
    (miniature.folder / "setup.py").write_text("# other dependencies\n", encoding="utf-8")
    miniature.shell("bootstrap run")
    miniature.shell("bootstrap test")
    assert miniature.set_ups() == ["test all", "test all"]


@pytest.mark.parametrize("source", ["setup.py", "bootstrap/packages.py", "bootstrap/stamp.sh"])
def test_a_changed_source_calls_for_all_steps(miniature: Miniature, source: str) -> None:
    miniature.run("list")
    with (miniature.folder / source).open("a", encoding="utf-8") as file:
        file.write("# changed\n")
    miniature.run("list")
    assert miniature.set_ups() == ["run all", "run all"]


@pytest.mark.parametrize(
    "definition",
    ["msg/Event.msg", "srv/Ask.srv", "plugins/messages/other_msgs/msg/Bid.msg", "plugins/applications/app/msg/At.msg"],
)
def test_a_changed_message_calls_for_message_classes_only(miniature: Miniature, definition: str) -> None:
    miniature.run("list")
    path = miniature.folder / definition
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("float64 cost\n", encoding="utf-8")
    miniature.run("list")
    path.write_text("float64 price\n", encoding="utf-8")
    miniature.run("list")
    assert miniature.set_ups() == ["run all", "run messages", "run messages"]


def test_a_copied_checkout_gets_a_new_environment(miniature: Miniature, tmp_path: Path) -> None:
    miniature.run("list")
    copy = tmp_path.resolve() / "copy"
    shutil.copytree(miniature.folder, copy, symlinks=True)
    assert miniature.call(str(copy / "run"), "list").returncode == 0
    assert (copy / "calls.txt").read_text(encoding="utf-8").splitlines() == ["run all", "run remake"]


def test_an_environment_whose_interpreter_is_gone_is_made_again(miniature: Miniature) -> None:
    miniature.run("list")
    python = miniature.folder / ".venv/bin/python"
    python.unlink()
    python.symlink_to("/nowhere/python3")
    assert miniature.run("list").returncode == 0
    assert len(miniature.set_ups()) == 2


@pytest.mark.parametrize("content", ["", "level\n", "\x00\x01", "level run\ncheckout elsewhere\n"])
def test_a_damaged_stamp_counts_as_none(miniature: Miniature, content: str) -> None:
    miniature.run("list")
    (miniature.folder / ".venv/set-up").write_text(content, encoding="utf-8")
    assert miniature.run("list").returncode == 0
    assert len(miniature.set_ups()) == 2


def test_a_set_up_that_failed_leaves_no_stamp(miniature: Miniature) -> None:
    miniature.run("list")
    miniature.fake_set_up("exit 4")
    miniature.run("list")
    assert not (miniature.folder / ".venv/set-up").exists()
    miniature.fake_set_up("echo settled")
    assert miniature.run("list").returncode == 0


def test_a_killed_set_up_is_taken_up_again(miniature: Miniature) -> None:
    miniature.fake_set_up("touch begun; exec sleep 60")
    process = subprocess.Popen(
        [str(miniature.folder / "run"), "list"],
        env=miniature.environment(),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    wait_until((miniature.folder / "begun").exists)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert not (miniature.folder / ".venv/set-up").exists()
    miniature.fake_set_up("echo settled")
    assert miniature.run("list").returncode == 0


def test_of_two_calls_at_once_the_second_waits_and_finds_the_work_done(miniature: Miniature, tmp_path: Path) -> None:
    # The first holds on until the second is seen waiting, so that nothing hangs on speed.
    miniature.fake_set_up("for i in $(seq 1500); do [ -e seen ] && break; sleep 0.02; done; echo settled")
    logs = [tmp_path / "first.txt", tmp_path / "second.txt"]
    both = []
    for log in logs:
        with log.open("w", encoding="utf-8") as errors:
            command = [str(miniature.folder / "run"), "list"]
            both.append(
                subprocess.Popen(command, env=miniature.environment(), stdout=subprocess.DEVNULL, stderr=errors)
            )
    waiting = "another set-up of this checkout is under way; waiting for it"
    wait_until(lambda: any(waiting in log.read_text(encoding="utf-8") for log in logs))
    (miniature.folder / "seen").touch()
    assert [process.wait(timeout=60) for process in both] == [0, 0]
    assert sum(waiting in log.read_text(encoding="utf-8") for log in logs) == 1
    assert miniature.set_ups() == ["run all"]


def test_packages_that_apt_was_kept_from_are_asked_for_once_it_is_allowed(miniature: Miniature) -> None:
    miniature.fake_set_up('if [ -n "$MRTA_NO_APT" ]; then echo owed; else echo settled; fi')
    miniature.run("list", MRTA_NO_APT="1")
    miniature.run("list", MRTA_NO_APT="1")
    assert miniature.set_ups() == ["run all"]
    miniature.run("list")
    miniature.run("list")
    miniature.run("list", MRTA_NO_APT="1")
    assert miniature.set_ups() == ["run all", "run all"]
