"""Run by FreeCAD when its window starts: the workbench, and the commands in the toolbar of Path and CAM where FreeCAD lets them in."""

import FreeCADGui


class ClearcutWorkbench(FreeCADGui.Workbench):
    MenuText = "Clearcut"
    ToolTip = "Plans pockets and profiles and proves them, and proves the paths of others"

    def __init__(self):
        import os

        import clearcut_cam

        folder = os.path.dirname(os.path.dirname(clearcut_cam.__file__))
        self.__class__.Icon = os.path.join(folder, "icons", "Clearcut_Prove.svg")

    def Initialize(self):
        from clearcut_cam import gui

        gui.add_commands()
        names = list(gui.COMMANDS)
        self.appendToolbar("Clearcut", names)
        self.appendMenu("Clearcut", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(ClearcutWorkbench())
