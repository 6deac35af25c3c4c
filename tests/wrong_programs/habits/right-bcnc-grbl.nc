(Bit: 6mm)
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
