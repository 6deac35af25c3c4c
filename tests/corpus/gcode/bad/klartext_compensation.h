; klartext_compensation.h:3: RL radius compensation is not read; post the tool's centre (R0)
0 BEGIN PGM A MM
1 L X+0 Y+0 RL F100
2 END PGM A MM
