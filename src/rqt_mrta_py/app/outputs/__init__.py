"""What a run and a review leave.

* ``folder``: where; nothing outside it, nothing half-written
* ``results``: summary, events, incidents, dashboard, log; ``versions`` of libraries for it
* ``communication``: nodes and topics of a bag; ``clocks``: what their messages tell of time
* ``report``: the mission as a page; ``explanations``: why tasks went to whom they went
* ``pictures``: monitor pictures at their place in the stream; ``picture_files``: as files and as film
* ``exports``: files in other programs' formats; ``message_exports``: those that hold the messages; ``figures``: charts
  of the whole mission; ``asked_for`` by name
"""
