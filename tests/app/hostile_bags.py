"""What is done with a hostile bag: it is read, salvaged and reviewed, within limits of time and memory."""

from __future__ import annotations

import contextlib
import io
import json
import random
import resource
import shutil
import signal
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, List, Tuple

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.outputs.results import MissionResult
from rqt_mrta_py.app.review.review import ReviewRequest, review_bag
from rqt_mrta_py.app.salvage_bag import SalvageReport, SalvageRequest, salvage_bag
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.transport import Compression
from tests.app.bag_mutations import mutated, recording
from tests.conftest import ROOT

__all__ = ["Verdict", "examine", "examine_many", "limit_memory"]

LIMIT = 10.0
"""How much computing time one verb may take [s]; that of the wall says how busy the machine is."""

MEMORY = 2**30
"""How much one process may take on top of what it takes before the first bag [bytes]."""

MESSAGES = 43
"""How many each recording holds."""

_SEEDS: Dict[Tuple[Compression, int], bytes] = {}


class Hung(BaseException):
    """A verb has computed for longer than it may."""


@dataclass(frozen=True)
class Verdict:
    """How a verb ended."""

    seed: int
    verb: str
    told: str


def hostile_bag(seed: int) -> bytes:
    """Make the hostile bag of a number; the same number gives the same bag."""
    rng = random.Random(seed)
    compression = rng.choice(list(Compression))
    # Eight recordings of each compression, half of them hostile already.
    variant = rng.randrange(8)
    if (compression, variant) not in _SEEDS:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "seed.bag"
            chance = random.Random(f"{compression.value} {variant}")
            _SEEDS[compression, variant] = recording(ROOT, path, compression, chance, hostile=variant % 2 == 1)
    return mutated(rng, _SEEDS[compression, variant])


def examine(seed: int, folder: Path, host: Host) -> List[Verdict]:
    """Salvage and review a hostile bag.

    Args:
        seed: its number.
        folder: to work in; empty, and so again afterwards.
        host: of the review.

    Returns:
        What is wrong with how that ended; nothing, if each left a result, or said in one line why it left none.
    """
    bag, out, review = folder / "m.bag", folder / "out.bag", folder / "review"
    bag.write_bytes(hostile_bag(seed))
    reviewing = ReviewRequest(bag, architecture="mrta_alliance", pictures=0.0, out=review)
    wrong = [
        *_judged(seed, "salvage", lambda: _stated(salvage_bag(SalvageRequest(bag, out), lambda *_: None))),
        *_judged(seed, "review", lambda: _complete(review, review_bag(host, reviewing, lambda *_: None))),
    ]
    strays = sorted(each.name for each in folder.iterdir() if each not in (bag, out, review))
    if strays:
        wrong.append(Verdict(seed, "both", f"left {strays}"))
    for each in folder.iterdir():
        if each.is_dir():
            shutil.rmtree(each)
        else:
            each.unlink()
    return wrong


def examine_many(first: int, count: int) -> List[Verdict]:
    """Examine hostile bags one after another, in this process."""
    with tempfile.TemporaryDirectory() as name:
        host = compose()
        return [verdict for seed in range(first, first + count) for verdict in examine(seed, Path(name), host)]


def limit_memory() -> None:
    """Let whatever takes too much memory in this process fail."""
    taken = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (taken + MEMORY, resource.getrlimit(resource.RLIMIT_AS)[1]))


def _judged(seed: int, verb: str, work: Callable[[], str]) -> Iterator[Verdict]:
    """Do something; tell if it crashes, hangs, takes too much memory, or ends in neither a result nor one line."""
    try:
        with contextlib.redirect_stderr(io.StringIO()), _limited():
            complaint = work()
    except MrtaError as error:
        complaint = f"says more than a line: {error}" if "\n" in str(error) else ""
    except Hung:
        complaint = f"computed for more than {LIMIT:g} s"
    except Exception as error:  # noqa: BLE001  Whatever else comes out is a crash.
        complaint = f"crashed: {type(error).__name__}: {error}"
    if complaint:
        yield Verdict(seed, verb, complaint)


def _stated(report: SalvageReport) -> str:
    """Complain if messages are missing and nothing says so; none of the recordings holds fewer than MESSAGES."""
    told = report.faults or any(topic.lost for topic in report.topics) or not report.counted
    return "" if told or report.messages >= MESSAGES else f"lost {MESSAGES - report.messages} messages without a word"


def _complete(folder: Path, result: MissionResult) -> str:
    """Complain if a review did not leave its files, or one that no program could read."""
    json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    for name in ("events.jsonl", "incidents.jsonl"):
        for line in (folder / name).read_text(encoding="utf-8").splitlines():
            json.loads(line)
    return ""


@contextlib.contextmanager
def _limited() -> Iterator[None]:
    def hung(*_: Any) -> None:
        raise Hung

    before = signal.signal(signal.SIGPROF, hung)
    signal.setitimer(signal.ITIMER_PROF, LIMIT)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
