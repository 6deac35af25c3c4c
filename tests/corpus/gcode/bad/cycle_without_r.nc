; cycle_without_r.nc:3: drilling cycle without its Z or R word; give both
G0 X0 Y0 Z5 F100
G81 X1 Z-3
