"""What ``mrta bench`` can measure of this package.

* ``registered``: finds and runs the benchmarks of all plugins; ``plugin`` registers ours
* ``report``: what they leave, as files
* ``no_laboratory``: for benchmarks that simulate no missions
* ``loop``, ``load``, ``parts``: how fast a simulated mission runs, with how much to do, and where its time goes
"""
