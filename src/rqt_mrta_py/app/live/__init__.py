"""What nodes are made of: supervision, agents and worlds on a live graph.

* ``live_supervisor``: hears the stream, says what is new, records, draws; ``voice``: what it says;
  ``supervisor_services``: what it is asked
* ``intake``: which messages are taken in at once; ``live_pictures``: pictures at a period
* ``options``: its private parameters; ``interest``: which topics it hears; ``stream_clock``: its times of receipt
* ``recording``: into a bag, beside the stream; ``resumption``: what is known of one that broke off
* ``ring_buffer``, ``snapshots``: the last seconds, when they matter
* ``drawing``: pictures in another process; ``health``, ``health_report``, ``tally``: how the supervisor itself is
* ``orders``: what operators order; ``open_incidents``: what is wrong now
* ``live_run``: a mission as nodes, from what the user asks for to its outputs; ``node_processes``, ``own_master``: what
  it starts; ``tick_stream``: what it hears, tick by tick; ``supervised_run``: the same while somebody asks and orders
* ``simulation_loop``, ``agent_loop``: a world and a robot on a node; ``ways``: topics that are open before anything is
  said on them, ``foreseen``: which those are, ``unsaid``: what waits for others; ``mission_parameters``: which mission
  it is
* ``world_turns``, ``agent_side``: what these loops do in a tick, without any I/O; ``hold_back``, ``tick_messages``: the
  order of lock step; ``arrivals``: that of teams whose clock runs freely
* ``served_parameters``: a robot's parameters on the parameter server
"""
