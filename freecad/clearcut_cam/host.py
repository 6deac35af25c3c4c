"""FreeCAD's modules for milling, by one set of names: they lie in PathScripts in 0.20 and in Path since 0.21."""

from __future__ import annotations

from pathlib import Path as File
from tempfile import TemporaryDirectory
from typing import Any

import FreeCAD

try:
    import Path.Base.Util as Util
    import Path.Main.Job as Job
    import Path.Op.Base as Op
except ImportError:
    import PathScripts.PathJob as Job
    import PathScripts.PathOp as Op
    import PathScripts.PathUtil as Util

import PathScripts.PathUtils as Utils

__all__ = ["Job", "Op", "Util", "Utils", "clearcut", "find_job", "operation_gui", "posted", "tool_controller"]


def clearcut() -> Any:
    """The Python module, or an ImportError that says what to do."""
    try:
        import clearcut as module
    except ImportError as error:
        raise ImportError(
            f"the Python module 'clearcut' is not there for FreeCAD's Python ({error}); "
            "install Debian's package python3-clearcut, or copy the module's folder 'clearcut' into the add-on's"
        ) from error
    return module


def operation_gui() -> Any:
    """Task panels of operations; there only with a window."""
    try:
        import Path.Op.Gui.Base as gui
    except ImportError:
        import PathScripts.PathOpGui as gui
    return gui


def find_job(operation: Any) -> Any:
    return Utils.findParentJob(operation)


def tool_controller(operation: Any) -> Any:
    """The tool controller of an operation or of what a dressup changes."""
    return Util.toolControllerForOp(operation)


def posted(job: Any, post: str) -> str:
    """The text that FreeCAD's post writes for a whole job, in one piece and without an editor.

    Raises ValueError where the post fails or writes nothing.
    """
    asked, split = job.PostProcessorArgs, job.SplitOutput
    try:
        job.SplitOutput = False
        for quiet in ("--no-show-editor", ""):
            job.PostProcessorArgs = f"{asked} {quiet}".strip()
            try:
                sections = _sections(job, post)
            except Exception as error:
                raise ValueError(f"the post '{post}' fails: {error}; choose another") from error
            if sections and all(isinstance(text, str) and text for text in sections):
                return "".join(sections)
    finally:
        job.PostProcessorArgs, job.SplitOutput = asked, split
        job.purgeTouched()
    raise ValueError(f"the post '{post}' writes nothing for {job.Label}; choose another, or look at its arguments")


def _sections(job: Any, post: str) -> list[Any]:
    try:
        from Path.Post.Processor import PostProcessorFactory
    except ImportError:
        return _sections_by_script(job, post)
    return [text for _, text in PostProcessorFactory.get_post_processor(job, post).export() or []]


def _sections_by_script(job: Any, post: str) -> list[Any]:
    """0.20 and 0.21: posts are scripts, and the order of the operations is made by the command that posts."""
    try:
        from Path.Post.Command import buildPostList
        from Path.Post.Processor import PostProcessor
    except ImportError:
        from PathScripts.PathPost import CommandPathPost
        from PathScripts.PathPostProcessor import PostProcessor

        def buildPostList(of: Any) -> Any:
            return CommandPathPost().buildPostList(of)

    objects = []
    for group in buildPostList(job):
        # A list of objects, or a pair of a name and such a list, or all objects in one list.
        if isinstance(group, tuple):
            group = group[1]
        objects += group if isinstance(group, (list, tuple)) else [group]
    # Some return the text, some only write it, and not all know that "-" means no file.
    with TemporaryDirectory() as folder:
        file = File(folder) / "job.ngc"
        text = PostProcessor.load(post).export(objects, str(file), job.PostProcessorArgs)
        return [file.read_text() if file.exists() else text]


def is_said(error: Exception) -> bool:
    """Whether an error is one line for the user: of clearcut, of what was picked, of a post. Others are mistakes of ours."""
    return isinstance(error, (ValueError, ImportError)) or type(error).__module__.partition(".")[0] == "clearcut"


def warn(text: str) -> None:
    FreeCAD.Console.PrintWarning(f"Clearcut: {text}\n")


def fail(text: str) -> None:
    FreeCAD.Console.PrintError(f"Clearcut: {text}\n")
