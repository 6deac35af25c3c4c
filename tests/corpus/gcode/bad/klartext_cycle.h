; klartext_cycle.h:3: cycle 200 is not read; post its moves one by one
0 BEGIN PGM A MM
1 CYCL DEF 200 DRILLING ~
2 END PGM A MM
