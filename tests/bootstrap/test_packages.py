"""The virtual environment and what pip puts into it, without a network."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from typing import List, Sequence

import pytest

from bootstrap import debian, environment, packages, sequence, shell
from tests.bootstrap.conftest import program


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """Give a checkout whose Python fails the probe's import of cv2 until pip ignores what is installed."""
    program(
        tmp_path / ".venv/bin",
        "python",
        f'cd "{tmp_path}"; echo "$*" >>calls.txt; case "$*" in\n'
        "*--ignore-installed*) touch mended;;\n"
        '*probe.py*) [ -e mended ] || echo "failed cv2 ImportError: numpy.core.multiarray";;\n'
        '*requires*) echo "numpy<3,>=1.24"; echo "opencv-python-headless<6,>=4.6; extra == \'plot\'";;\n'
        f'*purelib*) echo "{tmp_path}/site";;\n'
        "esac",
    )
    return tmp_path


def pip_calls(checkout: Path) -> List[str]:
    lines = (checkout / "calls.txt").read_text(encoding="utf-8").splitlines()
    return [line.partition("--no-input ")[2] for line in lines if " pip install" in line]


def test_what_does_not_import_is_installed_afresh_within_its_bounds(checkout: Path) -> None:
    packages.provide(checkout, "run")
    assert pip_calls(checkout) == ["--editable .[all]", "--ignore-installed opencv-python-headless<6,>=4.6"]


def test_rosrun_finds_one_mrta_in_a_checkout(checkout: Path) -> None:
    """It searches the whole package, .venv included, and asks which one is meant when there are two."""
    python = checkout / ".venv/bin/python"
    pips_way = '*--editable*) cp "$0" "${0%python}mrta";;\n*--ignore-installed*)'
    python.write_text(python.read_text(encoding="utf-8").replace("*--ignore-installed*)", pips_way), encoding="utf-8")
    packages.provide(checkout, "run")
    assert [path.name for path in (checkout / ".venv/bin").iterdir()] == ["python"]


def test_what_does_not_import_even_afresh_is_told(checkout: Path) -> None:
    python = checkout / ".venv/bin/python"
    python.write_text(python.read_text(encoding="utf-8").replace("touch mended", ":"), encoding="utf-8")
    with pytest.raises(shell.SetupError, match=r"not to be imported:\n    cv2: ImportError: numpy\.core\.multiarray"):
        packages.provide(checkout, "test")
    assert pip_calls(checkout)[0] == "--editable .[all,test]"


def test_a_crash_is_laid_at_the_door_of_the_module_that_was_being_imported(checkout: Path) -> None:
    program(checkout / ".venv/bin", "python", "echo begin numpy; echo begin lxml.etree; exit 139")
    assert packages.failing_imports(checkout) == {"lxml.etree": "the interpreter ended with 139"}


def test_the_probe_tells_failures_from_successes(tmp_path: Path) -> None:
    (tmp_path / "unfit.py").write_text(
        "import warnings; warnings.warn('A NumPy version >=1 and <2 is required')\n", "utf-8"
    )
    (tmp_path / "broken.py").write_text("raise ValueError('size changed')\n", "utf-8")
    (tmp_path / "sound.py").write_text("import warnings; warnings.warn('an everyday matter')\n", "utf-8")
    probe = Path(packages.__file__).with_name("probe.py")
    code = (
        f"import sys, runpy; sys.path.insert(0, {str(tmp_path)!r}); runpy.run_path({str(probe)!r}, run_name='__main__')"
    )
    command = [sys.executable, "-c", code, "unfit", "broken", "sound"]
    answer = subprocess.run(command, capture_output=True, text=True, check=True)
    assert answer.stdout.splitlines() == [
        "begin unfit",
        "failed unfit UserWarning: A NumPy version >=1 and <2 is required",
        "begin broken",
        "failed broken ValueError: size changed",
        "begin sound",
    ]


def test_a_killed_pip_leaves_a_mark_and_a_failed_one_does_not(checkout: Path) -> None:
    program(checkout / ".venv/bin", "python", "exit 1")
    with pytest.raises(shell.SetupError, match=r"pip could not install \.\[all\]"):
        packages.provide(checkout, "run")
    assert not environment.mark(checkout).exists()
    program(checkout / ".venv/bin", "python", "kill -9 $$")
    with pytest.raises(shell.SetupError):
        packages.provide(checkout, "run")
    assert environment.mark(checkout).exists()


def test_every_compiled_dependency_is_declared(root: Path) -> None:
    declared = (root / "setup.py").read_text(encoding="utf-8")
    for name in packages.COMPILED.values():
        assert f'"{name}>=' in declared


def test_every_declared_dependency_that_is_compiled_is_imported(root: Path) -> None:
    """pillow, for one, was installed and never tried."""
    text = (root / "setup.py").read_text(encoding="utf-8")
    used = text[: text.index('EXTRAS["compiled"]')] + text[text.index("install_requires") :]
    pure = {"pluggy", "rich"}
    assert set(re.findall(r'"([\w-]+)>=', used)) == {*packages.COMPILED.values(), *pure}


def test_without_ensurepip_and_virtualenv_the_package_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    bare = program(tmp_path / "bin", "python3", "exit 1")
    monkeypatch.setattr(sys, "executable", str(bare))
    monkeypatch.setattr(debian, "provide", lambda level, ros_elsewhere: False)
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    monkeypatch.setenv("MRTA_NO_APT", "1")
    monkeypatch.setattr(sequence, "__file__", str(tmp_path / "bootstrap" / "sequence.py"))
    assert sequence.main(["run", "all"]) == 4
    assert capsys.readouterr().err == (
        f"rqt_mrta_py: {bare} has neither ensurepip nor virtualenv; install the package python3-venv\n"
    )


def test_virtualenv_serves_where_ensurepip_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    bare = program(
        tmp_path / "bin",
        "python3",
        'case "$*" in *"import virtualenv"*) exit 0;; *-I*) exit 1;; esac; echo "$*" >>'
        + str(tmp_path / "calls.txt")
        + "; exit 7",
    )
    monkeypatch.setattr(sys, "executable", str(bare))
    monkeypatch.setenv("MRTA_NO_APT", "1")
    with pytest.raises(shell.SetupError, match="virtual environment could not be made"):
        environment.provide(tmp_path, remake=True)
    expected = f"-m virtualenv --system-site-packages --clear {tmp_path}/.venv\n"
    assert (tmp_path / "calls.txt").read_text(encoding="utf-8") == expected


@pytest.mark.parametrize(("apt_works", "expected"), [(True, "-m venv"), (False, "-m virtualenv")])
def test_without_ensurepip_apt_is_asked_before_virtualenv_serves(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, apt_works: bool, expected: str
) -> None:
    """virtualenv, where it was at hand, once kept python3-venv from being asked for."""
    calls, ensurepip = tmp_path / "calls.txt", tmp_path / "ensurepip"
    bare = program(
        tmp_path / "bin",
        "python3",
        f'case "$*" in *"import ensurepip"*) [ -e "{ensurepip}" ]; exit;; *-I*) exit 0;; esac\n'
        f'echo "$*" >>"{calls}"; exit 7',
    )
    program(tmp_path / "bin", "apt-get", "exit 0")

    def install(asked: Sequence[str]) -> None:
        assert asked == ["python3-venv"]
        if apt_works:
            ensurepip.touch()

    monkeypatch.setattr(sys, "executable", str(bare))
    monkeypatch.setattr(debian, "install", install)
    monkeypatch.setenv("PATH", f"{tmp_path}/bin:/usr/bin:/bin")
    monkeypatch.delenv("MRTA_NO_APT", raising=False)
    with pytest.raises(shell.SetupError, match="virtual environment could not be made"):
        environment.provide(tmp_path, remake=True)
    assert calls.read_text(encoding="utf-8").startswith(f"{expected} --system-site-packages")


def test_the_users_pip_and_python_settings_do_not_reach_the_set_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", "/opt/ros/noetic/lib/python3/dist-packages")
    monkeypatch.setenv("PIP_TARGET", "/somewhere")
    monkeypatch.setenv("PIP_INDEX_URL", "https://index.example/simple")
    kept = shell.clean_environment()
    assert "PYTHONPATH" not in kept
    assert "PIP_TARGET" not in kept
    assert kept["PYTHONNOUSERSITE"] == "1"
    # A pip.conf with "user = true" once ended the set-up: pip asks the environment first.
    assert kept["PIP_USER"] == "0"
    assert kept["PIP_INDEX_URL"] == "https://index.example/simple"
