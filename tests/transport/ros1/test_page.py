"""The example of the room's page that needs a master."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.ros_master import MasterProcess

pytestmark = pytest.mark.ros


def test_example_of_the_page_runs_and_prints_what_it_says(master: MasterProcess, root: Path) -> None:
    text = (root / "docs" / "rooms" / "transport.md").read_text(encoding="utf-8")
    ((code, printed),) = re.findall(r"```py\n(.*?)```\n+```text\n(.*?)```", text, re.DOTALL)
    done = subprocess.run(
        [sys.executable, "-c", code], env=master.environment, capture_output=True, text=True, timeout=60, check=False
    )
    assert (done.returncode, done.stdout) == (0, printed), done.stderr
