; decimal_comma.nc:2: unexpected ','; this is no G-code word
G0 X1,25 Y5
