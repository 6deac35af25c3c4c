; compensation.nc:3: G41 cutter radius compensation is not read; post the path of the tool's centre (G40)
G21 G90 G0 X0 Y0 Z0 F100
G41 D1 X10
