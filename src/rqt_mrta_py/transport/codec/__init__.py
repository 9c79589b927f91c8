"""Message types, and fields into bytes and back.

* ``definitions``: what the text of a type declares; ``types`` finds the text by the type's name
* ``wire``, ``values``: how values stand in bytes, and how Python's and NumPy's get there
* ``reading``, ``writing``: functions written for one type; ``misfits`` says what is wrong with a value
* ``forms``: faster writers for messages that give the same fields; ``encoder_text``: what all writers are made of
* ``columns``: writers of a whole team's messages; ``sheets``: the memory that they write on; ``column_parts``: how
  columns of numbers get there
* ``ros_codec``: all of it behind the Protocol ``hooks.Codec``
* ``marks``: which bytes of a message decide what fields say
"""
