; alarm.nc:5: the program stops here with an alarm of its own (#3000 = 1); what it asks for does not hold
%
O0001
#1 = 12.
IF [#1 GT 10.] THEN #3000 = 1 (TOO DEEP)
M30
%
