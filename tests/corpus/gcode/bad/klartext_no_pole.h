; klartext_no_pole.h:3: arc without its centre (CC) or direction (DR); give both
0 BEGIN PGM A MM
1 C X+0 Y+0 DR+ F100
2 END PGM A MM
