; expression.nc:2: an expression lacks its ']'; close it
G0 X[1 + 2
