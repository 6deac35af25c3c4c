; parameter.nc:2: parameters and expressions are not read; post the program with plain numbers
#100 = 5
G0 X#100
