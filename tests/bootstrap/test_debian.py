"""What is asked of apt, against programs that write down how they were called."""

from __future__ import annotations

import os
from pathlib import Path
from typing import List

import pytest

from bootstrap import debian
from tests.bootstrap.conftest import program

ABSENT = ("python3-rospy", "rosbash", "chromium", "cmake")
UNKNOWN = "rosbash"


class Apt:
    """A machine on which the packages of ABSENT are missing and one of them is unknown to apt."""

    def __init__(self, folder: Path) -> None:
        self.log = folder / "calls.txt"
        self.bin = folder / "bin"
        self.installed = folder / "installed"
        program(
            self.bin,
            "dpkg-query",
            f'shift 3; for p; do case " {" ".join(ABSENT)} " in\n'
            f'*" $p "*) grep -qx "$p" "{self.installed}" || continue;;\n'
            'esac; echo "$p installed"; done',
        )
        policy = f'[ "$p" = {UNKNOWN} ] && echo "  Candidate: (none)" || echo "  Candidate: 1.0-1"'
        program(self.bin, "apt-cache", f'shift; for p; do echo "$p:"; echo "  Installed: (none)"; {policy}; done')
        self.apt_get(0)
        self.installed.touch()

    def apt_get(self, code: int, refuses: str = "none-of-them") -> None:
        """Let installing end with a code, and refuse a certain package however the others fare."""
        program(
            self.bin,
            "apt-get",
            f'echo "$*" >>"{self.log}"; case "$*" in *update*) exit 0;;\n'
            f'*" {refuses}"*) echo "E: broken" >&2; exit 100;; esac; '
            f'[ {code} = 0 ] || exit {code}; while [ "$1" != install ]; do shift; done; shift; '
            f'for p; do echo "$p"; done >>"{self.installed}"',
        )

    def calls(self) -> List[List[str]]:
        """List what apt-get was asked to do: the verb and its packages."""
        lines = self.log.read_text(encoding="utf-8").split("\n")[:-1] if self.log.exists() else []
        options = {"-qq", "-y", "--no-install-recommends", "-o", "DPkg::Lock::Timeout=600", "Dpkg::Use-Pty=0"}
        return [[word for word in line.split() if word not in options] for line in lines]


@pytest.fixture
def apt(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Apt:
    machine = Apt(tmp_path)
    monkeypatch.setenv("PATH", f"{machine.bin}:/usr/bin:/bin")
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.delenv("MRTA_NO_APT", raising=False)
    return machine


def test_missing_packages_with_a_candidate_are_installed_together(apt: Apt, capsys: pytest.CaptureFixture[str]) -> None:
    assert debian.provide("test", ros_elsewhere=False) is False
    assert apt.calls() == [["update"], ["install", "python3-rospy", "cmake", "chromium"]]
    errors = capsys.readouterr().err
    assert "installing with apt-get: python3-rospy cmake chromium" in errors
    assert "rosbag tools: rosbash" in errors


def test_run_asks_for_less_than_test(apt: Apt) -> None:
    debian.provide("run", ros_elsewhere=False)
    assert apt.calls() == [["update"], ["install", "python3-rospy"]]


def test_debians_ros_never_joins_another_one(apt: Apt) -> None:
    debian.provide("test", ros_elsewhere=True)
    assert apt.calls() == [["update"], ["install", "cmake", "chromium"]]


def test_apt_is_left_alone_when_forbidden_and_that_is_said(
    apt: Apt, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("MRTA_NO_APT", "1")
    assert debian.provide("run", ros_elsewhere=False) is True
    assert apt.calls() == []
    assert "MRTA_NO_APT keeps out" in capsys.readouterr().err


def test_apt_is_left_alone_when_nothing_is_missing(apt: Apt, capsys: pytest.CaptureFixture[str]) -> None:
    apt.installed.write_text("\n".join(ABSENT) + "\n", encoding="utf-8")
    assert debian.provide("test", ros_elsewhere=False) is False
    assert apt.calls() == []
    assert capsys.readouterr().err == ""


def test_one_group_that_apt_refuses_does_not_sink_the_others(apt: Apt, capsys: pytest.CaptureFixture[str]) -> None:
    apt.apt_get(0, refuses="chromium")
    assert debian.provide("test", ros_elsewhere=False) is False
    assert apt.installed.read_text(encoding="utf-8").split() == ["python3-rospy", "cmake"]
    assert "report in a browser: chromium" in capsys.readouterr().err


def test_without_root_sudo_is_used_only_if_it_asks_for_no_password(
    apt: Apt, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    program(apt.bin, "sudo", "exit 1")
    debian.provide("run", ros_elsewhere=False)
    assert apt.calls() == []
    assert "apt-get needs root or a sudo that asks for no password" in capsys.readouterr().err
    program(apt.bin, "sudo", '[ "$1" = -n ] && shift && exec "$@"')
    debian.provide("run", ros_elsewhere=False)
    assert apt.calls() == [["update"], ["install", "python3-rospy"]]
    assert "installing with sudo -n apt-get: python3-rospy" in capsys.readouterr().err
