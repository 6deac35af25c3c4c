; pocket for a laser engraver turned mill
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
G0 X40 F1500
M5
