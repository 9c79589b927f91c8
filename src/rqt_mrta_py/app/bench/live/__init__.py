"""What live supervision costs, how quick and how safe it is, against a master of the benchmark's own.

* ``measuring``: the parts, and what they take; ``session``: the master, and processes that join it
* ``processor``: processor time beside a bare subscriber; ``latency``: from a message to the state that it changes
* ``endurance``: many messages for long; ``crash``: what a killed recording keeps
* ``likeness``: free-running nodes beside a run in one process
* ``team_load``, ``order_load``: processes that speak; ``watched_supervisor``: one that supervises and tells when
"""
