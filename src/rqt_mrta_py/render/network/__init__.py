"""The picture of nodes and topics.

* ``folding``: robots that say the same on topics of their own become one
* ``layering``: who stands left of whom; ``ordering``: above whom; ``placing``: where exactly
* ``arrangement``: all of that, for whoever draws
* ``picture``: draws it
"""
