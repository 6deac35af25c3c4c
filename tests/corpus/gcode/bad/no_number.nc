; no_number.nc:2: X word without a number; correct it
G0 X Y5
