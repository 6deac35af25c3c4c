; contradiction.nc:2: G1 contradicts another G word of its block; split the block
G0 G1 X1 F100
