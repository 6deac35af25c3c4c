; parameter.nc:3: #<depth> is read before anything sets it, at which the control stops; set it before
#100 = 5
G0 X#<depth>
