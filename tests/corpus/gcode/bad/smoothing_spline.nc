; smoothing_spline.nc:3: G5.1 is a spline, which is not read; post lines and arcs
G0 X0 Y0 Z5 F100
G5.1 X10 Y10 I3 J3
