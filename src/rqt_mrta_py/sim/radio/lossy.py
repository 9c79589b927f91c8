"""A radio that loses, delays, repeats, and does not reach everywhere."""

from __future__ import annotations

import math
import sys
from typing import TYPE_CHECKING, Dict, Optional, Sequence, Tuple

from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.hooks import LinkSetup
from rqt_mrta_py.sim.radio.settings import read_settings

if TYPE_CHECKING:
    import numpy as np

__all__ = ["LOSSY", "LossyLink"]

LOSSY = Table(
    "lossy",
    "A radio that loses, delays, repeats, and does not reach everywhere.",
    (
        Key("loss", ValueType.NUMBER, "Probability that a message is lost.", default=0.0, minimum=0, maximum=1),
        Key("delay", ValueType.NUMBER, "What every message takes.", "s", 0.0, minimum=0, maximum=3600),
        Key(
            "jitter",
            ValueType.NUMBER,
            "What a message takes besides: exponentially distributed, with this mean.",
            "s",
            0.0,
            minimum=0,
            maximum=3600,
        ),
        Key(
            "reordering",
            ValueType.SWITCH,
            "Whether a message may overtake those sent before it; if not, it waits for them, as with TCP.",
            default=False,
        ),
        Key(
            "duplicates",
            ValueType.NUMBER,
            "Probability that a message that is not lost arrives twice.",
            default=0.0,
            minimum=0,
            maximum=1,
        ),
        Key(
            "range",
            ValueType.NUMBER,
            "Distance between robots up to which messages arrive; any if not given.",
            "m",
            None,
            above=0,
        ),
    ),
)

_LOST: Tuple[float, ...] = ()


class LossyLink:
    """Messages between two robots share their fate with nobody else's: each pair, each way, has its own chance.

    Every message of a pair takes the same numbers from the pair's generator, whatever becomes of it; so a run with
    more loss loses what a run with less loss loses, and more. Distances are those between true positions at the moment
    of sending. Parameters are those of ``LOSSY``.

    Args:
        setup: parameters, poses, chance.

    Raises:
        SimError: a parameter is not acceptable or unknown; one line for each.
    """

    def __init__(self, setup: LinkSetup) -> None:
        settings = read_settings(setup.parameters, LOSSY)
        self._loss: float = settings["loss"]
        self._delay: float = settings["delay"]
        self._jitter: float = settings["jitter"]
        self._duplicates: float = settings["duplicates"]
        self._range: Optional[float] = settings["range"]
        self._keeps_order: bool = not settings["reordering"]
        self._pose = setup.pose
        self._random = setup.random
        self._needs_chance = max(self._loss, self._jitter, self._duplicates) > 0.0
        self._pairs: Dict[Tuple[str, str], np.random.Generator] = {}
        self._newest: Dict[Tuple[str, str], float] = {}

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        """Tell when the copies of a message arrive."""
        pair = (sender, receiver)
        delays = [self._delay]
        if self._needs_chance:
            fate, wait, again, longer = self._draw(pair)
            if fate < self._loss:
                return _LOST
            # -log(1 - u) of a uniform u in [0, 1) is exponentially distributed with mean 1.
            delays = [self._delay - self._jitter * math.log1p(-wait)]
            if again < self._duplicates:
                delays.append(self._delay - self._jitter * math.log1p(-longer))
        if self._range is not None and not self._reaches(sender, receiver, self._range):
            return _LOST
        return [self._in_order(pair, now, delay) for delay in sorted(delays)] if self._keeps_order else delays

    def _draw(self, pair: Tuple[str, str]) -> Sequence[float]:
        generator = self._pairs.get(pair)
        if generator is None:
            generator = self._pairs[pair] = self._random(*pair)
        numbers: Sequence[float] = generator.random(4).tolist()
        return numbers

    def _reaches(self, sender: str, receiver: str, reach: float) -> bool:
        here, there = self._pose(sender), self._pose(receiver)
        return here is None or there is None or math.hypot(here.x - there.x, here.y - there.y) <= reach

    def _in_order(self, pair: Tuple[str, str], now: float, delay: float) -> float:
        """Lengthen a delay such that nothing arrives before what was sent earlier."""
        newest = self._newest.get(pair, 0.0)
        delay = max(delay, newest - now)
        while now + delay < newest:
            # The difference was rounded down.
            delay += newest * sys.float_info.epsilon
        self._newest[pair] = now + delay
        return delay
