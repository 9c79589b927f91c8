"""Review a recorded mission: from bags to the outputs of a run.

* ``review``: the whole of it; ``request``: what is asked for; ``choice``: which messages that means
* ``recordings``: bags as one stream, whole or not
* ``subject``: what they are about; ``inference``: if nobody says so
* ``taking``: their messages on the way; ``skimming``: how they are taken in
* ``outlook``: what can be said of many messages at once; ``habits``: which say anything new; ``beats``: when they came
* ``hosts``: what bags tell of clocks that were recorded on robots
* ``moments``: when a picture is drawn; ``account``: what was read, and why so
* ``why``: who could have had a task, who took it when, and on what grounds
"""
