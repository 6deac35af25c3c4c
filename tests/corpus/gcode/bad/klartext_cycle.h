; klartext_cycle.h:3: cycle 205 is not read; post its moves one by one
0 BEGIN PGM A MM
1 CYCL DEF 205 UNIVERSAL PECKING ~
2 END PGM A MM
