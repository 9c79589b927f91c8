"""What nodes are made of: supervision, agents and worlds on a live graph.

* ``live_supervisor``: hears the stream, says what is new, records, draws; ``supervisor_services``: what it is asked
* ``intake``: which messages are taken in at once; ``live_pictures``: pictures at a period
* ``options``: its private parameters; ``interest``: which topics it hears; ``stream_clock``: its times of receipt
* ``recording``: into a bag, beside the stream; ``ring_buffer``, ``snapshots``: the last seconds, when they matter
* ``drawing``: pictures in another process; ``health``: how the supervisor itself is
* ``orders``: what operators order
* ``hold_back``, ``tick_messages``: the order of lock step; ``agent_side``, ``world_turns``: what keeps it
* ``served_parameters``: a robot's parameters on the parameter server
"""
