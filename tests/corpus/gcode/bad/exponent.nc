; exponent.nc:2: X word with an exponent; post plain decimals
G0 X1.2e-05 Y5
