; rotation.nc:2: G51 is not read; post the program without it
G51 X0 Y0 P2.
