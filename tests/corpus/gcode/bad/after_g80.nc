; after_g80.nc:4: axis words after G80 without a motion word; add G0 or G1
G0 X0 Y0 Z5 F100
G80
X5
