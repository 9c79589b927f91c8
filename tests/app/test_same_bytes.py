"""The same application, arguments and seed write the same bytes, wherever and however they are run."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from pathlib import Path
from typing import Dict

FILES = ("mission.bag", "summary.json", "events.jsonl", "incidents.jsonl")


def run(folder: Path, hash_seed: str, seed: str) -> Dict[str, str]:
    """Run the mission in a process of its own and give the digest of each file."""
    folder.mkdir()
    environment = {**os.environ, "PYTHONHASHSEED": hash_seed}
    command = [sys.executable, "-m", "rqt_mrta_py", "run", "border_patrol", "--seed", seed, "--duration", "25", "-q"]
    subprocess.run([*command, "--out", str(folder / "out")], check=True, cwd=str(folder), env=environment, timeout=300)
    return {name: hashlib.sha256((folder / "out" / name).read_bytes()).hexdigest() for name in FILES}


def test_two_processes_folders_and_hash_seeds_write_the_same_bytes(tmp_path: Path) -> None:
    first = run(tmp_path / "here", hash_seed="1", seed="5")
    second = run(tmp_path / "a longer folder with blanks", hash_seed="4711", seed="5")
    assert second == first


def test_another_seed_writes_another_bag(tmp_path: Path) -> None:
    first = run(tmp_path / "first", hash_seed="1", seed="5")
    other = run(tmp_path / "other", hash_seed="1", seed="6")
    assert other["mission.bag"] != first["mission.bag"]
