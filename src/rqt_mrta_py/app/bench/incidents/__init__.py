"""How well incident rules find faults: ``mrta bench incidents``.

* ``yards``: small applications whose robots and tasks lie elsewhere with every seed; ``setting`` makes missions of them
* ``calm``: a mission in which nothing happened, as its record tells; a fault is put into a second one like it
* ``fault``: what a fault is; ``world``, ``radio``, ``clocks``, ``wire``: the faults; ``faults``: all of them
* ``misbehaviour``: agents that say or do what they should not
* ``label``: what must be found of a fault, and what may; ``judging`` holds it against what was found
* ``harmless``: missions in which nothing must be found
* ``campaign``: which missions there are, and carrying them out; ``measuring``: the benchmark and its tables
"""
