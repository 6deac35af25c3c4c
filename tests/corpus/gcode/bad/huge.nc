; huge.nc:2: coordinate beyond any machine; check the number and the units
G0 X12345678 Y0
