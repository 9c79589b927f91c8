"""Watches the stream: what robots, tasks and allocations become, what goes wrong, and what that sums up to.

* ``supervisor``: hears the stream, drives the rest, gives records and messages; the place to begin
* ``sightings``: that messages came, ``presence``: whose they are, ``message_key``: what points at one
* ``ears``: what to hear, and what the team is told for it; ``statements``: what follows from what is stated
* ``interpreter_ear``: what the architecture's own messages say
* ``topics``, ``readers``, ``joins``, ``values``: which topics an architecture has, how their messages tell robots and
  tasks
* ``team``: derives facts; ``robots``, ``tasks``, ``allocations`` keep one thing each, ``timeline`` their histories
* ``standing``: how a team stands, as another supervisor tells whoever comes late
* ``agenda``: what falls due when; ``repeats``: messages that only put it off; ``echo``: what one of them does
* ``copies``: a team that looks ahead without moving on
* ``clocks``: stamps against receipts, and who falls silent on a topic
* ``desk``, ``rules``: incidents; ``failures``: plugins that raise on the way
* ``journal``, ``news``, ``summary``: the same for readers, for other nodes, for programs; ``own_topics``: where
* ``statistics``: numbers of a finished mission
* ``explaining``: why tasks went to whom they went, with ``whereabouts`` of robots; ``orders``: what operators
  wanted; ``bids``: what robots bid
* ``traffic``: how much flows between nodes and topics
* ``plugin``: registers rules and statistics
"""

from __future__ import annotations

from rqt_mrta_py.supervisor.bids import bid_grounds
from rqt_mrta_py.supervisor.echo import Echo
from rqt_mrta_py.supervisor.explaining import Explainer
from rqt_mrta_py.supervisor.message_key import MessageKey, heard_of
from rqt_mrta_py.supervisor.news import team_news
from rqt_mrta_py.supervisor.orders import OrderGrounds
from rqt_mrta_py.supervisor.repeats import Attention
from rqt_mrta_py.supervisor.robots import RobotWatch
from rqt_mrta_py.supervisor.standing import Standing, standing_of
from rqt_mrta_py.supervisor.summary import event_lines, incident_lines, summary
from rqt_mrta_py.supervisor.supervisor import Supervisor
from rqt_mrta_py.supervisor.topics import usual_pace
from rqt_mrta_py.supervisor.traffic import Traffic, communication, recorded_communication

__all__ = [
    "Attention",
    "Echo",
    "Explainer",
    "MessageKey",
    "OrderGrounds",
    "RobotWatch",
    "Standing",
    "Supervisor",
    "Traffic",
    "bid_grounds",
    "communication",
    "event_lines",
    "heard_of",
    "incident_lines",
    "recorded_communication",
    "standing_of",
    "summary",
    "team_news",
    "usual_pace",
]
