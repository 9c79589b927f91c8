"""How messages between robots travel.

* ``perfect``: every message arrives once and at once
* ``lossy``: loss, delay, jitter, order, duplicates, range
* ``radio``: what the bus asks: the present link, failed radios, partitions
* ``factory``: builds a scenario's links before anything happens
* ``settings``: checks a link's parameters by the table that documents them
"""

from __future__ import annotations

from rqt_mrta_py.sim.radio.factory import LinkRandom, Links, build_links, radio_of
from rqt_mrta_py.sim.radio.lossy import LOSSY, LossyLink
from rqt_mrta_py.sim.radio.perfect import PERFECT, PerfectLink
from rqt_mrta_py.sim.radio.radio import Radio

__all__ = ["LOSSY", "PERFECT", "LinkRandom", "Links", "LossyLink", "PerfectLink", "Radio", "build_links", "radio_of"]
