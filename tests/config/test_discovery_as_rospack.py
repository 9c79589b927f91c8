"""Discovery case by case, and the same cases put to rospack where it is installed."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import List, Set, Tuple

import pytest

from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.search import discover
from tests.config.discovery_cases import CASES, HOSTS, Case

KINDS = (RegistrationKind.APPLICATION, RegistrationKind.ARCHITECTURE)


@pytest.fixture(params=CASES, ids=lambda case: case.name)
def case(request: pytest.FixtureRequest, tmp_path: Path) -> Case:
    """Write the packages of one case."""
    chosen: Case = request.param
    for name, content in {**chosen.files, **(HOSTS if chosen.hosts else {})}.items():
        path = tmp_path / name
        if name.endswith("/"):
            path.mkdir(parents=True)
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
    for link, target in chosen.links:
        (tmp_path / link).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / link).symlink_to(tmp_path / target)
    return chosen


def path_of(case: Case, root: Path) -> str:
    return os.pathsep.join(str(root / entry) for entry in (*case.entries, "hosts"))


def search(case: Case, root: Path) -> Registry:
    return discover({"ROS_PACKAGE_PATH": path_of(case, root)}, "/nowhere", (), (), ())


def test_discovery_finds_what_the_table_says(case: Case, tmp_path: Path) -> None:
    found = [
        f"{entry.kind.value} {entry.package} {entry.file.relative_to(tmp_path) if entry.file else ''}".rstrip()
        for entry in search(case, tmp_path).registrations
        if entry.kind in KINDS
    ]

    assert sorted(found) == sorted(case.found)


@pytest.mark.ros
def test_rospack_lists_what_the_table_says(case: Case, tmp_path: Path) -> None:
    if shutil.which("rospack") is None:
        pytest.skip("ROS 1 is not installed: no rospack on PATH")

    listed = {line for kind, host in questions(case) for line in ask(case, tmp_path, host, kind)}

    expected = case.found if case.rospack is None else case.rospack
    if case.either:
        assert len(listed) == 1
        assert listed <= set(expected)
    else:
        assert listed == set(expected)


def questions(case: Case) -> List[Tuple[RegistrationKind, str]]:
    """Choose what to ask: of the words that stand in no manifest of the case rospack can know nothing."""
    texts = [content if isinstance(content, str) else content.decode("latin-1") for content in case.files.values()]
    text = "".join(texts).replace("\0", "")
    hosts = ("rqt_mrta", "rqt_mrta_py") if "rqt_mrta_py" in text else ("rqt_mrta",)
    return [(kind, host) for kind in KINDS if f"{kind.value}=" in text for host in hosts] or [(KINDS[1], "rqt_mrta")]


def ask(case: Case, root: Path, host: str, kind: RegistrationKind) -> List[str]:
    """Ask rospack for the packages of one kind; nothing where it fails, which its status must tell."""
    environment = {
        "PATH": os.environ["PATH"],
        "HOME": str(root),
        "ROS_HOME": str(root),
        "ROS_PACKAGE_PATH": path_of(case, root),
        "ROS_CACHE_TIMEOUT": "0",
    }
    done = subprocess.run(
        ["rospack", "plugins", f"--attrib={kind.value}", host],
        env=environment,
        cwd=str(root),
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 0 or not done.stdout
    lines = (line.partition(" ") for line in done.stdout.splitlines())
    return [f"{kind.value} {name} {relative(file, root)}" for name, _, file in lines]


def relative(file: str, root: Path) -> str:
    """Write a path as the table does: from the root, and a path through a loop with the number of turns."""
    from_root = file[len(f"{root}/") :] if file.startswith(f"{root}/") else file.replace(str(root), "{root}")
    return re.sub(r"(loop/)+", lambda turns: f"{{{len(turns.group()) // len('loop/')}}}", from_root)


def test_cases_cover_every_row_of_the_page_and_no_other(root: Path) -> None:
    text = (root / "docs" / "rooms" / "config.md").read_text(encoding="utf-8")
    section = text.partition("## Discovery\n")[2].partition("\n## ")[0]
    found, _, otherwise = section.partition("### ")

    assert rows(found) == {case.row for case in CASES if case.rospack is None}
    assert rows(otherwise) == {case.row for case in CASES if case.rospack is not None}


def rows(text: str) -> Set[str]:
    """Give the first cells of a table."""
    lines = [line.split(" | ")[0].lstrip("| ") for line in text.splitlines() if line.startswith("| ")]
    return set(lines[1:])


def test_discovery_visits_a_folder_once_by_the_first_path_to_it(tmp_path: Path) -> None:
    for link in ("ws/b", "ws/a"):
        (tmp_path / link).parent.mkdir(exist_ok=True)
        (tmp_path / link).symlink_to(tmp_path / "real")
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "package.xml").write_text("<package><name>p</name></package>")

    registry = discover({"ROS_PACKAGE_PATH": str(tmp_path / "ws")}, "/nowhere", (), (), ())

    assert registry.packages == {"p": tmp_path / "ws" / "a"}
