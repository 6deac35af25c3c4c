%
(pocket)
(Machine)
(  vendor: Tormach)
(T1  D=6. CR=0. - ZMIN=-2. - flat end mill)
G90 G94 G17 G91.1 G40 G49 G80 G54
G21 (Millimeters)
G30
N10(2D Pocket1)
T1 G43 H1 M6
S8000 M4 M8
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
