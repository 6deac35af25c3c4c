; unknown_g.nc:3: G12 is not read; post the program without it
G0 X0 Y0 Z0
G12 I5 F100
