"""Review a recorded mission: from bags to the outputs of a run.

* ``review``: the whole of it
"""
