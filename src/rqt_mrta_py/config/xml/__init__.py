"""The grammar of rqt_mrta.xml.

* ``text``, ``element``: XML text to a cursor with typed getters, which notes what nobody asked for
* ``flavour``: the two flavours, read by ``architecture`` and ``application``
* ``writing``: specifications to XML text, with ``writing_parts`` and ``tree``
* ``topics``, ``templates``, ``launches``, ``ids``: elements of one flavour or both
"""
