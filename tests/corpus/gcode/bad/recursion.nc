; recursion.nc:7: over 10 calls within each other, at which the control stops; a subprogram may call itself without end (O100 called in recursion.nc:7, O100 called in recursion.nc:7, O100 called in recursion.nc:7)
%
O0001
M98 P100
M30
O100
M98 P100
M99
%
