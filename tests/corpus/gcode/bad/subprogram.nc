; subprogram.nc:3: subprogram O2000 is neither in the program nor in a file of that name beside it; put the file there
G0 X0. Y0.
M98 P2000
