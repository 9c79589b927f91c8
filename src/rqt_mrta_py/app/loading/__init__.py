"""Which packages and plugins take part in a command.

* ``registry``: discovery in this process's environment
* ``environment``: what variables say of plugins; ``blocking``: plugins that are kept out
* ``own_plugins``: what this package registers itself
"""
