"""Which Python the environment is built on."""

from __future__ import annotations

from pathlib import Path

from tests.bootstrap.conftest import Miniature, program

NEW = "echo {}"
# An interpreter that is too old fails the question that it is asked.
OLD = "exit 1"


def test_the_systems_python_goes_first(miniature: Miniature, tmp_path: Path) -> None:
    system = program(tmp_path / "system", "python3", NEW.format("system"))
    program(tmp_path / "mine", "python3", NEW.format("mine"))
    found = miniature.shell(f"find_python '{system}'", PATH=f"{tmp_path}/mine:/usr/bin:/bin")
    assert found.stdout == "system\n"


def test_python3_from_the_path_serves_when_the_systems_is_too_old(miniature: Miniature, tmp_path: Path) -> None:
    system = program(tmp_path / "system", "python3", OLD)
    program(tmp_path / "mine", "python3", NEW.format("mine"))
    found = miniature.shell(f"find_python '{system}'", PATH=f"{tmp_path}/mine:/usr/bin:/bin")
    assert found.stdout == "mine\n"


def test_a_shim_comes_last_and_is_resolved(miniature: Miniature, tmp_path: Path) -> None:
    program(tmp_path / ".pyenv/shims", "python3", NEW.format("/versions/3.11/bin/python3"))
    program(tmp_path / "mine", "python3", NEW.format("mine"))
    search = f"{tmp_path}/.pyenv/shims:{tmp_path}/mine:{tmp_path}/no python here"
    assert miniature.shell(f"PATH='{search}'; find_python /nowhere").stdout == "mine\n"
    search = f"{tmp_path}/.pyenv/shims:{tmp_path}/no python here"
    assert miniature.shell(f"PATH='{search}'; find_python /nowhere").stdout == "/versions/3.11/bin/python3\n"


def test_the_checkouts_own_environment_is_never_built_upon(miniature: Miniature) -> None:
    program(miniature.folder / ".venv/bin", "python3", NEW.format("itself"))
    found = miniature.shell(f"PATH='{miniature.folder}/.venv/bin'; find_python /nowhere")
    assert (found.returncode, found.stdout) == (1, "")


def test_without_any_python_the_missing_packages_are_named(miniature: Miniature) -> None:
    result = miniature.shell("find_python() { return 1; }; bootstrap run", MRTA_NO_APT="1")
    assert result.returncode == 4
    assert result.stderr == (
        "rqt_mrta_py: no Python from 3.8 on was found; install the packages python3 and python3-venv\n"
    )
