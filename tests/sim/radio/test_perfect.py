from __future__ import annotations

import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.sim.radio import PerfectLink
from tests.sim.radio.support import link_setup


def test_perfect_link_delivers_once_and_at_once():
    link = PerfectLink.of(link_setup({}))
    assert list(link.deliveries("r1", "r2", 3.0)) == [0.0]


def test_perfect_link_takes_no_parameters():
    with pytest.raises(SimError, match="loss: is not known; there is none"):
        PerfectLink.of(link_setup({"loss": 0.1}))
