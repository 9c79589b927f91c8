"""Bags of ROS 1, format 2.0.

* ``writer``: a recording, chunk by chunk
* ``numbering``, ``pending``: what it knows while its messages wait for their chunk
* ``chunks``, ``headers``, ``windows``, ``records``, ``compression``: what it is made of
* ``reader``: whole bags, by time of receipt
* ``chunk_walk``: damaged ones, in the order of the file; ``scan``, ``connections``: how it finds its way; ``promises``:
  how much there should be
* ``tail``: those that are still recorded
* ``faults``: what could not be read
"""
