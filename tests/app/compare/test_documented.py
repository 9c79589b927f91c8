from __future__ import annotations

import re
from pathlib import Path

from rqt_mrta_py.app.compare.figures import DEFAULT_TOLERANCES
from rqt_mrta_py.config.tolerances import read_tolerances

PAGE = (Path(__file__).resolve().parents[3] / "docs" / "compare.md").read_text(encoding="utf-8")


def test_the_tolerances_of_the_house_are_those_of_the_documentation() -> None:
    rows = re.findall(r"^\| `(\S+)` \| (\w+) \| ([\d.]+) \| ([\d.]+) \|$", PAGE, re.MULTILINE)
    assert [(figure, worse, float(relative), float(absolute)) for figure, worse, relative, absolute in rows] == [
        (each.figure, each.worse.value, each.relative, each.absolute) for each in DEFAULT_TOLERANCES
    ]


def test_the_example_of_the_documentation_is_read() -> None:
    (example,) = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)
    assert len(read_tolerances(example, "t.yaml")) == 4
