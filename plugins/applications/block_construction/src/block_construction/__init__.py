"""Autonomous construction of block structures, planned by learning automata or exactly, built by robots.

After D. de O. Dantas, *Implementação de um Sistema Autônomo de Construção de Estrutura usando Aprendizado por Reforço*,
Universidade Federal do Maranhão, 2017 (in docstrings: Dantas 2017).

* ``structure``: what shall be built; ``diagram``: which block where; ``exact``: proved optima; ``learning``: FALA, PLA
* ``execution``: in which order, from where; ``mission``: to be run; ``building``: by one robot
* ``team``: without getting in each other's way; ``pictures``: of all that
* ``experiments``: the source's tables beside ours; ``verbs``: on the command line
* ``documents``: files of users; ``errors``: what makes it impossible; ``plugin``: the hooks
"""
