"""Commands and task panels. The forms are built here, so that none depends on a FreeCAD version's own."""

from __future__ import annotations

import os
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from . import host, operation, overlay, proof

ICONS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "icons")
OpGui = host.operation_gui()
VERDICT_COLOURS = {"CLEAN": "#1b7f3b", "CONDITIONAL": "#9a6a00"}


def icon(name: str) -> str:
    return os.path.join(ICONS, f"{name}.svg")


class ViewProvider(OpGui.ViewProvider):
    """As other operations have it, with an icon of its own; faces are what can be picked."""

    def getIcon(self) -> str:
        return icon("Clearcut_Pocket" if isinstance(self.Object.Proxy, operation.Pocket) else "Clearcut_Profile")

    def getSelectionFactory(self) -> Any:
        return _pick_faces


class _FaceGate:
    def allow(self, document: Any, obj: Any, sub: str) -> bool:
        return sub.startswith("Face")


def _pick_faces() -> None:
    FreeCADGui.Selection.addSelectionGate(_FaceGate())


class Page(OpGui.TaskPanelPage):
    """One row for each property of the operation, and the verdict below."""

    # Property, what stands before its field.
    ROWS: tuple[tuple[str, str], ...] = ()

    def getForm(self) -> Any:
        form = QtGui.QWidget()
        rows = QtGui.QFormLayout(form)
        form.toolController, form.coolantController = QtGui.QComboBox(), QtGui.QComboBox()
        rows.addRow("Tool controller", form.toolController)
        rows.addRow("Coolant", form.coolantController)
        self.fields = {}
        for name, text in self.ROWS:
            self.fields[name] = self._field(name)
            self.fields[name].setToolTip(self.obj.getDocumentationOfProperty(name))
            rows.addRow(text, self.fields[name])
        form.verdict = QtGui.QLabel()
        form.verdict.setWordWrap(True)
        rows.addRow("Verdict", form.verdict)
        return form

    def _field(self, name: str) -> Any:
        kind = self.obj.getTypeIdOfProperty(name)
        if kind == "App::PropertyEnumeration":
            field = QtGui.QComboBox()
            field.addItems(self.obj.getEnumerationsOfProperty(name))
        elif kind == "App::PropertyBool":
            field = QtGui.QCheckBox()
        elif kind in ("App::PropertyInteger", "App::PropertyPercent"):
            field = QtGui.QSpinBox()
            field.setMaximum(100)
            field.setSuffix(" %" if kind.endswith("Percent") else "")
        else:
            field = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
            field.setProperty("unit", "deg" if kind == "App::PropertyAngle" else "mm")
            field.setProperty("minimum", 0.0)
        return field

    def getFields(self, obj: Any) -> None:
        for name, field in self.fields.items():
            value = _value_of(field)
            held = getattr(obj, name)
            if value != getattr(held, "Value", held):
                setattr(obj, name, value)
        self.updateToolController(obj, self.form.toolController)
        self.updateCoolant(obj, self.form.coolantController)

    def setFields(self, obj: Any) -> None:
        for name, field in self.fields.items():
            held = getattr(obj, name)
            _show_value(field, getattr(held, "Value", held))
        self.setupToolController(obj, self.form.toolController)
        self.setupCoolant(obj, self.form.coolantController)
        self._show_verdict(obj)

    def updateData(self, obj: Any, prop: str) -> None:
        if prop in ("Verdict", "Faults"):
            self._show_verdict(obj)

    def _show_verdict(self, obj: Any) -> None:
        colour = VERDICT_COLOURS.get(obj.Verdict, "#b00020")
        lines = [f'<b style="color:{colour}">{obj.Verdict or "not planned yet"}</b> {obj.Planned}', *obj.Faults[:3]]
        self.form.verdict.setText("<br>".join(lines))

    def getSignalsForUpdate(self, obj: Any) -> list[Any]:
        signals = [self.form.toolController.currentIndexChanged, self.form.coolantController.currentIndexChanged]
        return signals + [_changed(field) for field in self.fields.values()]


def _value_of(field: Any) -> Any:
    if isinstance(field, QtGui.QComboBox):
        return field.currentText()
    if isinstance(field, QtGui.QCheckBox):
        return field.isChecked()
    return field.value() if isinstance(field, QtGui.QSpinBox) else field.property("rawValue")


def _show_value(field: Any, value: Any) -> None:
    field.blockSignals(True)
    if isinstance(field, QtGui.QComboBox):
        field.setCurrentIndex(max(0, field.findText(value)))
    elif isinstance(field, QtGui.QCheckBox):
        field.setChecked(value)
    elif isinstance(field, QtGui.QSpinBox):
        field.setValue(value)
    else:
        field.setProperty("rawValue", value)
    field.blockSignals(False)


def _changed(field: Any) -> Any:
    if isinstance(field, QtGui.QComboBox):
        return field.currentIndexChanged
    return field.toggled if isinstance(field, QtGui.QCheckBox) else field.editingFinished


class PocketPage(Page):
    ROWS = (
        ("Strategy", "Strategy"), ("StepOver", "Stepover (0: its own)"), ("EngagementLimit", "Largest engagement (0: none)"),
        ("Direction", "Direction"), ("Entry", "Way down"), ("EntryAngle", "Steepest (0: its own)"),
        ("StockToLeave", "Leave on walls"), ("StockToLeaveFloor", "Leave on floors"),
    )  # fmt: skip


class ProfilePage(Page):
    ROWS = (
        ("Side", "Side of the perimeter"), ("Perimeter", "Perimeter"), ("Holes", "Holes"), ("Direction", "Direction"),
        ("Entry", "Way down"), ("EntryAngle", "Steepest (0: its own)"), ("StockToLeave", "Leave on walls"), ("Tabs", "Tabs"),
        ("TabWidth", "Their width"), ("TabHeight", "Their height (0: own)"),
    )  # fmt: skip


def _jobs() -> list[Any]:
    document = FreeCAD.ActiveDocument
    return [obj for obj in document.Objects if isinstance(getattr(obj, "Proxy", None), host.Job.ObjectJob)] if document else []


def _selected_job() -> Any:
    """The job that is selected, or one of whose operations is; else the only one there is."""
    for obj in FreeCADGui.Selection.getSelection():
        job = obj if obj in _jobs() else host.find_job(obj)
        if job:
            return job
    return _jobs()[0] if len(_jobs()) == 1 else None


class AddOperation:
    """Makes an operation and opens its panel; faces that are selected become its base."""

    def __init__(self, name: str, text: str, tip: str, create: Any, page: type):
        self.name = name
        # The panel's title is the first of these.
        self.resources = OpGui.CommandResources(text, create, page, name, text, None, tip)

    def GetResources(self) -> dict[str, str]:
        return {"Pixmap": icon(self.name), "MenuText": self.resources.menuText, "ToolTip": self.resources.toolTip}

    def IsActive(self) -> bool:
        return bool(_jobs())

    def Activated(self) -> None:
        document = FreeCAD.ActiveDocument
        picked = [(one.Object, [name for name in one.SubElementNames if name.startswith("Face")]) for one in FreeCADGui.Selection.getSelectionEx()]
        job = _selected_job()
        document.openTransaction(self.resources.menuText)
        try:
            obj = self.resources.objFactory(self.name.replace("_", ""), None, job)
        except Exception as error:
            document.abortTransaction()
            QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "Clearcut", str(error) or type(error).__name__)
            return
        obj.ViewObject.Proxy = ViewProvider(obj.ViewObject, self.resources)
        for owner, names in picked:
            for name in names:
                obj.Proxy.addBase(obj, owner, name)
        document.commitTransaction()
        document.recompute()
        obj.ViewObject.Document.setEdit(obj.ViewObject, 0)


class ProveJob:
    def GetResources(self) -> dict[str, str]:
        return {
            "Pixmap": icon("Clearcut_Prove"),
            "MenuText": "Prove this job",
            "ToolTip": "Posts the selected job and proves the text: nothing left, nothing gouged, no rapid through material",
        }

    def IsActive(self) -> bool:
        return _selected_job() is not None

    def Activated(self) -> None:
        found = proof.create(_selected_job())
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            FreeCAD.ActiveDocument.recompute()
            overlay.show(found)
            FreeCAD.ActiveDocument.recompute()
        finally:
            QtGui.QApplication.restoreOverrideCursor()
        text = proof.report(found)
        FreeCAD.Console.PrintMessage(text + "\n")
        box = QtGui.QMessageBox(FreeCADGui.getMainWindow())
        box.setWindowTitle("Clearcut")
        box.setIcon(QtGui.QMessageBox.Information if found.Verdict == "CLEAN" else QtGui.QMessageBox.Warning)
        box.setText("\n".join(text.splitlines()[:12]))
        box.setDetailedText(text)
        box.exec_()


class ShowLeft:
    def GetResources(self) -> dict[str, str]:
        return {
            "Pixmap": icon("Clearcut_Left"),
            "MenuText": "Show what is left",
            "ToolTip": "What the selected Clearcut operation or proof leaves: red within reach, amber out of reach",
        }

    def IsActive(self) -> bool:
        return bool(self._sources())

    def _sources(self) -> list[Any]:
        return [obj for obj in FreeCADGui.Selection.getSelection() if hasattr(obj, "Left") and hasattr(obj, "OutOfReach") and hasattr(obj, "Verdict")]

    def Activated(self) -> None:
        for source in self._sources():
            overlay.show(source)
        FreeCAD.ActiveDocument.recompute()


COMMANDS = {
    "Clearcut_Pocket": AddOperation(
        "Clearcut_Pocket", "Clearcut pocket", "Clears faces with islands and open sides, and proves it", operation.create_pocket, PocketPage
    ),
    "Clearcut_Profile": AddOperation(
        "Clearcut_Profile", "Clearcut profile", "Follows outlines, with tabs, and proves it", operation.create_profile, ProfilePage
    ),
    "Clearcut_Prove": ProveJob(),
    "Clearcut_Left": ShowLeft(),
}


def add_commands() -> None:
    for name, command in COMMANDS.items():
        FreeCADGui.addCommand(name, command)
