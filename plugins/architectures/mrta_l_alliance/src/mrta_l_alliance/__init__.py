"""L-ALLIANCE: ALLIANCE whose parameters are learned from how long robots take for tasks (Parker 1995 to 2000).

* ``equations``: its rules, one pure function each
* ``parameters``: what one robot is told about learning
* ``memory``: what is known of robots and tasks, and its text form
* ``monitor``: watches who is on which task, and how it ends
* ``tuning``: from what is known to ALLIANCE's parameters
* ``messages``: what is said beyond ALLIANCE; ``agent``: the robot's cycle, around ALLIANCE's
* ``pace``: how fast tasks are shared out when all is well; ``grounds``: why robots take them
* ``exporter``: writes memories down; ``lessons``: trains teams mission after mission
* ``plugin``: the hooks
"""

from __future__ import annotations
