#!/usr/bin/env python3
"""Certified times of programs beside the times that LinuxCNC takes for them.

    benchmarks/linuxcnc_times.py CLEARCUT PROGRAM.ngc[:PART.json]... [--machine A|B|C]

LinuxCNC (Debian's linuxcnc-uspace) runs each program in its simulation, without a screen and in real time; a counter in the
servo thread sums the cycles in which the machine moves. One line for each program: LinuxCNC's seconds, certified seconds without waits,
error in percent; at the end the median and the greatest error. Machines as in machine_times.py: A 5000 mm/min and 500 mm/s2, B the same,
C 10000 mm/min and 2000 mm/s2. A program whose work is not below Z 0 needs its part, which says where the program begins. LinuxCNC refuses to run for root: the
simulation then runs for the user nobody.
"""
import argparse
import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

MACHINES = {"A": (5000, 500), "B": (5000, 500), "C": (10000, 2000)}
LONGEST = 2000  # mm of travel either way
NOBODY = 65534

INI = """[EMC]
VERSION = 1.1
[DISPLAY]
DISPLAY = {folder}/runner.py
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[RS274NGC]
PARAMETER_FILE = {folder}/parameters.var
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 1.0
SERVO_PERIOD = 1000000
[HAL]
HALFILE = {folder}/simulation.hal
[TRAJ]
COORDINATES = X Y Z
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
MAX_LINEAR_VELOCITY = 1000
MAX_LINEAR_ACCELERATION = 100000
NO_FORCE_HOMING = 1
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.1
TOOL_TABLE = {folder}/tools.tbl
[KINS]
KINEMATICS = trivkins coordinates=XYZ
JOINTS = 3
"""
AXIS = """[AXIS_{axis}]
MIN_LIMIT = -{travel}
MAX_LIMIT = {travel}
MAX_VELOCITY = {speed}
MAX_ACCELERATION = {acceleration}
[JOINT_{joint}]
TYPE = LINEAR
MAX_VELOCITY = {speed}
MAX_ACCELERATION = {acceleration}
FERROR = 100
MIN_FERROR = 100
MIN_LIMIT = -{travel}
MAX_LIMIT = {travel}
HOME_SEQUENCE = 0
"""
HAL = """loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
loadrt integ
loadrt not
loadrt conv_bit_float
addf motion-command-handler servo-thread
addf motion-controller servo-thread
addf not.0 servo-thread
addf conv-bit-float.0 servo-thread
addf integ.0 servo-thread
net x joint.0.motor-pos-cmd => joint.0.motor-pos-fb
net y joint.1.motor-pos-cmd => joint.1.motor-pos-fb
net z joint.2.motor-pos-cmd => joint.2.motor-pos-fb
net rests motion.in-position => not.0.in
net moves not.0.out => conv-bit-float.0.in
net count conv-bit-float.0.out => integ.0.in
setp integ.0.gain 1
net enable iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in
net change iocontrol.0.tool-change => iocontrol.0.tool-changed
net prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared
"""
# Runs as LinuxCNC's display, with Debian's Python: its module belongs to that one.
RUNNER = """#!/usr/bin/python3
import json, subprocess, time
import linuxcnc
command, state, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()
def seconds():
    return float(subprocess.check_output(["halcmd", "getp", "integ.0.out"]))
def rests():
    state.poll()
    return state.interp_state == linuxcnc.INTERP_IDLE and state.inpos
def wait():
    time.sleep(0.3)
    while not rests():
        time.sleep(0.02)
    time.sleep(0.2)
time.sleep(1)
for wanted in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
    command.state(wanted)
    command.wait_complete()
command.mode(linuxcnc.MODE_MANUAL)
command.teleop_enable(0)
command.wait_complete()
command.home(-1)
time.sleep(1)
found = []
for program, begin in json.load(open("{folder}/programs.json")):
    command.mode(linuxcnc.MODE_MDI)
    command.wait_complete()
    for words in ("G21 G90 G49 G54 G0 Z%.4f" % begin[2], "G0 X%.4f Y%.4f" % (begin[0], begin[1])):
        command.mdi(words)
        wait()
    command.mode(linuxcnc.MODE_AUTO)
    command.wait_complete()
    command.program_open(program)
    before = seconds()
    command.auto(linuxcnc.AUTO_RUN, 0)
    wait()
    said = errors.poll()
    found.append([seconds() - before, said[1] if said else ""])
    json.dump(found, open("{folder}/found.json", "w"))
"""


def begin_of(text):
    """The first X, Y and Z of a program, where its first rapids lead."""
    text = re.sub(r"\([^)]*\)|;.*", "", text)
    begin = []
    for letter in "XYZ":
        found = re.search(letter + r"(-?[0-9.]+)", text)
        begin.append(float(found[1]) if found else 0.0)
    return begin


def measured(programs, machine):
    """For each program LinuxCNC's seconds and its message, "" if it has none."""
    speed, acceleration = MACHINES[machine]
    with tempfile.TemporaryDirectory() as folder:
        copies = []
        for number, program in enumerate(programs):
            text = open(program).read()
            copy = os.path.join(folder, f"{number}.ngc")
            open(copy, "w").write(text)
            copies.append((copy, begin_of(text)))
        json.dump(copies, open(os.path.join(folder, "programs.json"), "w"))
        axes = "".join(AXIS.format(axis=axis, joint=joint, travel=LONGEST, speed=speed / 60, acceleration=acceleration)
                       for joint, axis in enumerate("XYZ"))
        files = {"simulation.ini": INI.format(folder=folder) + axes, "simulation.hal": HAL,
                 "runner.py": RUNNER.replace("{folder}", folder),
                 "tools.tbl": "".join(f"T{n} P{n} D6 Z0\n" for n in range(1, 51))}
        for name, text in files.items():
            open(os.path.join(folder, name), "w").write(text)
        os.chmod(os.path.join(folder, "runner.py"), 0o755)
        words = ["script", "-qc", f"linuxcnc {folder}/simulation.ini", "/dev/null"]
        if os.geteuid() == 0:
            for name in ["."] + os.listdir(folder):
                os.chown(os.path.join(folder, name), NOBODY, NOBODY)
            words = ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"] + words
        ran = subprocess.run(words, cwd=folder, env=dict(os.environ, HOME=folder), stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, text=True)
        found = os.path.join(folder, "found.json")
        if not os.path.exists(found):
            sys.exit("LinuxCNC did not run:\n" + ran.stdout)
        return json.load(open(found))


def certified(command, program, part, machine):
    """Seconds of motion by the certificate of the program, alone or with its part."""
    speed, acceleration = MACHINES[machine]
    with tempfile.TemporaryDirectory() as folder:
        certificate = os.path.join(folder, "c.json")
        words = [command, "verify", program, "--rapid", str(speed), "--acceleration", str(acceleration), "--tool",
                 "endmill:6", "--json", certificate, "--quiet"]
        words += ["--part", part] if part else ["--stock", "1000,1000,50"]
        if part and '"depth"' not in open(part).read():
            words += ["--depth", "3"]
        subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        found = json.load(open(certificate))
    return found["time_s"] - found.get("waits_s", 0)


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("command")
    ask.add_argument("programs", nargs="+")
    ask.add_argument("--machine", choices=MACHINES, default="B")
    given = ask.parse_args()
    if not shutil.which("linuxcnc"):
        sys.exit("linuxcnc is not installed (Debian: linuxcnc-uspace)")
    errors = []
    named = [name.partition(":") for name in given.programs]
    for (program, _, part), (seconds, said) in zip(named, measured([name[0] for name in named], given.machine)):
        if said:
            print(f"{program}: LinuxCNC says {said}")
            continue
        expected = certified(given.command, program, part, given.machine)
        errors.append(100 * (expected / seconds - 1))
        print(f"{os.path.basename(program):40} {seconds:9.3f} {expected:9.3f} {errors[-1]:+6.2f} %", flush=True)
    if errors:
        sizes = [abs(error) for error in errors]
        print(f"error: median {statistics.median(sizes):.2f} %, most {max(sizes):.2f} %")


if __name__ == "__main__":
    main()
