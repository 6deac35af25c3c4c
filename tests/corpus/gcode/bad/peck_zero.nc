; peck_zero.nc:3: peck drilling needs a Q word of a sensible size; correct it
G0 X0 Y0 Z5 F100
G83 X1 Z-3 R1 Q0
