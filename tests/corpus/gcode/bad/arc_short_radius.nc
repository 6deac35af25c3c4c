; arc_short_radius.nc:3: arc of radius 4 mm cannot reach its end, 10 mm away; correct R
G21 G90 G0 X0 Y0 Z0 F100
G2 X10 Y0 R4
