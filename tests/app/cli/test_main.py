from __future__ import annotations

import pytest

from rqt_mrta_py.app.cli.main import main


@pytest.mark.parametrize("verb", ["review", "show", "salvage"])
def test_a_name_longer_than_files_have_is_wrong_usage(verb: str, capsys: pytest.CaptureFixture[str]) -> None:
    name = "x" * 300
    status = main([verb, name, *(["--out", "y"] if verb == "salvage" else [])])
    (line,) = capsys.readouterr().err.splitlines()
    assert status in (2, 3)
    assert line.startswith("mrta: ")
    assert "internal error" not in line
