"""ALLIANCE: robots share out tasks by motivation alone, without negotiating (Parker 1998; Leite 2017).

* ``equations``: 3.1 to 3.9, one pure function each
* ``parameters``: what one robot is told; ``reading``: from the nested form of its YAML file
* ``communication``: what was heard of other robots; ``sensing``: what was heard of the robot's own sensors
* ``behaviour_set``: one behaviour set and its motivation
* ``messages``: what is said; ``agent``: the robot's decisions
* ``interpreter``: tells from the messages what became of an allocation
* ``panel``: motivation against threshold, for pictures
* ``plugin``: the hooks
"""

from __future__ import annotations
