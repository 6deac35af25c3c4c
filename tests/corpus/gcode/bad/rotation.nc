; rotation.nc:2: G68 is not read; post the program without it
G68 X0 Y0 R30
