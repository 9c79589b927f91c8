"""Hostile bags are salvaged and reviewed, or refused in one line: never a crash, a hang, or memory without end."""

from __future__ import annotations

import json
import multiprocessing
import os
import random
import re
import tracemalloc
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Tuple

import pytest

from rqt_mrta_py.transport import Compression, read_bag
from tests.app.bag_mutations import MUTATIONS, injected, mutated, recording
from tests.app.hostile_bags import examine_many, limit_memory
from tests.app.outputs import Mrta
from tests.transport.bag_bytes import bag, connection_record

QUICK = 40
LONG = 100_000
"""Hostile bags."""

AT_ONCE = 500
"""Hostile bags that one process examines between two reports; a crash of the process tells as much of its place."""


def test_hostile_bags_are_read_or_refused() -> None:
    assert examine_many(0, QUICK) == []


@pytest.mark.long
@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="limits of memory are those of Linux")
def test_very_many_hostile_bags_are_read_or_refused() -> None:
    """In processes of their own, each with a limit of memory; what kills one of them fails the test."""
    with ProcessPoolExecutor(
        os.cpu_count() or 1, mp_context=multiprocessing.get_context("spawn"), initializer=limit_memory
    ) as processes:
        begins = range(QUICK, QUICK + LONG, AT_ONCE)
        wrong = [verdict for found in processes.map(examine_many, begins, [AT_ONCE] * len(begins)) for verdict in found]
    assert wrong == []


def test_every_mutation_makes_bags_hostile(root: Path, tmp_path: Path) -> None:
    """But for the one that leaves them alone: what is in some recordings is hostile already."""
    whole = recording(root, tmp_path / "m.bag", Compression.LZ4, random.Random(1), hostile=False)
    for name, mutate in MUTATIONS:
        made = []
        for seed in range(20):
            data = bytearray(whole)
            mutate(random.Random(seed), data)
            made.append(bytes(data))
        changed = {content for content in made if content != whole}
        assert (len(changed) > 5) == (name != "nothing"), name
    assert mutated(random.Random(5), whole) == mutated(random.Random(5), whole)


def test_the_highest_number_of_a_connection_takes_no_memory(tmp_path: Path) -> None:
    """A table of places up to the highest number took 32 GiB; found by the campaign."""
    highest = 2**32 - 2
    connections = [connection_record(0, "/a"), connection_record(highest, "/b")]
    path = tmp_path / "m.bag"
    path.write_bytes(bag(connections, [[(0, 10**9, b"a"), (highest, 2 * 10**9, b"b")]]))
    tracemalloc.start()
    try:
        found = [(stamped.connection.topic, stamped.raw) for stamped in read_bag(path)]
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert found == [("/a", b"a"), ("/b", b"b")]
    assert peak < 2**24


@pytest.mark.parametrize(
    "wishes",
    [
        ("--pictures", "0", "--export", "csv"),
        pytest.param(
            ("--pictures", "2", "--export", "alliance_plots", "--figures", "alliance"), marks=pytest.mark.long
        ),
    ],
    ids=["in files", "in pictures too"],
)
def test_what_ids_topics_and_definitions_inject_stays_inert(
    root: Path, mrta: Mrta, tmp_path: Path, wishes: Tuple[str, ...]
) -> None:
    """No file but those of any review, and no text that a browser would take for anything but text."""
    folder = tmp_path / "there"
    folder.mkdir()
    injected(root, folder / "m.bag")
    before = set(tmp_path.rglob("*"))
    status, told = mrta(
        "review", str(folder / "m.bag"), "--architecture", "mrta_alliance", "--out", str(folder / "review"), *wishes
    )
    assert status == 0, told
    made = [path for path in tmp_path.rglob("*") if path not in before]
    review = folder / "review"
    assert all(path == review or review in path.parents for path in made)
    assert [path.name for path in made if not re.fullmatch(r"\w[\w.-]*", path.name)] == []
    for page in review.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert not [told for told in ("<script>alert", "<img src=x", "<svg/onload", "\x1b", "\0") if told in text]
    for picture in review.rglob("*.svg"):
        assert "<script" not in picture.read_text(encoding="utf-8")
    summary = json.loads((review / "summary.json").read_text(encoding="utf-8"))
    assert "</script><script>alert(1)</script>" in [robot["id"] for robot in summary["robots"]]
    assert all(line.isprintable() for line in told)
