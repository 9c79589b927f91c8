"""./run as its caller sees it."""

from __future__ import annotations

from pathlib import Path

from tests.bootstrap.conftest import Miniature, program


def test_run_passes_arguments_on_as_they_are(miniature: Miniature) -> None:
    result = miniature.run("list", "two words", "", "*", "--json")
    assert result.stdout.splitlines()[1:] == ["<list>", "<two words>", "<>", "<*>", "<--json>"]


def test_run_without_arguments_runs_the_border_patrol(miniature: Miniature) -> None:
    assert miniature.run().stdout.splitlines()[1:] == ["<run>", "<border_patrol>"]


def test_run_keeps_the_callers_folder(miniature: Miniature, tmp_path: Path) -> None:
    elsewhere = tmp_path.resolve() / "else where"
    elsewhere.mkdir()
    assert miniature.run("list", folder=elsewhere).stdout.splitlines()[0] == str(elsewhere)


def test_run_gives_back_the_exit_code_of_mrta(miniature: Miniature) -> None:
    assert miniature.run("doctor", MRTA_TEST_EXIT="3").returncode == 3


def test_run_works_through_a_symbolic_link(miniature: Miniature, tmp_path: Path) -> None:
    link = tmp_path / "mrta-run"
    link.symlink_to(miniature.folder / "run")
    assert "<list>" in miniature.call(str(link), "list").stdout


def test_run_speaks_of_the_set_up_on_stderr_only(miniature: Miniature) -> None:
    miniature.fake_set_up("echo installing >&2; echo settled")
    result = miniature.run("list", folder=miniature.folder)
    assert result.stdout.splitlines() == [str(miniature.folder), "<list>"]
    assert "installing" in result.stderr


def test_run_is_silent_when_nothing_needs_doing(miniature: Miniature) -> None:
    miniature.run("list")
    assert miniature.run("list").stderr == ""


def test_run_ends_with_the_code_of_a_set_up_that_failed(miniature: Miniature) -> None:
    miniature.fake_set_up("exit 4")
    result = miniature.run("list")
    assert (result.returncode, result.stdout) == (4, "")


def test_run_appends_the_checkout_to_the_users_ros_packages(miniature: Miniature) -> None:
    own = f"{miniature.folder}:{miniature.folder}/plugins"
    script = 'bootstrap run; append_to_ros_path; printf "%s" "$ROS_PACKAGE_PATH"'
    assert miniature.shell(script, ROS_PACKAGE_PATH="/mine/src").stdout == f"/mine/src:{own}"
    assert miniature.shell(script).stdout == own


def test_test_shares_tests_among_processes_unless_its_caller_says_otherwise(miniature: Miniature) -> None:
    python = program(miniature.folder / "bin", "python", 'printf "<%s>\\n" "${PYTHONDONTWRITEBYTECODE-unset}" "$@"')
    miniature.fake_set_up(f"ln -sf '{python}' .venv/bin/python; echo settled")
    result = miniature.call(str(miniature.folder / "test"), "-n", "0", "two words", PYTHONDONTWRITEBYTECODE="1")
    assert result.stdout.splitlines() == [
        *("<unset>", "<-m>", "<pytest>"),
        *("<--numprocesses>", "<auto>", "<--maxprocesses>", "<8>", "<--dist>", "<worksteal>"),
        *("<-n>", "<0>", "<two words>"),
    ], result.stderr
