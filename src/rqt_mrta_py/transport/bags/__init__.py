"""Bags of ROS 1, format 2.0.

* ``writer``: a recording, chunk by chunk
* ``numbering``, ``pending``: what it knows while its messages wait for their chunk
* ``chunks``, ``headers``, ``windows``, ``records``, ``compression``: what it is made of
* ``reader``: whole bags, by time of receipt; ``index``: what their end says, ``chunk_content``: what their chunks hold
* ``blocks``: messages many at a time; ``merging``: several bags as one; ``spans``: how much came on which connection
* ``chunk_walk``: damaged ones, in the order of the file; ``scan``, ``connections``: how it finds its way; ``promises``:
  how much there should be
* ``chunk_rescue``, ``walking``: what is had by it of bags that are read by time
* ``tail``: those that are still recorded
* ``faults``: what could not be read
"""
