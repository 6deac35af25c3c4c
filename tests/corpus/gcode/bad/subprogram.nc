; subprogram.nc:3: subprogram calls are not read; post the program without them
G0 X0. Y0.
M98 P2000
