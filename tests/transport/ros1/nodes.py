"""What the processes of these tests begin with."""

from __future__ import annotations

from typing import Optional

__all__ = ["OURS", "STRANGER", "texts"]

_TEXTS = {
    "calls/SumRequest": "int32 a\nint32 b",
    "calls/SumResponse": "int32 sum",
    "roscpp/Logger": "string name\nstring level",
    "roscpp/GetLoggersRequest": "",
    "roscpp/GetLoggersResponse": "Logger[] loggers",
    "roscpp/SetLoggerLevelRequest": "string logger\nstring level",
    "roscpp/SetLoggerLevelResponse": "",
}

OURS = """\
import logging, time
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Outgoing, OutgoingRows, Subscription
from rqt_mrta_py.transport import RosCodec
from rqt_mrta_py.transport.ros1 import MasterChange, RosNode
from tests.transport.ros1.nodes import texts
codec = RosCodec(texts)

class Lines(logging.Handler):
    def __init__(self):
        super().__init__()
        self.texts = []
    def emit(self, record):
        self.texts.append(record.getMessage())

lines = Lines()
logging.getLogger().addHandler(lines)

def raised(function, *arguments):
    try:
        function(*arguments)
    except Exception as error:
        return f"{type(error).__name__}: {error}"

"""

STRANGER = """\
import time
import genpy.dynamic
import rospy

def make(name, text):
    return genpy.dynamic.generate_dynamic(name, text)[name]

STRING = make("std_msgs/String", "string data")
"""


def texts(type_name: str) -> Optional[str]:
    """Find the text of a type of these tests."""
    return _TEXTS.get(type_name)
