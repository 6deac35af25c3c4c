; Work area:   (0, 0)-(40, 30)
; Offset:      (0, 0)
G21         ; Set units to mm
G90         ; Absolute positioning
G1 Z25.4 F2540      ; Move to clearance level

;
; Operation:    0
; Name:
; Type:         Pocket
; Paths:        1
; Direction:    Climb
; Cut Depth:    2
; Pass Depth:   2
; Plunge rate:  120
; Cut rate:     1000
;

; Path 0
; Rapid to initial position
G1 X10.0000 Y10.0000 F2540
; plunge
G1 Z-2.0000 F120
; cut
G1 X13.0000 Y10.0000 F1000
G1 X13.0000 Y13.0000
G1 X7.0000 Y13.0000
G1 X7.0000 Y7.0000
; Retract
G0 X40
M2
