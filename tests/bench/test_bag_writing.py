from __future__ import annotations

from pathlib import Path

from bench.bag_writing import measure_bag_writing


def test_both_writers_are_measured_with_every_compression_and_leave_nothing(tmp_path: Path) -> None:
    rows = measure_bag_writing(connections=5, messages=200, folder=tmp_path)
    assert [(row.compression, row.connections, row.messages) for row in rows] == [
        ("none", 5, 200),
        ("bz2", 5, 200),
        ("lz4", 5, 200),
    ]
    assert all(row.ours > 0 and row.stock > 0 for row in rows)
    assert list(tmp_path.iterdir()) == []
