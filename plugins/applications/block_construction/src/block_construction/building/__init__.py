"""Building: how one robot fetches blocks and puts them into their slots (Dantas 2017, chapters 3 and 6).

* ``slot``: what a task says of its block
* ``pose_filter``: where the robot is
* ``eyes``: what it sees, ``sight_filter``: in several looks; ``site_map``: what it makes of that
* ``gripping``: where a block is at the magnet
* ``follower``: velocities along a way; ``journey``: from one place to the next, ``team_journey``: among teammates
* ``routes``: how far; ``travel``: all ways of one task; ``teamwork``: where teammates fetch and wait
* ``actions``: the five of them; ``procedures``: the two, as tables of actions; ``performer`` carries them out
* ``supply``: from where a block is fetched; ``laying``: where a block is laid that is of no use
* ``errand``: one task from setting out to standing off; ``place_block``: the behaviour
* ``build_measure``: what came of it
* ``state``: what a builder tells; ``seams``, ``helpers``: whom it asks about others and about ways
"""
