; arc_no_centre.nc:3: arc without I, J or R; give its centre
G21 G90 G0 X0 Y0 Z0 F100
G2 X10 Y0
