"""A mission told as it happens, on the log ``rqt_mrta_py.journal``.

* ``line``: facts as one line of key=value
* ``journal``: what is told of start, events, warnings of nodes, and end
* ``plugin``: the hooks
"""

from __future__ import annotations
