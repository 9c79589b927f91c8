"""FALA and PLA: learning automata that decide which block goes where (Dantas 2017, chapters 2 and 5).

* ``fala``, ``pla``, ``reward``: the equations, one function each
* ``network``: automata and their actions as arrays; ``drawing``: one diagram; ``memory``, ``credit``, ``stops``: what
  automata remember, which cost they are told, when training ends
* ``state``: rules, and what training has come to; ``training``: the loop; ``compiled``: the door to numba;
  ``learner``: a whole training
* ``reopening``: an extension of the source's training; ``settings``, ``planner``: both as planners
"""
