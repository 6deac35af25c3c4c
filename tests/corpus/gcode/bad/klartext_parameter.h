; klartext_parameter.h:4: '+Q1' is no plain number (Q parameters are not read); correct it
0 BEGIN PGM A MM
1 TOOL CALL 1 Z S1000
2 L X+Q1 Y+0 R0 FMAX
3 END PGM A MM
