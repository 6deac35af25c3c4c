C X+1 Y+1 DR+
