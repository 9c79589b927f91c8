"""What ``mrta bench`` can measure of this package.

* ``plugin``: the benchmarks, registered like anybody's
* ``loop``, ``load``, ``parts``: how fast a simulated mission runs, with how much to do, and where its time goes
"""
