; arc_radius.nc:4: arc whose radius is 5.3 mm at its start and 4.7 mm at its end; controls refuse it, post with more decimals
G21 G90 G0 X0 Y0 Z0
F100
G2 X10 Y0 I5.3
