; expression.nc:2: parameters and expressions are not read; post the program with plain numbers
G0 X[1 + 2]
