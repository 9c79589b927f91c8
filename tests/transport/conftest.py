from __future__ import annotations

import pytest

from rqt_mrta_py.transport import RosCodec
from tests.transport.support import lookup


@pytest.fixture(scope="session")
def codec() -> RosCodec:
    return RosCodec(lookup)
