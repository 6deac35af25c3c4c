# FreeCAD's adaptive clearing of the outlines that adaptive_benchmark plans, on this machine: the table to put beside it.
#
#   SHAPES=FOLDER freecadcmd benchmarks/freecad_adaptive.py > table.md     (FreeCAD 0.20; PROGRAMS=FOLDER keeps its moves)
#   adaptive_benchmark FOLDER table.md
#
# Generation is the CPU time of the operation's own execution, the best of four; moves are those that change the position.
import json
import os
import time

import FreeCAD
import Part
from PathScripts import PathAdaptive, PathJob

VECTOR = FreeCAD.Vector
SHAPES = ["dumbbell", "rect100x60_island", "square50", "star6", "triangle80"]
RUNS = 4


def wire(points, z):
    """Outline points [x, y, bulge] as a closed wire; bulge as in DXF."""
    edges = []
    for (x, y, bulge), (u, v, _) in zip(points, points[1:] + points[:1]):
        a, b = VECTOR(x, y, z), VECTOR(u, v, z)
        if abs(bulge) < 1e-12:
            edges.append(Part.LineSegment(a, b).toShape())
        else:
            over = VECTOR((x + u) / 2 + bulge * (v - y) / 2, (y + v) / 2 - bulge * (u - x) / 2, z)
            edges.append(Part.Arc(a, over, b).toShape())
    return Part.Wire(edges)


def block_with(outline):
    """A block with the pocket in it, and how deep that is."""
    depth = outline["depth"]
    floor = Part.Face(wire(outline["outer"], -depth))
    for island in outline["islands"]:
        floor = floor.cut(Part.Face(wire(island, -depth)))
    bounds = floor.BoundBox
    block = Part.makeBox(bounds.XLength + 20, bounds.YLength + 20, depth + 8,
                         VECTOR(bounds.XMin - 10, bounds.YMin - 10, -depth - 8))
    return block.cut(floor.Faces[0].extrude(VECTOR(0, 0, depth))), depth


def adaptive(document, block, depth, diameter, stepover):
    part = document.addObject("Part::Feature", "part")
    part.Shape = block
    document.recompute()
    floor = [f"Face{i + 1}" for i, face in enumerate(block.Faces)
             if abs(face.BoundBox.ZMax + depth) < 1e-6 and abs(face.BoundBox.ZMin + depth) < 1e-6]
    job = PathJob.Create("Job", [part], None)
    tool = job.Tools.Group[0]
    tool.Tool.Diameter = float(diameter)
    tool.HorizFeed, tool.VertFeed = "1000 mm/min", "300 mm/min"
    document.recompute()
    operation = PathAdaptive.Create("Adaptive")
    operation.Base = [(job.Model.Group[0], floor)]
    operation.ToolController = tool
    operation.OperationType, operation.Side, operation.StepOver = "Clearing", "Inside", stepover
    for name, value in (("StartDepth", 0), ("FinalDepth", -depth), ("StepDown", depth)):
        operation.setExpression(name, None)
        setattr(operation, name, value)
    return operation


def seconds_to_execute(operation):
    operation.AdaptiveInputState = operation.AdaptiveOutputState = ""  # else it keeps its last result
    start = time.process_time()
    operation.Proxy.execute(operation)
    return time.process_time() - start


def moves(operation):
    """The commands that change the position, with where they lead."""
    at, result = {}, []
    for command in operation.Path.Commands:
        if command.Name not in ("G0", "G1", "G2", "G3"):
            continue
        to = {**at, **{axis: value for axis, value in command.Parameters.items() if axis in "XYZ"}}
        if to != at:
            result.append(command)
        at = to
    return result


def write_program(commands, file):
    with open(file, "w") as out:
        out.write("G21 G90 G17\n")
        for command in commands:
            words = "".join(f" {k}{v * 60 if k == 'F' else v:.4f}" for k, v in command.Parameters.items()
                            if k in "XYZIJ" or (k == "F" and command.Name != "G0"))
            out.write(command.Name + words + "\n")
        out.write("M2\n")


folder, programs = os.environ["SHAPES"], os.environ.get("PROGRAMS")
for shape in SHAPES:
    with open(f"{folder}/{shape}.json") as file:
        block, depth = block_with(json.load(file))
    for diameter in (6, 10):
        for stepover in (20, 40):
            document = FreeCAD.newDocument("benchmark")
            operation = adaptive(document, block, depth, diameter, stepover)
            seconds = min(seconds_to_execute(operation) for _ in range(RUNS))
            done = moves(operation)
            print(f"| {shape} | adaptive | {diameter} | {stepover} |" + " - |" * 4 + f" {len(done)} |" + " - |" * 7 +
                  f" {seconds:.4f} |", flush=True)
            if programs:
                write_program(done, f"{programs}/{shape}-{diameter}-{stepover}.ngc")
            FreeCAD.closeDocument("benchmark")
