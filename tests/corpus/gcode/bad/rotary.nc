; rotary.nc:2: axis word A; only the three axes X, Y, Z are read
G0 X0 A90
