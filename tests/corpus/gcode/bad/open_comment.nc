; open_comment.nc:2: comment without its closing ')'; close it
G0 X1 (this never ends
