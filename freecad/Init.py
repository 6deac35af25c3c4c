"""Run by FreeCAD when it starts, with or without a window. The add-on's modules are imported when they are first used."""
