"""DEMiR-CF: the Distributed and Efficient Multi-Robot Cooperation Framework of Sariel, Erdogan and Balch (2007).

* ``planning``: what a robot would do next, and in which order targets are visited; pure mathematics
* ``parameters``: what one robot is told
* ``message_kinds``, ``messages``: what robots say to one another; ``beliefs_message``: what they say to those who watch
* ``task_states``, ``robot_states``: what a robot may believe of a task and of another robot, and what changes it
* ``task_model``, ``robot_model``: its model of one task, of one robot; ``mind``: all of them, and what it has taken on
* ``model_update``: what others say, and their silence; ``orders``: what hosts and operators say
* ``consistency``: sets others right
* ``auction``, ``response``, ``nearness``: requests, and how they are answered (Algorithms 3' and 3'')
* ``next_task``: what it would do next (Algorithm 2); ``joint_plan``: the same where the team keeps to one plan
* ``reachability``: what cannot be reached, and when it can again
* ``agent``: the robot's cycle
* ``interpreter``: tells from messages what became of an allocation, ``grounds``: why robots take tasks; ``pace``: how
  fast that goes when all is well
* ``panel``: costs, for pictures
* ``plugin``: the hooks
* ``experiments``: teams without a world
"""

from __future__ import annotations
