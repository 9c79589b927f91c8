"""The comparison of discovery with rospack measures both on the same trees."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from bench.discovery import main, measure_discovery


def test_trees_with_no_some_and_all_packages_registering_are_measured_and_removed(tmp_path: Path) -> None:
    rows = measure_discovery(packages=20, folder=tmp_path, turns=1)

    assert [(row.packages, row.registering) for row in rows] == [(20, 0), (20, 2), (20, 20)]
    assert all(row.ours > 0 and row.command > 0 for row in rows)
    assert all((row.rospack is None) == (shutil.which("rospack") is None) for row in rows)
    assert list(tmp_path.iterdir()) == []


def test_the_table_compares_discovery_with_rospack_by_their_ratio(capsys: pytest.CaptureFixture[str]) -> None:
    main(["--packages", "10", "--turns", "1"])

    title, head, *rows = capsys.readouterr().out.splitlines()
    assert title == "Seconds to find what 10 packages register"
    assert head.split() == ["registering", "discover", "rospack", "ratio", "mrta", "list"]
    assert [row.split()[0] for row in rows] == ["0", "1", "10"]


def test_a_tree_of_no_packages_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["--packages", "0"])

    assert "--packages and --turns must be at least 1" in capsys.readouterr().err
