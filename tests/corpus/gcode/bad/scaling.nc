; scaling.nc:2: G51 without its factor P takes it from a setting of the control; add P
G51 X0 Y0 Z0.
