"""What the files of users and packages may hold, as data; grammars and the reference are written from it.

* ``forms``: how a form of an XML file is told; ``architecture_form``, ``application_form``, ``shared_elements``: both
  flavours of rqt_mrta.xml
* ``exports``: the attributes of a manifest's export tag
* ``relax_ng``, ``json_schema``: from forms and tables to grammars
* ``shipped``: the grammars that lie in this folder, for editors and other programs
"""
