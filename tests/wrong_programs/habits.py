"""Programs in the habits of other CAM systems, written for this folder, each with a twin in which one thing is wrong. Checked without
a part."""
import json
import shutil

from writer import OUT

FUSION_GRBL = """(pocket)
(T1  D=6 CR=0 - ZMIN=-2 - flat end mill)
G90 G94
G17
G21
G28 G91 Z0
G90

(2D Pocket1)
T1
S12000 M3
G54
G0 X10 Y10
Z15
Z5
G1 Z1 F333
Z-2
X11 F1000
G3 X9 I-1 J0
X11 I1 J0
G1 X13
G3 X7 I-3 J0
X13 I3 J0
G1 X10 Y10
G0 Z15
M5
G28 G91 Z0
G90
G28 G91 X0 Y0
G90
M30
"""

FUSION_HAAS = """%
O01001 (pocket)
(Using high feed G1 F5000. instead of G0.)
(T1  D=6. CR=0. - ZMIN=-2. - flat end mill)
N10 G90 G94 G17
N15 G21
N20 G53 G0 Z0.
N25 (2D Pocket1)
N30 T1 M6
N35 S8000 M3
N40 G54
N45 G61
N50 G0 X10. Y10.
N55 G43 Z15. H1
N60 Z5.
N65 G1 Z-2. F333.
N70 X13. F1000.
N75 G3 X7. I-3. J0.
N80 X13. I3. J0.
N85 G0 Z15.
N90 M5
N95 G53 G0 Z0.
N100 M30
%
"""

MASTERCAM_FANUC = """%
O0001(POCKET)
(DATE=DD-MM-YY - 01-02-24 TIME=HH:MM - 10:00)
(MATERIAL - ALUMINUM MM - 2024)
( T1 |  6. FLAT ENDMILL | H1 )
N100 G21
N102 G0 G17 G40 G49 G80 G90
N103 G61
N104 T1 M6
N106 G0 G90 G54 X10. Y10. S8000 M3
N108 G43 H1 Z25.
N110 Z2.
N112 G1 Z-2. F150.
N114 X13. F600.
N116 G3 X7. Y10. I-3. J0.
N118 X13. Y10. I3. J0.
N120 G0 Z25.
N122 M5
N124 G91 G28 Z0.
N126 G28 X0. Y0.
N128 M30
%
"""

FREECAD = """(Exported by FreeCAD)
(Post Processor: linuxcnc_post)
(Output Time:2024-02-01 10:00:00)
(begin preamble)
G17 G54 G40 G49 G80 G90
G21
G61
(begin operation: TC: 6mm Endmill)
(machine units: mm_per_min)
(TC: 6mm Endmill)
M5
M6 T1
G43 H1
M3 S8000
(finish operation: TC: 6mm Endmill)
(begin operation: Pocket_Shape)
(machine units: mm_per_min)
(Pocket_Shape)
G0 Z5.000
G0 X10.000 Y10.000
G0 Z3.000
G1 X10.000 Y10.000 Z-2.000 F120.000
G1 X13.000 Y10.000 Z-2.000 F600.000
G3 X7.000 Y10.000 Z-2.000 I-3.000 J0.000 K0.000 F600.000
G3 X13.000 Y10.000 Z-2.000 I3.000 J0.000 K0.000 F600.000
G0 Z5.000
(finish operation: Pocket_Shape)
(begin postamble)
M05
G17 G54 G90 G80 G40
M2
"""

BCNC = """(Bit: 6mm)
(Block-name: Header)
G90 G21 G17 G94
M3 S10000
G4 P3
G0 Z7
(Block-name: pocket)
G0 X10 Y10
G1 Z-2 F100
G1 X13 F800
G3 X7 Y10 I-3
G3 X13 Y10 I3
G0 Z7
(Block-name: Footer)
M5
M2
"""

ESTLCAM = """(Project pocket)
(Created by Estlcam)
(Machining time about 00:01:00 hours)
(Required tools:)
(  End mill 6mm)
G21
G90
G94
M03 S24000
G00 Z5.0000
(No. 1: Pocket 1)
G00 X10.0000 Y10.0000
G00 Z0.5000
G01 Z-2.0000 F300 S24000
G01 X13.0000 F1200
G03 X7.0000 Y10.0000 I-3.0000 J0.0000
G03 X13.0000 Y10.0000 I3.0000 J0.0000
G00 Z5.0000
M05
M30
"""

PATHPILOT = """%
(pocket)
(Machine)
(  vendor: Tormach)
(T1  D=6. CR=0. - ZMIN=-2. - flat end mill)
G90 G94 G17 G91.1 G40 G49 G80 G54
G21 (Millimeters)
G30
N10(2D Pocket1)
T1 G43 H1 M6
S8000 M3 M8
G61
G0 X10. Y10.
G0 Z15.
G0 Z5.
G1 Z-2. F333.
G1 X13. F1000.
G3 X7. I-3. J0.
G3 X13. I3. J0.
G0 Z15.
M5 M9
G30
M30
%
"""

VCARVE_MACH3 = """( pocket )
( File created: Thursday, February 01, 2024 - 10:00 AM)
( Material Size)
( X= 100.000, Y= 60.000, Z= 20.000)
()
(Toolpaths used in this file:)
(Pocket 1)
(Tools used in this file: )
(1 = End Mill {6 mm})
N100G00G21G17G90G40G49G80
N105G71G91.1
N106G61
N110T1M06
N120 (End Mill {6 mm})
N130G00G43Z20.000H1
N140S12000M03
N150(Toolpath:- Pocket 1)
N170G94
N180X10.000Y10.000F1200.0
N190G00X10.000Y10.000Z5.000
N200G1Z-2.000F300.0
N210G1X13.000F1200.0
N220G3X7.000Y10.000I-3.000J0.000
N230G3X13.000Y10.000I3.000J0.000
N240G00Z20.000
N250M09
N260M30
"""

HEIDENHAIN = """0 BEGIN PGM POCKET MM
1 BLK FORM 0.1 Z X-20 Y-20 Z-10
2 BLK FORM 0.2 X+60 Y+60 Z+0
3 ;TOOL 1 - FLAT END MILL D6
4 TOOL CALL 1 Z S8000
5 CYCL DEF 32.0 TOLERANCE
6 CYCL DEF 32.1 T0.0005
7 L X+10 Y+10 R0 FMAX M3
8 L Z+5 FMAX
9 L Z-2 F150
10 L X+13 F600
11 CC X+10 Y+10
12 C X+7 Y+10 DR+
13 C X+13 Y+10 DR+
14 L Z+50 FMAX
15 M5
16 M30
17 END PGM POCKET MM
"""

MARLIN = """; pocket for a laser engraver turned mill
; tool: 6 mm end mill
G21
G90
M3 S255
G4 S3
G0 Z5 F1500
G0 X10 Y10 F3000
G1 Z-2 F120
G1 X13 F600
G3 X7 Y10 I-3 J0 F600
G3 X13 Y10 I3 J0 F600
G0 Z5 F1500
M5
"""

CAMBAM = """( Made using CamBam )
( Pockets 2/1/2024 10:00:00 AM )
( T1 : 6.0 )
( T2 : 3.0 )
G21 G90 G61 G40
G0 Z20.0
( T1 : 6.0 )
T1 M6
( Pocket1 )
G17
M3 S8000
G0 X10.0 Y10.0
G0 Z1.0
G1 F150.0 Z-2.0
G1 F600.0 X13.0
G3 X7.0 Y10.0 I-3.0 J0.0
G3 X13.0 Y10.0 I3.0 J0.0
G0 Z20.0
( T2 : 3.0 )
T2 M6
( Pocket2 )
M3 S8000
G0 X30.0 Y10.0
G0 Z1.0
G1 F100.0 Z-1.0
G1 F400.0 X33.0
G0 Z20.0
M5
M30
"""

JSCUT = """; Work area:   (0, 0)-(40, 30)
; Offset:      (0, 0)
G21         ; Set units to mm
G90         ; Absolute positioning
G1 Z25.4 F2540      ; Move to clearance level

;
; Operation:    0
; Name:
; Type:         Pocket
; Paths:        1
; Direction:    Climb
; Cut Depth:    2
; Pass Depth:   2
; Plunge rate:  120
; Cut rate:     1000
;

; Path 0
; Rapid to initial position
G1 X10.0000 Y10.0000 F2540
; plunge
G1 Z-2.0000 F120
; cut
G1 X13.0000 Y10.0000 F1000
G1 X13.0000 Y13.0000
G1 X7.0000 Y13.0000
G1 X7.0000 Y7.0000
; Retract
G1 Z25.4 F2540
M2
"""

PCB2GCODE = """( pcb2gcode 2.5.0 )
( Software-independent Gcode )

G94 (Millimeters per minute feed rate.)
G21 (Units == Millimeters.)
G90 (Absolute coordinates.)
G61

G00 Z20.00000 (Retract)
T1
M5      (Spindle stop.)
G04 P1.00000
M6      (Tool change.)
(MSG, Change tool bit to mill diameter 6.00000mm)
M0      (Temporary machine stop.)
M3 S8000 (Spindle on clockwise.)
G04 P1.00000 (Wait for spindle to get up to speed)
G00 X10.00000 Y10.00000
G00 Z2.00000
G01 Z-2.00000 F120.00000
G01 X13.00000 F600.00000
G01 X7.00000 Y13.00000
G00 Z20.00000
T2
M5      (Spindle stop.)
M6      (Tool change.)
(MSG, Change tool bit to mill diameter 3.00000mm)
M0      (Temporary machine stop.)
M3 S8000 (Spindle on clockwise.)
G04 P1.00000
G00 X30.00000 Y10.00000
G00 Z2.00000
G01 Z-1.00000 F120.00000
G01 X33.00000 F600.00000
G00 Z20.00000
M5      (Spindle off.)
M9      (Coolant off.)
M2      (Program end.)
"""

VECTRIC_INCH = """( pocket )
( File created: Thursday, February 01, 2024 - 10:00 AM)
( Material Size)
( X= 4.000, Y= 2.500, Z= 0.500)
(Tools used in this file: )
(1 = End Mill {6 mm})
N100G00G20G17G90G40G49G80
N105G70G91.1
N106G61
N110T1M06
N120 (End Mill {6 mm})
N130G00G43Z0.8000H1
N140S12000M03
N150(Toolpath:- Pocket 1)
N170G94
N180X0.4000Y0.4000F50.0
N190G00X0.4000Y0.4000Z0.2000
N200G1Z-0.0800F12.0
N210G1X0.5000F50.0
N220G3X0.3000Y0.4000I-0.1000J0.000
N230G3X0.5000Y0.4000I0.1000J0.000
N240G00Z0.8000
N250M09
N260M30
"""

#: Systems whose programs need a second tool.
PAIR = ["endmill:6:T1", "endmill:3:T2"]

#: Name, dialect, ending, program, conditions that a machine's owner has to accept, what makes its twin wrong (from, to, kind).
SYSTEMS = [
    ("fusion-grbl", "grbl", ".nc", FUSION_GRBL, ["g28-home"], ("G0 Z15\nM5", "G0 X40\nM5", "rapid-in-material")),
    ("fusion-haas", "haas", ".nc", FUSION_HAAS, [], ("N30 T1 M6\nN35 S8000 M3\n", "N30 S8000 M3\nN35 T1 M6\n",
                                                                   "spindle-off")),
    ("mastercam-fanuc", "fanuc", ".nc", MASTERCAM_FANUC, [], ("N108 G43 H1 Z25.", "N108 G43 H2 Z25.", "tool-length")),
    ("freecad-linuxcnc", "linuxcnc", ".ngc", FREECAD, [], ("G0 Z3.000", "G0 Z-1.000", "rapid-in-material")),
    ("bcnc-grbl", "grbl", ".nc", BCNC, [], ("G0 Z7\n(Block-name: Footer)", "G0 X40\n(Block-name: Footer)", "rapid-in-material")),
    ("estlcam-grbl", "grbl", ".nc", ESTLCAM, [], ("G01 Z-2.0000", "G01 Z-20.0000", "beyond-stock")),
    ("pathpilot", "linuxcnc", ".nc", PATHPILOT, ["g30-home"], ("S8000 M3", "S8000 M4", "spindle-direction")),
    ("vcarve-mach3", "mach3", ".tap", VCARVE_MACH3, [], ("N190G00X10.000Y10.000Z5.000", "N190G00X10.000Y10.000Z-1.000",
                                                         "rapid-in-material")),
    ("klartext", "heidenhain", ".H", HEIDENHAIN, [], ("14 L Z+50 FMAX", "14 L X+40 FMAX", "rapid-in-material")),
    ("cambam-mach3", "mach3", ".nc", CAMBAM, ["tool-by-hand", "arc-centres"], ("G0 Z20.0\nM5", "G0 X50.0\nM5", "rapid-in-material")),
    ("cambam-linuxcnc", "linuxcnc", ".nc", CAMBAM, ["tool-by-hand"], ("M3 S8000\nG0 X30.0", "G0 X30.0", "spindle-off")),
    ("jscut-grbl", "grbl", ".nc", JSCUT, ["spindle-by-hand", "start-position"], ("; Retract\nG1 Z25.4 F2540", "; Retract\nG0 X40", "rapid-in-material")),
    ("pcb2gcode", "linuxcnc", ".ngc", PCB2GCODE, ["tool-by-hand"], ("G00 Z2.00000\nG01 Z-1", "G00 Z-1.00000\nG01 Z-1",
                                                                    "rapid-in-material")),
    ("vectric-inch", "mach3", ".tap", VECTRIC_INCH, [], ("N200G1Z-0.0800F12.0", "N200G1Z-0.8000F12.0", "beyond-stock")),
    ("vectric-unnamed", "", ".tap", VECTRIC_INCH, [], ("N200G1Z-0.0800F12.0", "N200G1Z-0.8000F12.0", "beyond-stock")),
    ("vectric-on-grbl", "grbl", ".nc", VECTRIC_INCH, None, None),
    ("marlin", "marlin", ".gcode", MARLIN, [], ("G0 Z5 F1500\nM5", "G0 X40 F1500\nM5", "rapid-in-material")),
]


def habits():
    folder = OUT / "habits"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    cases = []

    def case(file, dialect, verdict, reason, accept, does):
        cases.append({"file": file, "part": "", "stock": "-20:60,-20:60,-10:0", "tools": ["endmill:6"] if "T2" not in text else PAIR, "dialect": dialect,
                      "does": does, "accept": accept, "verdict": verdict, "reason": reason})
    for name, dialect, ending, text, conditions, wrong in SYSTEMS:
        if wrong is None:
            (folder / f"{name}{ending}").write_text(text)
            case(f"{name}{ending}", dialect, "REFUSED", "", [], "has words that the control does not know")
            continue
        old, new, kind = wrong
        (folder / f"right-{name}{ending}").write_text(text)
        if conditions:
            case(f"right-{name}{ending}", dialect, "CONDITIONAL", conditions[0], [], "leaves something to whoever stands at the machine")
        case(f"right-{name}{ending}", dialect, "CLEAN", "", conditions, "mills a pocket as that system writes it")
        assert old in text, name
        (folder / f"{name}{ending}").write_text(text.replace(old, new))
        case(f"{name}{ending}", dialect, "FAULTY", kind, conditions, f"the same with one thing wrong: {kind}")
    (folder / "cases.json").write_text(json.dumps(cases, indent=1) + "\n")
    return len(cases)
