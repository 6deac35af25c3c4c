; klartext_cycle.h:3: cycle 203 is not read; post its moves one by one
0 BEGIN PGM A MM
1 CYCL DEF 203 UNIVERSAL DRILLING ~
2 END PGM A MM
