; decimal_comma.nc:2: a comma without a letter behind it; write numbers with a point
G0 X1,25 Y5
