"""ALLIANCE: robots share out tasks by motivation alone, without negotiating (Parker 1998; Leite 2017).

* ``equations``: 3.1 to 3.12, one pure function each
* ``parameters``: what one robot is told; ``reading``: from the nested form of its YAML file
* ``communication``: what is heard of other robots, and not believed; ``history``: what is remembered of it
* ``sensing``: what is said of each task's applicability; ``sensors``: readers of the robot's own sensors
* ``behaviour_set``: one behaviour set and its motivation; ``array_sets``: the same of many at once,
  with ``earshot``: what is heard of many robots
* ``timing``: when the robot resets, inhibits and announces; ``original``: the same as the original nodes do it
* ``fairness``: an extension, by which perpetual tasks share the time
* ``messages``: what is said; ``agent``: the robot's decisions; ``newcomers``: parameters of tasks that appear
* ``interpreter``: tells from the messages what became of an allocation, ``grounds``: why robots take tasks; ``pace``:
  how fast that goes when all is well
* ``panel``: motivation against threshold, for pictures; ``detailed_panel``: all that it is made of
* ``inner_life``: what goes on in behaviour sets, as it is heard; ``traces``: how it is kept
* ``figures``: charts of it, drawn at the end; ``file_names``: made of ids
* ``plots``: definitions of plots for ``multiplot`` and ``plot_juggler``; ``xml_text``: how they are written
* ``experiments``: what ``mrta bench alliance`` measures
* ``plugin``: the hooks
"""

from __future__ import annotations
