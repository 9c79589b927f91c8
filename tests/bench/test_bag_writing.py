from __future__ import annotations

from pathlib import Path

import pytest

from bench.bag_writing import main, measure_bag_writing


def test_both_writers_are_measured_with_every_compression_and_leave_nothing(tmp_path: Path) -> None:
    rows = measure_bag_writing(connections=5, messages=200, folder=tmp_path)
    assert [(row.compression, row.connections, row.messages) for row in rows] == [
        ("none", 5, 200),
        ("bz2", 5, 200),
        ("lz4", 5, 200),
    ]
    assert all(min(row.ours, row.together, row.stock) > 0 for row in rows)
    # Without compression a bag is longer than its messages.
    assert min(rows[0].our_bytes, rows[0].stock_bytes) > 200 * (52 + 83 + 207 + 727) / 4
    assert list(tmp_path.iterdir()) == []


def test_the_table_compares_both_writers_by_their_ratio(capsys: pytest.CaptureFixture[str]) -> None:
    main(["--connections", "5", "--messages", "200"])
    title, head, *rows = capsys.readouterr().out.splitlines()
    assert title == "Messages a second of CPU time: 200 messages of 5 connections"
    assert head.split() == ["compression", "BagWriter", "together", "rosbags", "ratio", "our", "MB", "their", "MB"]
    assert [row.split()[0] for row in rows] == ["none", "bz2", "lz4"]
    for row in rows:
        ours, _, stock, ratio, _, _ = map(float, row.split()[1:])
        assert ratio == pytest.approx(ours / stock, abs=0.02)
