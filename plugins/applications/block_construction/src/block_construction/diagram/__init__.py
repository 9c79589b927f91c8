"""Which block where: the assembly diagram.

* ``block_set``: blocks and the slots they lie in
* ``actions``: what may be placed at a cell; ``codes``: how cells of blocks are told apart
* ``cost``: connection faults and blocks
* ``diagram``: placements that cover a structure, in the order of the diagram; ``table``: the same as files
* ``planning``: from a structure to a diagram, by any planner
"""
