"""What is simulated.

* ``scenario_file``: a scenario.yaml, by the tables in ``form``
* ``events``: what happens on the way; each event by the tables in ``event_form``, all of them by ``event_order``
"""
