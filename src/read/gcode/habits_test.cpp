// How the programs of CAM systems and controls begin, end, drill and stop: small twins of what they write, and what a machinist says of each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "read/gcode/test_told_program.h"

namespace clearcut::read::gcode {
namespace {

struct Habit {
  const char* who;  ///< CAM or control
  const char* program;
  const char* control;  ///< whose program it is, as --dialect names it
  const char* answer;   ///< names of conditions, or what a refusal says
};

constexpr Habit kHabits[] = {
    {"Fusion 360 for Grbl",
     "(1001)\n(T1 D=6 CR=0 - ZMIN=-3 - FLAT END MILL)\nG90 G94\nG17\nG21\n\n(2D POCKET1)\nS12000 M3\nG54\nG0 "
     "X10 Y10\nZ15\nZ5\n"
     "G1 Z-1 F300\nX20 F900\nG0 Z15\nM5\nM30\n",
     "grbl", ""},
    {"Fusion 360 for Haas",
     "%\nO01001\n(T1 D=6. CR=0. - ZMIN=-3. - FLAT END MILL)\nG90 G94 G17\nG21\nG53 G0 Z0.\n\nN10 (2D "
     "POCKET1)\nT1 M6\nS8000 M3\nG54\nM8\n"
     "G0 X10. Y10.\nG43 Z15. H1\nG0 Z5.\nG1 Z-1. F300.\nX20. F900.\nG0 Z15.\nM9\nM5\nG53 G0 Z0.\nG53 G0 "
     "Y0.\nM30\n%\n",
     "haas", "blending"},
    {"Fusion 360 for Fanuc",
     "%\nO1001\nN10 G90 G94 G17 G49 G40 G80\nN15 G21\nN20 G28 G91 Z0.\nN25 G90\nN30 T1 M6\nN35 S8000 M3\nN40 "
     "G54\nN45 G0 X10. Y10.\nN50 G43 "
     "Z15. H1\nN55 G1 Z-1. F300.\nN60 X20. F900.\nN65 G0 Z15.\nN70 M5\nN75 G28 G91 Z0.\nN80 M30\n%\n",
     "fanuc", "blending"},
    {"Fusion 360 for LinuxCNC",
     "%\n(AXIS,stop)\n(1001)\nN10 G90 G94 G17 G91.1\nN15 G21\nN20 G53 G0 Z0.\nN25 T1 M6\nN30 S8000 M3\nN35 "
     "G54 G64 P0.01\nN40 G0 X10. Y10.\nN45 G43 "
     "Z15. H1\nN50 G1 Z-1. F300.\nN55 X20. F900.\nN60 G0 Z15.\nN65 M30\n%\n",
     "linuxcnc", "g53"},
    {"Fusion 360 for Siemens",
     "; %_N_1001_MPF\nN10 G90 G94\nN11 G71\nN12 G64\nN13 G17\nN14 G0 SUPA Z0 D0\nN15 T=\"1\"\nN16 M6\nN17 "
     "S8000 M3\nN18 G54\nN19 G0 X10 Y10 D1\nN20 "
     "Z15\nN21 G1 Z-1 F300\nN22 X20 F900\nN23 G0 Z15\nN24 G0 SUPA Z0 D0\nN25 M30\n",
     "siemens", "g71 blending"},
    {"Fusion 360 for Heidenhain",
     "0 BEGIN PGM 1001 MM\n1 TOOL CALL 1 Z S8000\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 M3\n5 "
     "L X+10 Y+10 R0 FMAX\n6 L Z+15 R0 "
     "FMAX\n7 L Z-1 R0 F300\n8 L X+20 F900\n9 L Z+15 FMAX\n10 M30\n11 END PGM 1001 MM\n",
     "heidenhain", ""},
    {"Mastercam for Fanuc",
     "%\nO0000(PART)\n(DATE=DD-MM-YY - 01-02-25 TIME=HH:MM - 10:11)\nN100 G21\nN102 G0 G17 G40 G49 G80 "
     "G90\nN104 T1 M6\nN106 G0 G90 G54 X10. Y10. A0. "
     "S8000 M3\nN108 G43 H1 Z15. M8\nN110 Z5.\nN112 G1 Z-1. F300.\nN114 X20. F900.\nN116 G0 Z15.\nN118 "
     "M5\nN120 G91 G28 Z0. M9\nN122 G28 X0. Y0. "
     "A0.\nN124 M30\n%\n",
     "fanuc", "blending"},
    {"SolidCAM: subprograms behind the end",
     "%\nO1000\nG21 G90 G17 G40 G80 G94 G61\nT1 M6\nS8000 M3\nG54 G0 X0. Y0.\nG43 H1 Z15.\nM98 P2000 L2\nG0 "
     "Z15.\nM30\nO2000\nG91\nG0 X10.\nG90\nG0 "
     "Z2.\nG1 Z-1. F300.\nG0 Z15.\nM99\n%\n",
     "fanuc", ""},
    {"Vectric for Mach3",
     "( Profile 1 )\n( Mach2/3 Postprocessor )\nN20 G0 G21 G17 G90 G40 G49 G80\nN30 G71 G91.1\nN40 T1 "
     "M6\nN50 G0 G43 Z20. H1\nN60 S12000 M3\nN70 G94\nN80 X0 "
     "Y0 F900\nN90 G0 X10 Y10 Z6\nN100 G1 Z-1 F300\nN110 G1 X20 F900\nN120 G0 Z6\nN130 M9\nN140 M30\n",
     "mach3", "blending"},
    {"Vectric for Grbl",
     "T1\nG17\nG21\nG90\nG0Z20.320\nG0X0.000Y0.000\nS12000M3\nG0X10.000Y10.000Z5.080\nG1Z-1.000F300.0\nG1X20."
     "000F900.0\nG0Z5.080\nM5\nM2\n",
     "grbl", ""},
    {"FreeCAD for LinuxCNC",
     "(Exported by FreeCAD)\n(Post Processor: linuxcnc_post)\n(begin preamble)\nG17 G54 G40 G49 G80 "
     "G90\nG21\n(begin operation: TC: 6mm)\nM5\nM6 T1\nG43 H1\nM3 "
     "S8000\n(finish operation)\nG0 Z15.000\nG0 X10.000 Y10.000\nG1 X10.000 Y10.000 Z-1.000 F300.000\nG1 "
     "X20.000 F900.000\nG0 Z15.000\nM05\nG17 G54 "
     "G90 G80 G40\nM2\n",
     "linuxcnc", "blending"},
    {"Carbide Create",
     "%\n(PREAMBLE)\n(SOURCE: part.c2d)\nG21\nG90\n(TOOL/MILL,6.00, 0.00, 0.00, 0.0)\n(END PREAMBLE)\nG0 "
     "Z12\nM05\n(Move to safe Z to avoid workholding)\nM6 "
     "T201\nM03 S12000\nG0 X10.000 Y10.000\nG1 Z-1.000 F300.0\nX20.000 F900.0\nG0 Z12.000\nM05\nM02\n",
     "grbl", "m6"},
    {"Estlcam for Grbl",
     "(Project part)\nG90\nG21\nG94\nM03 S12000\nG00 Z5.0000\nG00 X10.0000 Y10.0000\nG01 Z-1.0000 F300\nG01 "
     "X20.0000 F900\nG00 Z5.0000\nM05\nM30\n",
     "grbl", ""},
    {"Easel",
     "G21\nG90\nG1 Z3.810 F228.6\nG0 X10.000 Y10.000\nM3 S12000\nG1 Z-1.000 F300.0\nG1 X20.000 F900.0\nG1 "
     "Z3.810\nM5\n",
     "grbl", "start-position"},
    {"CamBam",
     "( Made using CamBam )\n( T1 : 6.0 )\nG21 G90 G61 G40\nG0 Z3.0\nT1 M6\nG17\nM3 S8000\nG0 X10.0 "
     "Y10.0\nG1 F300.0 Z-1.0\nG1 F900.0 X20.0\nG0 Z3.0\nM5\nM30\n",
     "linuxcnc", ""},
    {"SheetCam",
     "(Filename: part.nc)\n(Post processor: Mach3.post)\nN0010 (Part: part)\nN0020 G21 (Units: "
     "Metric)\nN0030 G53 G90 G91.1 G40\nN0040 F1\nN0050 S500\nN0060 M6 T1\nN0070 S8000 M03\nN0080 G0 X10 Y10 "
     "Z15\nN0090 G1 Z-1 F300\nN0100 X20 F900\nN0110 G0 Z15\nN0120 M05 M30\n",
     "mach3", "blending"},
    {"Kiri:Moto",
     "; Generated by Kiri:Moto\n; Target: Any.Grbl\nG21\nG90\nM3 S8000\nG0 X10 Y10 Z15\nG1 Z-1 F300\nG1 X20 "
     "F900\nG0 Z15\nM5\nM30\n",
     "grbl", ""},
    {"Inkscape gcodetools",
     "%\n(Header)\n(Generated by gcodetools from Inkscape.)\nM3\n(Header end.)\nG21 (All units in mm)\nG00 "
     "Z5.000000\nG00 X10.000000 Y10.000000\nG01 Z-1.000000 F100.0(Penetrate)\nG01 X20.000000 Y10.000000 "
     "Z-1.000000 F400.000000\nG00 Z5.000000\nM5\nG00 X0.0000 Y0.0000\nM2\n%\n",
     "grbl", ""},
    {"a lower-case program without blanks",
     "g21g17g90g94g54\ng61\nm3s8000\ng0x10y10z5\ng1z-1f300\nx20f900\ng0z5\nm2\n", "linuxcnc", ""},
    {"G28 through a place",
     "G21 G17 G90 G94 G54 G61\nT1 M6\nG43 H1\nM3 S8000\nG0 X10 Y10 Z5\nG1 Z-1 F300\nG28 X10 Y10 Z20\nM2\n",
     "linuxcnc", "g28-home"},
    {"a second work offset",
     "G21 G17 G90 G94 G54 G61\nM3 S8000\nG0 X10 Y10 Z5\nG55\nG0 X10 Y10 Z5\nG1 Z-1 F300\nG0 Z5\nM2\n",
     "linuxcnc", "g55"},
    {"no units and no distance mode", "T1 M6\nG43 H1\nM3 S8000\nG0 X10 Y10 Z5\nG1 Z-1 F300\nG0 Z5\nM2\n",
     "linuxcnc", "units blending"},
    {"a program cut short", "G21 G17 G90 G94 G54 G61\nM3 S8000\nG0 X10 Y10 Z5\nG1 Z-1 F300\nX2", "linuxcnc",
     "program-end ends-low"},
    {"Haas: G187 smoothness without a bound",
     "%\nO00002\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nG187 P3\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 "
     "Z-1. F300.\nG0 Z5.\nM30\n%\n",
     "haas", "blending"},
    {"Haas: G154 P2",
     "%\nO00002\nG21 G17 G90 G94 G40 G49 G80 G154 P2\nG187 E0.01\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 "
     "Z5.\nG1 Z-1. F300.\nG0 Z5.\nM30\n%\n",
     "haas", "g154-p2"},
    {"Fanuc: H of another tool",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H2 Z5.\nG1 Z-1. "
     "F300.\nG0 Z5.\nM30\n%\n",
     "fanuc", "tool-length-h2"},
    {"Fanuc: numbers without a point",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10 Y10\nG43 H1 Z5.\nG1 Z-1. "
     "F300\nG0 Z5.\nM30\n%\n",
     "fanuc", "decimal-point"},
    {"Fanuc: tapping with M29",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS500 M3\nG0 X10. Y10.\nG43 H1 Z5.\nM29 S500\nG98 "
     "G84 X10. Y10. Z-5. R2. F500.\nG80\nM30\n%\n",
     "fanuc", ""},
    {"drilling in a row, G99 and G98",
     "G21 G17 G90 G94 G54 G61\nT1 M6\nG43 H1\nM3 S2000\nG0 X0 Y0 Z10\nG99 G81 X10 Y0 Z-5 R2 F100\nX20\nG98 "
     "X30\nG80\nM2\n",
     "linuxcnc", ""},
    {"probing before the work",
     "G21 G17 G90 G94 G54 G61\nG0 X10 Y10 Z5\nG38.2 Z-20 F50\nG10 L20 P1 Z0\nG0 Z5\nM3 S8000\nG1 Z-1 "
     "F300\nG0 Z5\nM2\n",
     "linuxcnc", "measured-move g10"},
    {"a shift by G92",
     "G21 G17 G90 G94 G54 G61\nG0 X0 Y0 Z5\nG92 X10 Y10\nM3 S8000\nG0 X20 Y10\nG1 Z-1 F300\nG0 "
     "Z5\nG92.1\nM2\n",
     "linuxcnc", "g92"},
    {"mist", "G21 G17 G90 G94 G54\nM3 S8000\nM7\nG0 X10 Y10 Z5\nG1 Z-1 F300\nG0 Z5\nM5 M9\nM30\n", "grbl",
     "m7"},
    {"G41 on Grbl", "G21 G90 G94 G54\nM3 S8000\nG0 X0 Y0 Z5\nG41 D1\nG1 X5 F300\nM30\n", "grbl",
     "p:4: G41 is no word of grbl; post the program for this control, or name another"},
    {"a spline", "G21 G90 G17 G94 G54 G61\nM3 S8000\nG0 X0 Y0 Z-1\nG5 I0 J3 P0 Q-3 X1 Y1 F100\nM2\n",
     "linuxcnc", "p:4: G5 is not read; post the program without it"},
    {"a fourth axis that turns",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nS8000 M3\nG0 X10. Y10. A90.\nM30\n%\n", "fanuc",
     "p:6: axis word A; only the three axes X, Y, Z are read"},
    {"threads by G76",
     "G21 G17 G90 G94 G54 G61\nT1 M6\nG43 H1\nM3 S500\nG0 X10 Y0 Z5\nG76 P1 Z-10 I-1 J0.2 K1\nM2\n",
     "linuxcnc", "p:6: G76 cuts a thread in passes here, which is not read; mill it by G2 and G3"},
    {"Marlin",
     "; made for Marlin\nM107\nG90\nG21\nM3 S255\nG0 X10 Y10 F3000\nG0 Z5 F600\nG1 Z-1 F300\nG1 X20 F900\nG0 "
     "Z5 F600\nM5\nM117 DONE\n",
     "marlin", "m107"},
    {"PathPilot",
     "(PathPilot)\nG17 G90\nG21\nG64 P0.01\nG54\nT1 M6 G43 H1\nS8000 M3\nG0 X10 Y10\nZ5\nG1 Z-1 F300\nG0 "
     "Z5\nM5\nM30\n",
     "tormach", ""},
    {"Heidenhain: cycle 200 with M99",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S2000\n2 M3\n3 CYCL DEF 32.0 TOLERANCE\n4 CYCL DEF 32.1 T0.01\n5 "
     "CYCL DEF 200 DRILLING ~\nQ200=+2 ~\nQ201=-5 ~\nQ206=+100 ~\nQ202=+5 ~\nQ210=+0 ~\nQ203=+0 ~\nQ204=+10 "
     "~\nQ211=+0\n6 L X+10 Y+10 R0 FMAX M99\n7 L Z+50 R0 FMAX M30\n8 END PGM A MM\n",
     "heidenhain", ""},
    {"Heidenhain: M91 at the end",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S2000\n2 M3\n3 CYCL DEF 32.0 TOLERANCE\n4 CYCL DEF 32.1 T0.01\n5 L "
     "X+10 Y+10 Z+5 R0 FMAX\n6 L Z-1 F100\n7 L Z+5 FMAX\n8 L Z-1 R0 FMAX M91\n9 M30\n10 END PGM A MM\n",
     "heidenhain", "m91"},
    {"bCNC for Grbl",
     "G21\nG90\nG17\nG94\nM3 S8000\nG0 Z5\nG0 X10 Y10\nG1 Z-1 F300\nG2 X20 Y10 I5 J0 F900\nG0 Z5\nM5\nM2\n",
     "grbl", ""},
    {"HSMWorks for Mach4",
     "(1001)\nG90 G94 G91.1 G40 G49 G17\nG21\nG61\nG28 G91 Z0.\nG90\nT1 M6\nS8000 M3\nG54\nG0 X10. Y10.\nG43 "
     "Z15. H1\nG1 Z-1. F300.\nG0 Z15.\nG28 G91 Z0.\nM30\n",
     "mach4", "g28-home"},
    {"BobCAD for Fanuc: G05.1 Q1",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG05.1 Q1\nG1 "
     "Z-1. F300.\nX20. F900.\nG0 Z5.\nM30\n%\n",
     "fanuc", "blending"},
    {"Esprit for Mazak",
     "%\nO0002(PART)\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 "
     "Z-1. F300.\nX20. F900.\nG0 Z5.\nM30\n%\n",
     "mazak", ""},
    {"GibbsCAM for Haas: G103",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG187 E0.01\nG103 "
     "P1\nG1 Z-1. F300.\nX20. F900.\nG0 Z5.\nM30\n%\n",
     "haas", ""},
    {"NX for Siemens",
     "N10 G40 G17 G710 G94 G90 G60 G601 FNORM\nN20 TRAFOOF\nN30 SUPA G0 Z0 D0\nN40 T=\"1\" M6\nN50 "
     "CYCLE832(0.01,_FINISH,1)\nN60 G54 D1\nN70 S8000 M3\nN80 G0 X10 Y10\nN90 Z5\nN100 G1 Z-1 F300\nN110 X20 "
     "F900\nN120 G0 Z5\nN130 M30\n",
     "siemens", ""},
    {"hyperMILL for Siemens: G642 with CTOL",
     "N1 G17 G710 G90 G94\nN2 T1 M6\nN3 D1 S8000 M3\nN4 G642 CTOL=0.005\nN5 COMPCAD\nN6 G54\nN7 G0 X10 Y10 "
     "Z5\nN8 G1 Z-1 F300\nN9 G0 Z5\nN10 M30\n",
     "siemens", ""},
    {"PowerMill for Heidenhain",
     "0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 X+50 Y+50 Z+0\n3 TOOL CALL 1 Z S8000 "
     "F900\n4 CYCL DEF 247 DATUM SETTING ~\nQ339=+1\n5 CYCL DEF 32.0 TOLERANCE\n6 CYCL DEF 32.1 T0.005\n7 "
     "CYCL DEF 32.2 HSC-MODE:0 TA0.5\n8 M3\n9 L X+10 Y+10 Z+5 R0 FMAX\n10 L Z-1 F300\n11 L X+20 FAUTO\n12 L "
     "Z+5 FMAX M30\n13 END PGM A MM\n",
     "heidenhain", "datum-247"},
    {"Fanuc: G10 L2 sets the offset",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nG10 L2 P1 X0. Y0. Z0.\nT1 M6\nS8000 M3\nG0 X10. "
     "Y10.\nG43 H1 Z5.\nG1 Z-1. F300.\nX20. F900.\nG0 Z5.\nM30\n%\n",
     "fanuc", "g10"},
    {"Fanuc: optional blocks",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\n/M8\nG1 Z-1. "
     "F300.\nX20. F900.\nG0 Z5.\nM30\n%\n",
     "fanuc", "block-delete"},
    {"Fanuc: high-speed look-ahead, AI contour off",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG64\nG1 Z-1. "
     "F300.\nX20. F900.\nG0 Z5.\nM30\n%\n",
     "fanuc", "blending"},
    {"Haas: local subprogram",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG187 E0.01\nM97 "
     "P100 L2\nM30\nN100 G1 Z-1. F300.\nG0 Z5.\nM99\n%\n",
     "haas", ""},
    {"LinuxCNC: a subroutine of the program",
     "o100 sub\nG0 X#1 Y10\nG1 Z-1 F300\nG0 Z5\no100 endsub\nG21 G17 G90 G94 G54 G61\nT1 M6\nG43 H1\nM3 "
     "S8000\nG0 X0 Y0 Z5\no100 call [10]\no100 call [20]\nM2\n",
     "linuxcnc", ""},
    {"PathPilot: a subroutine of the program",
     "o100 sub\nG0 X#1 Y10\nG1 Z-1 F300\nG0 Z5\no100 endsub\nG21 G17 G90 G94 G54 G61\nT1 M6 G43 H1\nM3 "
     "S8000\nG0 X0 Y0 Z5\no100 call [10]\nM2\n",
     "tormach", ""},
    {"Mach3: axes turned by G68",
     "G21 G17 G90 G94 G54 G61 G91.1\nT1 M6\nG43 H1\nM3 S8000\nG0 X0 Y0 Z5\nG68 X0 Y0 R30\nG0 X10 Y0\nG1 Z-1 "
     "F300\nG1 X20 F900\nG0 Z5\nG69\nM30\n",
     "mach3", ""},
    {"tools without M6 on a machine with a changer",
     "G21 G17 G90 G94 G54 G61\nT1\nG43 H1\nM3 S8000\nG0 X10 Y10 Z5\nG1 Z-1 F300\nG0 Z5\nM2\n", "linuxcnc",
     ""},
    {"a pause for the tool",
     "G21 G17 G90 G94 G54\nM3 S8000\nG0 X10 Y10 Z5\nG1 Z-1 F300\nG0 Z5\nM5\nM0\nM3 S8000\nG0 X20 Y10\nG1 Z-1 "
     "F300\nG0 Z5\nM5\nM30\n",
     "grbl", "tool-by-hand"},
    {"Fanuc: corner rounded by ,R",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. "
     "F300.\nX20. ,R2. F900.\nY20. ,C1.\nX10.\nG0 Z5.\nM30\n%\n",
     "fanuc", "corner-words"},
    {"Fanuc: R without its comma",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. "
     "F300.\nX20. R2. F900.\nY20.\nG0 Z5.\nM30\n%\n",
     "fanuc", "stray-word"},
    {"Fanuc: a line by its angle",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. "
     "F300.\nX20. ,A30. F900.\nG0 Z5.\nM30\n%\n",
     "fanuc", "p:9: ',A' states a line by its angle, which is not read; post both of its coordinates"},
    {"Haas: corner chamfered by ,C",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 \nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG187 E0.01\nG1 "
     "Z-1. F300.\nX20. ,C2. F900.\nY20.\nG0 Z5.\nM30\n%\n",
     "haas", ""},
    {"Haas: DPRNT while probing is off",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 \nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG187 E0.01\nG1 "
     "Z-1. F300.\nPOPEN\nDPRNT[PART*#5221[34]]\nPCLOS\nX20. F900.\nG0 Z5.\nM30\n%\n",
     "haas", ""},
    {"Fanuc: ATAN of two sides",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. "
     "F300.\n#1=ATAN[10.,10.]\nX[#1-20.] F900.\nG0 Z5.\nM30\n%\n",
     "fanuc", ""},
    {"ShopMill's contours for Siemens: RND and CHR",
     "G17 G710 G90 G94 G60\nT1 M6\nD1 S8000 M3\nG54\nG0 X10 Y10 Z5\nG1 Z-1 F300\nX20 RND=2 F900\nY20 "
     "CHR=1\nX10\nG0 Z5\nM30\n",
     "siemens", ""},
    {"Siemens: RNDM rounds every corner",
     "G17 G710 G90 G94 G60\nT1 M6\nD1 S8000 M3\nG54\nG0 X10 Y10 Z5\nG1 Z-1 F300\nX20 RNDM=2 F900\nY20\nG0 "
     "Z5\nM30\n",
     "siemens", "p:7: RNDM is not read; post the program without it"},
    {"Heidenhain: RND and CHF",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000 F900\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 L "
     "X+10 Y+10 Z+5 R0 FMAX M3\n5 L Z-1 F300\n6 L X+20 F900\n7 RND R2 F300\n8 L Y+20\n9 CHF 1\n10 L X+10\n11 "
     "L Z+5 FMAX M30\n12 END PGM A MM\n",
     "heidenhain", ""},
    {"Heidenhain: CYCL CALL POS",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000 F900\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 L "
     "X+10 Y+10 Z+5 R0 FMAX M3\n5 CYCL DEF 200 DRILLING Q200=2 Q201=-5 Q206=100 Q202=5 Q210=0 Q203=0 Q204=5 "
     "Q211=0\n6 CYCL CALL POS X+20 Y+20 Z+0 FMAX\n7 M30\n8 END PGM A MM\n",
     "heidenhain", ""},
    {"pcb2gcode for LinuxCNC",
     "( pcb2gcode )\n( Software-independent Gcode )\nG94 ( Millimeters per minute feed rate. "
     ")\nG21\nG90\nG00 S20000\nG64 P0.01000\nG01 F600\nG00 Z15.00000\nT1\nM5\nG04 P1\nM6\nM0\nM3\nG04 "
     "P1\nG00 Z2\nG00 X10 Y10\nG01 Z-0.1 F300\nG01 X20 F600\nG00 Z15\nM5\nM9\nM2\n",
     "linuxcnc", ""},
    {"FlatCAM for Grbl",
     "(G-CODE GENERATED BY FLATCAM)\n(Name: F_Cu)\nG21\nG90\nG94\nG01 F120.00\nG00 Z2.0000\nM03 S10000\nG4 "
     "P1\nG00 X10.0 Y10.0\nG01 F60.00\nG01 Z-0.1000\nG01 F120.00\nG01 X20.0 Y10.0\nG00 Z2.0\nM05\nG00 "
     "Z15.00\nG00 X0 Y0\n",
     "grbl", ""},
    {"jscut for Grbl",
     "G21         ; Set units to mm\nG90         ; Absolute positioning\nG1 Z25.4 F2540      ; Move to "
     "clearance level\n;\n; Operation:    0\n;\n; Rapid to initial position\nG1 X10 Y10 F2540\nG1 Z0.0000\n; "
     "plunge\nG1 Z-1 F127\n; cut\nG1 X20 F1016\n; Retract\nG1 Z25.4 F2540\nM2\n",
     "grbl", "start-position"},
    {"PyCAM for LinuxCNC",
     "G40 (disable tool radius compensation)\nG49\nG80\nG54\nG90\nG21\nG61\nF800.00000\nS1000.00000\nT1 "
     "M6\nG43 H1\nG0 Z5.0000\nM3\nG04 P3\nG0 X10.0000 Y10.0000\nG1 Z-1.0000\nX20.0000\nG0 Z5.0000\nM5\nM2\n",
     "linuxcnc", ""},
    {"Fusion 360 for Mach3",
     "(1001)\nN10 G90 G94 G91.1 G40 G49 G17\nN15 G21\n(When using Fusion for Personal Use)\nN20 G28 G91 "
     "Z0.\nN25 G90\nN30 T1 M6\nN35 S8000 M3\nN40 G54\nN45 G0 X10. Y10.\nN50 G43 Z15. H1\nN55 G1 Z-1. "
     "F300.\nN60 X20. F900.\nN65 G0 Z15.\nN70 M5\nN75 G28 G91 Z0.\nN80 G90\nN85 M30\n",
     "mach3", "g28-home blending"},
    {"Fusion 360 for PathPilot",
     "%\n(1001)\nG90 G54 G64 P0.01 G50 G17 G40 G80 G94 G91.1 G49\nG21\nG30\nN10 T1 G43 H1 M6\nS8000 "
     "M3\nG54\nG0 X10 Y10\nG0 Z15\nG1 Z-1 F300\nX20 F900\nG0 Z15\nM5\nG30\nM30\n%\n",
     "tormach", "g30-home"},
    {"Mastercam for Haas",
     "%\nO00001(PART)\n(MATERIAL - ALUMINUM MM - 6061)\nG21\nG0 G17 G40 G49 G80 G90\nT1 M6\nG0 G90 G54 X10. "
     "Y10. S8000 M3\nG43 H1 Z15.\nG187 P2 E0.01\nG1 Z-1. F300.\nX20. F900.\nG0 Z15.\nM5\nG91 G28 Z0.\nG28 "
     "Y0.\nG90\nM30\n%\n",
     "haas", ""},
    {"Edgecam for Fanuc: G52 and G05.1",
     "%\nO0003\nG21 G17 G90 G94 G40 G49 G80 G61\nG52 X0. Y0.\nG91 G28 Z0.\nG90\nT1 M6\nG54 S8000 M3\nG0 X10. "
     "Y10.\nG43 H1 Z5.\nG05.1 Q0\nG1 Z-1. F300.\nX20. F900.\nG0 Z5.\nG91 G28 Z0. M19\nG90\nM30\n%\n",
     "fanuc", ""},
    {"Fanuc: deep hole with G83",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG98 G83 "
     "Z-12. R2. Q3. F100.\nX20.\nG80\nG0 Z5.\nM30\n%\n",
     "fanuc", ""},
    {"Fanuc: boring by G76",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG98 G76 "
     "Z-12. R2. Q0.2 F100.\nG80\nG0 Z5.\nM30\n%\n",
     "fanuc", "oriented-retract"},
    {"Fanuc: tilted plane by G68.2",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG68.2 X0. "
     "Y0. Z0. I0. J30. K0.\nG1 Z-1. F300.\nG0 Z5.\nM30\n%\n",
     "fanuc", "p:8: G68.2 is not read; post the program without it"},
    {"Fanuc: tool centre point by G43.4",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43.4 H1 Z5.\nG1 Z-1. "
     "F300.\nG0 Z5.\nM30\n%\n",
     "fanuc", "p:7: G43.4 is not read; post the program without it"},
    {"Fanuc: G54.1 P1",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG54.1 P1\nG0 "
     "X10. Y10.\nG1 Z-1. F300.\nG0 Z5.\nM30\n%\n",
     "fanuc", "g54.1-p1"},
    {"Fanuc: cutter compensation of a finishing pass",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54 G61\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 Z-1. "
     "F300.\nG41 D1 X20. F900.\nY20.\nX10.\nG40 X5.\nG0 Z5.\nM30\n%\n",
     "fanuc",
     "p:9: cutter compensation by the radius of D1, and no tool T1 is given; add it by --tool, or state it "
     "in the job"},
    {"Haas: circular pocket by G12",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG187 E0.01\nG1 "
     "Z-1. F300.\nG12 I8. D1 F600.\nG0 Z5.\nM30\n%\n",
     "haas",
     "p:10: cutter compensation by the radius of D1, and no tool T1 is given; add it by --tool, or state it "
     "in the job"},
    {"Haas: pocket by G150",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG187 E0.01\nG150 "
     "P100 Z-5. Q1. R1. I2. K0.2 G41 D1 F500.\nG0 Z5.\nM30\n%\n",
     "haas",
     "p:9: G150 is not read: it clears its pocket by passes that the control chooses and nobody states; post "
     "the passes themselves"},
    {"Haas: tapping by G84",
     "%\nO0002\nG21 G17 G90 G94 G40 G49 G80 G54\nT1 M6\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG187 "
     "E0.01\nS500\nG84 Z-8. R2. F500.\nG80\nG0 Z5.\nM30\n%\n",
     "haas", "g98"},
    {"Mazak: second offset by G54.1",
     "(PART)\nG21 G17 G90 G94 G40 G49 G80 G61.1\nT1 M6\nG54.1 P2\nS8000 M3\nG0 X10. Y10.\nG43 H1 Z5.\nG1 "
     "Z-1. F300.\nX20. F900.\nG0 Z5.\nM30\n",
     "mazak", "g54.1-p2"},
    {"Mach3: a subprogram called twice",
     "G21 G17 G90 G94 G54 G61 G91.1\nT1 M6\nG43 H1\nM3 S8000\nG0 X10 Y10 Z5\nM98 P100 L2\nG90 G0 "
     "Z5\nM30\nO100\nG91 G1 Z-3 F300\nG0 Z3\nG0 X5\nM99\n",
     "mach3", ""},
    {"Grbl: homing by $H", "$H\nG21 G90\nM3 S8000\nG0 X10 Y10 Z5\nG1 Z-1 F300\nG0 Z5\nM2\n", "grbl",
     "p:1: unexpected '$'; this is no G-code word"},
    {"Grbl: probing the top by G38.2",
     "G21 G90 G94\nG0 X10 Y10\nG38.2 Z-20 F50\nG10 L20 P1 Z0\nG0 Z5\nM3 S8000\nG1 Z-1 F300\nG0 Z5\nM2\n",
     "grbl", "measured-move g10"},
    {"Grbl: a full circle",
     "G21 G90 G94 G17\nM3 S8000\nG0 X10 Y10 Z5\nG1 Z-1 F300\nG2 X10 Y10 I5 J0 F600\nG0 Z5\nM2\n", "grbl", ""},
    {"Easel in inches",
     "G20\nG90\nG1 Z0.15000 F9.0\nG0 X0.40000 Y0.40000\nG1 Z-0.02800 F9.0\nG1 X0.80000 Y0.40000 F30.0\nG1 "
     "Z0.15000 F9.0\nG0 X0.00000 Y0.00000\nM2\n",
     "grbl", "start-position"},
    {"Marlin: messages and G0 with F",
     "G21\nG90\nM117 Milling\nM3 S255\nG0 Z5 F600\nG0 X10 Y10 F3000\nG1 Z-1 F100\nG1 X20 F300\nG0 Z5 "
     "F600\nM5\n",
     "marlin", ""},
    {"LinuxCNC: threads by G33.1",
     "G21 G17 G90 G94 G54 G61\nT1 M6\nG43 H1\nM3 S8000\nG0 X10 Y10 Z5\nS500\nG0 Z2\nG33.1 Z-8 K1\nG0 "
     "Z5\nM2\n",
     "linuxcnc", ""},
    {"LinuxCNC: constant surface speed",
     "G21 G17 G90 G94 G54 G61\nT1 M6\nG43 H1\nM3 S8000\nG0 X10 Y10 Z5\nG96 D2000 S100\nG1 Z-1 F300\nG0 "
     "Z5\nM2\n",
     "linuxcnc", "p:6: G96 is not read; post the program without it"},
    {"LinuxCNC: an input that is waited for",
     "G21 G17 G90 G94 G54 G61\nT1 M6\nG43 H1\nM3 S8000\nG0 X10 Y10 Z5\nM66 P0 L3 Q5\nG1 Z-1 F300\nG0 "
     "Z5\nM2\n",
     "linuxcnc", "m66"},
    {"LinuxCNC: radius stated by G41.1",
     "G21 G17 G90 G94 G54 G61\nT1 M6\nG43 H1\nM3 S8000\nG0 X0 Y0 Z5\nG1 Z-1 F300\nG41.1 D6\nG1 X20 "
     "F900\nY20\nX5\nG40 X0\nG0 Z5\nM2\n",
     "linuxcnc", ""},
    {"PathPilot: conversational drilling",
     "(PathPilot)\nG17 G90 G21 G54 G40 G49 G80 G94 G64 P0.01\nT2 M6\nG43 H2\nM3 S1500\nG0 X10 Y10\nG0 "
     "Z5\nG98 G83 Z-10 R2 Q2 F100\nX20\nG80\nG0 Z15\nM5\nM30\n",
     "tormach", ""},
    {"Siemens: MCALL CYCLE83",
     "G17 G710 G90 G94 G60\nT1 M6\nD1 S8000 M3\nG54\nG0 X10 Y10 Z5\nF200\nMCALL "
     "CYCLE83(5,0,2,-12,,-3,,1,0,0,1,0)\nX10 Y10\nX20\nMCALL\nG0 Z5\nM30\n",
     "siemens", ""},
    {"Siemens: five axes by TRAORI",
     "G17 G710 G90 G94 G60\nT1 M6\nD1 S8000 M3\nG54\nG0 X10 Y10 Z5\nTRAORI\nG1 Z-1 F300\nG0 Z5\nM30\n",
     "siemens", "p:6: TRAORI is not read; post the program without it"},
    {"Siemens: a pocket cycle",
     "G17 G710 G90 G94 G60\nT1 M6\nD1 S8000 M3\nG54\nG0 X10 Y10 "
     "Z5\nPOCKET4(5,0,2,-5,10,20,20,2,0,0,300,200,0,11,,,,,)\nG0 Z5\nM30\n",
     "siemens", "p:6: POCKET4 is a cycle that is not read; post its moves one by one"},
    {"Siemens: a subprogram behind the program",
     "G17 G710 G90 G94 G60\nT1 M6\nD1 S8000 M3\nG54\nG0 X10 Y10 Z5\nDOWN(-1)\nG0 Z5\nM30\n%_N_DOWN_SPF\nPROC "
     "DOWN(REAL AT)\nG1 Z=AT F300\nG0 Z5\nM17\n",
     "siemens", ""},
    {"Fusion 360 for Okuma",
     "%\nOPART\n(T1 D=6. CR=0. - ZMIN=-3. - FLAT END MILL)\nN1 G40 G80 G90 G94 G17\nN2 G21\n\nN3 G90 G0 "
     "Z9999.\nN4 T1 M6\nN5 S8000 M3\nN6 G15 H1\nN7 G0 X10. Y10.\nN8 G0 G56 Z15. H1\nN9 G1 Z-1. F300.\nN10 "
     "X20. "
     "F900.\nN11 G0 Z15.\nN12 M5\nN13 M9\nN14 G90 G0 Z9999.\nN15 G30 P1\nN16 M2\n%\n",
     "okuma", "blending g30-home"},
    {"Okuma: retracts in H0, drilling by G71 and M53",
     "$PART.MIN%\nO0002\nG21 G17 G90 G94 G40 G61\nG16 H0 G0 Z0.\nT1 M6\nS8000 M3\nG15 H2\nG0 X10. Y10.\nG56 "
     "H1 "
     "Z15.\nG71 Z15.\nG17 G90 G82 X10. Y10. Z-3. R2. P500 F300. M53\nX20.\nG0 Z15.\nG16 H0 G0 Z0.\nM2\n%\n",
     "okuma", "g16 g15-h2 cycle-dwell"},
    {"Okuma: a subprogram",
     "O0002\nG21 G17 G90 G94 G61\nT1 M6\nS8000 M3\nG15 H1\nG0 X10. Y10.\nG56 H1 Z15.\nCALL O1000 Q2\nM2\n",
     "okuma",
     "p:8: 'CALL' is a word of OSP's macros and calls, which are not read; post the moves themselves"},
    {"Fusion 360 for grblHAL",
     "%\n(1001)\n(T1 D=6 CR=0 - ZMIN=-3 - FLAT END MILL)\nG90 G94\nG17\nG21\n(2D POCKET1)\nM5\nM9\nT1 "
     "M6\nS12000 M3\nG54\nG0 X10 Y10\nZ15\nG1 Z-1 F300\nX20 F900\nG0 Z15\nM5\nM30\n%\n",
     "grblhal", ""},
    {"grblHAL: a second tool and cycles",
     "G21 G90 G17 G94\nT1 M6\nS8000 M3\nG0 X10 Y10 Z15\nG1 Z-1 F300\nX20\nG0 Z15\nM5\nT2 M6\nS3000 M3\nG0 X0 "
     "Y0\nG98 G83 Z-9 R2 Q3 F100\nX5\nG82 Z-2 R2 P0.5\nG80\nG0 Z15\nM30\n",
     "grblhal", "m6"},
    {"grblHAL: radius compensation",
     "G21 G90 G17 G94\nT1 M6\nS8000 M3\nG0 X10 Y10 Z15\nG1 Z-1 F300\nG41 D1 X20\nG40\nM30\n", "grblhal",
     "p:6: G41 is no word of grblhal; post the program for this control, or name another"},
    {"Heidenhain: tapping by cycle 207",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000 F900\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 L "
     "X+10 Y+10 Z+5 R0 FMAX M3\n5 TOOL CALL Z S500\n6 CYCL DEF 207 RIGID TAPPING NEW Q200=2 Q201=-8 Q239=+1 "
     "Q203=+0 Q204=5\n7 CYCL CALL\nL Z+5 FMAX M30\nEND PGM A MM\n",
     "heidenhain", ""},
    {"Heidenhain: APPR and DEP with compensation",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000 F900\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 L "
     "X+10 Y+10 Z+5 R0 FMAX M3\n5 L Z-1 F300\n6 APPR LT X+20 Y+20 LEN10 RL F900\n7 L Y+40\n8 L X+40\n9 DEP "
     "LT LEN10\nL Z+5 FMAX M30\nEND PGM A MM\n",
     "heidenhain",
     "p:7: cutter compensation by the radius of the tool table, and no tool T1 is given; add it by --tool, "
     "or state it in the job"},
    {"Heidenhain: tilted plane",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000 F900\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 L "
     "X+10 Y+10 Z+5 R0 FMAX M3\n5 PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY\n6 L Z-1 F300\nL Z+5 FMAX M30\nEND "
     "PGM A MM\n",
     "heidenhain",
     "p:6: block 'PLANE' is not read; post the program with L, C, CR, CP, CT, RND, CHF, APPR and DEP blocks "
     "only"},
    {"Heidenhain: M128",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000 F900\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 L "
     "X+10 Y+10 Z+5 R0 FMAX M3\n5 L M128\n6 L Z-1 F300\nL Z+5 FMAX M30\nEND PGM A MM\n",
     "heidenhain",
     "p:6: M128, which holds the tip while rotary axes turn, is not read; post the program without it"},
    {"Heidenhain: M140 MB MAX",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000 F900\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 L "
     "X+10 Y+10 Z+5 R0 FMAX M3\n5 L Z-1 F300\n6 L X+20 F900\n7 L M140 MB MAX\n8 M30\n9 END PGM A MM\n",
     "heidenhain", ""},
    {"Heidenhain: a pattern by labels",
     "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000 F900\n2 CYCL DEF 32.0 TOLERANCE\n3 CYCL DEF 32.1 T0.01\n4 L "
     "X+10 Y+10 Z+5 R0 FMAX M3\n5 CYCL DEF 200 DRILLING Q200=2 Q201=-5 Q206=100 Q202=5 Q210=0 Q203=0 Q204=5 "
     "Q211=0\n6 LBL 1\n7 L IX+10 FMAX M99\n8 CALL LBL 1 REP 3\nL Z+5 FMAX M30\nEND PGM A MM\n",
     "heidenhain", ""},
};

/// Conditions by name, or what is refused.
std::string answer_to(const Habit& habit) {
  ReadControllerOptions options;
  options.dialect = dialect_named(habit.control);
  try {
    std::string names;
    for (const Condition& one : read_gcode(habit.program, "p", options).conditions)
      names += (names.empty() ? "" : " ") + one.name;
    return names;
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ProgramHabits, AreReadAsAMachinistReadsThem) {
  for (const Habit& habit : kHabits) EXPECT_EQ(answer_to(habit), habit.answer) << habit.who;
}

}  // namespace
}  // namespace clearcut::read::gcode
