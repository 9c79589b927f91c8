from __future__ import annotations

import pytest

from rqt_mrta_py.transport import Bus, RosCodec
from tests.transport.support import ListLink, lookup


@pytest.fixture(scope="session")
def codec() -> RosCodec:
    return RosCodec(lookup)


@pytest.fixture
def link() -> ListLink:
    return ListLink()


@pytest.fixture
def bus(codec: RosCodec, link: ListLink) -> Bus:
    return Bus(codec, link)
