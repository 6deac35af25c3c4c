; vacant.nc:5: #500 keeps a value in the control that nothing states; set it in the program
%
O0001
G0 X0. Y0.
IF [#500 GT 3] GOTO 10
N10 M30
%
