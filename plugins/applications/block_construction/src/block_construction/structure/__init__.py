"""What shall be built: cells of a grid, read from drawings.

* ``voxels``: from filled cells to a structure, if nothing floats
* ``vox_file``, ``npy_file``, ``level_maps``: the three forms of drawings; ``drawings``: reads whichever it is, and
  writes all
* ``layers``: concentric layers, and the order of cells
* ``library``: the structures that come with the package
"""
