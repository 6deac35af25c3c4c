"""Clearcut in FreeCAD's Path and CAM workbenches: operations that plan and prove pockets and profiles, and a proof of whole jobs.

host         FreeCAD's own modules under the names of 0.20 (PathScripts) and of 0.21 to 1.x (Path)
shapes       wires and solids of FreeCAD as outlines of clearcut, and back
features     what is to be milled: from faces, depths and stock to a part of clearcut
tools        tool controllers as tools and feeds
moves        moves as Path commands, and Path commands as text
operation    the operations "Clearcut pocket" and "Clearcut profile"
overlay      what is left uncut, as a coloured shape
proof        "Prove this job": the posted text of any operations, checked
gui          task panels and commands; the only part that needs a window
"""
