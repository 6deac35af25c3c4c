; compensation.nc:3: cutter compensation by the radius of D1, and no tool T1 is given; add it by --tool, or state it in the job
G21 G90 G0 X0 Y0 Z0 F100
G41 D1 X10
