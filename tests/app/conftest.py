"""One mission of border_patrol, run once and looked at by many tests."""

from __future__ import annotations

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Outputs


@pytest.fixture(scope="session")
def patrol(tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Run border_patrol for 150 s: robot3 is lost at 60 s, robot2 is away from 100 to 135 s."""
    folder = tmp_path_factory.mktemp("patrol") / "run"
    status = main(["run", "border_patrol", "--duration", "150", "--pictures", "10", "--out", str(folder), "-q"])
    assert status == 0
    return Outputs(folder)


@pytest.fixture(scope="session")
def patrol_review(patrol: Outputs, tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Review the bag of that run."""
    folder = tmp_path_factory.mktemp("patrol") / "review"
    status = main(["review", str(patrol.bag), "--pictures", "10", "--out", str(folder), "-q"])
    assert status == 0
    return Outputs(folder)
