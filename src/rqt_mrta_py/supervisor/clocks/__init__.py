"""Time as messages tell it: stamps against receipts, regular topics and their gaps.

* ``leads``: how far the stamps of one robot are ahead of receipts, and when that is more than chance
* ``pulses``: that a robot speaks regularly on a topic, and that it does so no more
* ``timekeeper``: hears monitored topics and tells the rules of both
* ``stamped_off``: what the rules on stamps share; ``words``: spans of time for sentences
* ``pairs``: two clocks by which each other's messages were received
* ``table``: what all connections of a recording tell; ``ledger``: what one does, ``samples``: what is kept for it
* ``estimate``: numbers that a few odd messages do not upset
"""

from __future__ import annotations

from rqt_mrta_py.supervisor.clocks.leads import LEAST_TOLERANCE
from rqt_mrta_py.supervisor.clocks.pairs import clock_pairs
from rqt_mrta_py.supervisor.clocks.pulses import Pulse
from rqt_mrta_py.supervisor.clocks.table import Timings, timing_document
from rqt_mrta_py.supervisor.clocks.timekeeper import Timekeeper, Voice

__all__ = ["LEAST_TOLERANCE", "Pulse", "Timekeeper", "Timings", "Voice", "clock_pairs", "timing_document"]
