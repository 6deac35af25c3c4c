; twice.nc:2: two X words in one block; split it
G0 X0 X1
