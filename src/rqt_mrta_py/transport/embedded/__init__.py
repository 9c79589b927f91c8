"""The bus of a simulated run, in one process and in mission time.

* ``bus``: carries messages from publishers to inboxes, and asks the link; the place to begin
* ``node``: what speaks and hears; ``publisher``: its way onto a topic; ``inbox``: what is on its way to it
* ``choir``: nodes that publish together; ``team_ear``: nodes that hear together
* ``wiring``: who hears what
"""
