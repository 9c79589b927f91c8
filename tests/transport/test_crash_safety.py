"""What is left of a recording whose process, disk or folder went away."""

from __future__ import annotations

import errno
import os
import random
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Callable, Iterator, List, Tuple

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagWriter, Compression, read_bag
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk
from rqt_mrta_py.transport.bags.records import MAGIC, file_header
from tests.sampling import every
from tests.transport.endless import REPORT, endless
from tests.transport.support import ROOT, require_ros, run_ros

SECOND = 10**9
COMPRESSIONS = list(Compression)
ENVIRONMENT = {**os.environ, "PYTHONPATH": f"{ROOT / 'src'}{os.pathsep}{ROOT}"}


def killed_recording(path: Path, seed: int, compression: Compression) -> Tuple[int, int]:
    """Kill a process at some moment while it writes; give number and receipt of the last message it reported."""
    script = (
        "import pathlib, sys\n"
        "from rqt_mrta_py.transport import Compression\n"
        "from tests.transport.endless import record_for_ever\n"
        "record_for_ever(pathlib.Path(sys.argv[1]), int(sys.argv[2]), Compression(sys.argv[3]))\n"
    )
    command = [sys.executable, "-c", script, str(path), str(seed), compression.value]
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=ENVIRONMENT) as child:
        assert child.stdout is not None
        reports = child.stdout.read(REPORT.size)
        time.sleep(random.Random(seed).uniform(0.0, 0.3))
        child.kill()
        reports += child.stdout.read()
    whole = len(reports) // REPORT.size * REPORT.size
    number, receipt_ns = REPORT.unpack(reports[whole - REPORT.size : whole])
    return number, receipt_ns


@pytest.mark.parametrize("seed", every(2, range(20)))
def test_a_recording_killed_at_any_moment_keeps_all_but_its_last_second(tmp_path: Path, seed: int) -> None:
    compression = COMPRESSIONS[seed % 3]
    _, reported_ns = killed_recording(tmp_path / "m.bag", seed, compression)
    found = list(ChunkWalk(tmp_path / "m.bag.active"))
    written = endless(seed)
    for stamped in found:
        assert stamped == next(written)
    assert next(written).receipt_ns > reported_ns - SECOND


@pytest.mark.ros
@pytest.mark.parametrize("compression", COMPRESSIONS)
def test_rosbag_reindexes_a_killed_recording(tmp_path: Path, compression: Compression) -> None:
    require_ros("rosbag")
    _, reported_ns = killed_recording(tmp_path / "m.bag", 100, compression)
    walk = ChunkWalk(tmp_path / "m.bag.active")
    found = list(walk)
    mended = (tmp_path / "m.bag.active").rename(tmp_path / "mended.bag")
    run_ros(["rosbag", "reindex", "-q", str(mended)])
    indexed = list(read_bag(mended))
    # rosbag finds whole chunks only; a walk may also find the beginning of the last one.
    assert indexed == found[: len(indexed)]
    assert len(indexed) == len(found) or walk.faults
    written = endless(100)
    assert all(stamped == next(written) for stamped in indexed)
    assert next(written).receipt_ns > reported_ns - SECOND


@pytest.mark.ros
def test_rosbag_reindexes_a_recording_killed_while_it_was_closed(tmp_path: Path) -> None:
    """The index stands at the end, but the file's header does not tell yet where."""
    require_ros("rosbag")
    path = tmp_path / "m.bag"
    stream = first(1000)
    with BagWriter(path) as writer:
        for stamped in stream:
            writer.write(stamped)
    with path.open("r+b") as file:
        file.write(MAGIC + file_header(0, 0, 0))
    walk = ChunkWalk(path)
    assert (list(walk), walk.faults) == (stream, [])
    with pytest.raises(TransportError, match="never completed, save what it holds with 'mrta salvage'"):
        next(read_bag(path))
    run_ros(["rosbag", "reindex", "-q", str(path)])
    assert list(read_bag(path)) == stream


def first(count: int, seed: int = 0) -> List[Stamped]:
    stream = endless(seed)
    return [next(stream) for _ in range(count)]


@pytest.fixture
def tiny_disk(tmp_path: Path) -> Iterator[Path]:
    """Give a disk of one megabyte, where this process may mount one."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", str(folder)]
    if shutil.which("mount") is None or subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("this user may not mount a small disk")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


@pytest.mark.parametrize("compression", COMPRESSIONS)
def test_a_full_disk_is_one_clear_error_and_what_was_written_stays_readable(
    tiny_disk: Path, compression: Compression, caplog: pytest.LogCaptureFixture
) -> None:
    path = tiny_disk / "m.bag"
    given: List[Stamped] = []

    def record() -> None:
        with BagWriter(path, compression) as writer:
            for stamped in endless(7):
                writer.write(stamped)
                given.append(stamped)

    with pytest.raises(TransportError) as caught:
        record()
    assert str(caught.value) == f"{path}.active: cannot be written: [Errno 28] No space left on device"
    reason = "[Errno 28] No space left on device; save what it holds with 'mrta salvage'"
    assert f"bag not completed reason={path}.active: cannot be completed: {reason}" in caplog.text
    walk = ChunkWalk(path.with_name("m.bag.active"))
    found = list(walk)
    assert (found, walk.faults) == (given[: len(found)], [])
    assert given[len(found)].receipt_ns > given[-1].receipt_ns - SECOND


def test_a_recording_goes_on_when_the_disk_has_room_again(tiny_disk: Path) -> None:
    ballast = tiny_disk / "ballast"
    ballast.write_bytes(bytes(900_000))
    stream = first(400)
    with BagWriter(tiny_disk / "m.bag", Compression.NONE) as writer:
        for stamped in stream:
            writer.write(stamped)
        with pytest.raises(TransportError, match="No space left on device"):
            writer.checkpoint()
        ballast.unlink()
    assert list(read_bag(tiny_disk / "m.bag")) == stream


def test_a_file_that_may_not_grow_is_one_clear_error(tmp_path: Path) -> None:
    script = (
        "import pathlib, resource, sys\n"
        "from rqt_mrta_py.errors import TransportError\n"
        "from rqt_mrta_py.transport import BagWriter, Compression\n"
        "from tests.transport.endless import endless\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (1_500_000, 1_500_000))\n"
        "try:\n"
        "    with BagWriter(pathlib.Path(sys.argv[1]), Compression.NONE) as writer:\n"
        "        for stamped in endless(3): writer.write(stamped)\n"
        "except TransportError as error:\n"
        "    print(error)\n"
    )
    path = tmp_path / "m.bag"
    told = run_ros([sys.executable, "-c", script, str(path)], env=ENVIRONMENT).stdout
    assert told == f"{path}.active: cannot be written: [Errno {errno.EFBIG}] {os.strerror(errno.EFBIG)}\n"
    walk = ChunkWalk(tmp_path / "m.bag.active")
    found = list(walk)
    assert len(found) > 100
    assert (found, walk.faults) == (first(len(found), seed=3), [])


def as_nobody(attempt: Callable[[], None]) -> str:
    """Give what an attempt raises in a process of a user without rights."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        text = "nothing was raised"
        try:
            if os.getuid() == 0:
                os.setuid(65534)
            attempt()
        except TransportError as error:
            text = str(error)
        finally:
            os.write(writing, text.encode())
            os._exit(0)
    os.close(writing)
    os.waitpid(child, 0)
    with os.fdopen(reading, "rb") as told:
        return told.read().decode()


@pytest.fixture
def shared_folder(tmp_path: Path) -> Iterator[Path]:
    """Give a folder that its owner's rights keep others from writing, though they can reach it."""
    if not hasattr(os, "fork"):
        pytest.skip("rights of files are those of POSIX")
    folder = tmp_path / "out"
    folder.mkdir()
    folder.chmod(0o777)
    above = [parent for parent in folder.parents if parent.stat().st_uid == os.getuid()]
    modes = [parent.stat().st_mode for parent in above]
    for parent, mode in zip(above, modes):
        parent.chmod(mode | 0o011)
    yield folder
    folder.chmod(0o777)
    for parent, mode in zip(above, modes):
        parent.chmod(mode)


def test_a_folder_that_may_not_be_written_is_one_clear_error(shared_folder: Path) -> None:
    shared_folder.chmod(0o555)
    told = as_nobody(lambda: BagWriter(shared_folder / "m.bag").close())
    assert re.fullmatch(r".*m\.bag\.active: cannot be written: \[Errno 13\] Permission denied: '.*'", told)


def test_a_folder_that_is_closed_while_a_bag_is_recorded_keeps_it(shared_folder: Path) -> None:
    stream = first(500)

    def record() -> None:
        with BagWriter(shared_folder / "m.bag") as writer:
            os.write(ready[1], b".")
            os.read(go[0], 1)
            for stamped in stream:
                writer.write(stamped)

    ready, go = os.pipe(), os.pipe()
    closer = os.fork()
    if closer == 0:
        os.read(ready[0], 1)
        shared_folder.chmod(0o555)
        os.write(go[1], b".")
        os._exit(0)
    told = as_nobody(record)
    os.waitpid(closer, 0)
    for end in (*ready, *go):
        os.close(end)
    assert "m.bag.active: cannot be completed: [Errno 13] Permission denied" in told
    assert told.endswith("; save what it holds with 'mrta salvage'")
    walk = ChunkWalk(shared_folder / "m.bag.active")
    assert (list(walk), walk.faults) == (stream, [])
