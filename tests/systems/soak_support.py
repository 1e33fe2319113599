"""What the soak tests share: starting programs, ending them by Ctrl-C, reading captures with the tool."""

import json
import os
import pathlib
import signal
import subprocess
import time

PROGRAM = os.environ["PROGRAM"]
TRAMA = os.environ.get("TRAMA")


def run(*arguments, patience=400):
    """The program's exit status and what it printed."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=patience)
    return done.returncode, done.stdout + done.stderr


def interrupted(*arguments, after=1.0):
    """As `run`, ended by Ctrl-C: the signal goes to all its processes, as a terminal sends it. Also returns the number
    of its processes that are left."""
    child = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             text=True, start_new_session=True)
    try:
        child.wait(after)
    except subprocess.TimeoutExpired:
        os.killpg(child.pid, signal.SIGINT)
    output, _ = child.communicate(timeout=60)
    left = 0
    for entry in pathlib.Path("/proc").iterdir():
        try:
            left += entry.name.isdigit() and os.getpgid(int(entry.name)) == child.pid
        except ProcessLookupError:
            pass
    return child.returncode, output, left


def children(process):
    """The process numbers of its children, the oldest first."""
    return [int(child) for child in pathlib.Path(f"/proc/{process}/task/{process}/children").read_text().split()]


def bereft_of(member):
    """The program's status and what it complains of when one of its children is killed after a second."""
    program = subprocess.Popen([PROGRAM], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    time.sleep(1)
    os.kill(children(program.pid)[member], signal.SIGKILL)
    said = program.communicate(timeout=60)[1]
    return program.returncode, said


def wait_for_orphans(patience=60):
    """Kills the program after a second; TimeoutExpired if a child of it outlives it."""
    program = subprocess.Popen([PROGRAM], stdout=subprocess.PIPE)
    time.sleep(1)
    program.kill()
    program.communicate(timeout=patience)  # the children hold the pipe's other end


def decoded(protocol, path):
    """Messages and errors that the tool finds in a capture."""
    done = subprocess.run([TRAMA, "decode", protocol, str(path)], capture_output=True, text=True, timeout=120)
    assert done.returncode in (0, 1), done.stderr
    events = [json.loads(line) for line in done.stdout.splitlines()]
    return [e for e in events if "message" in e], [e for e in events if "error" in e]


def encoded(protocol, *messages):
    """The octets of messages."""
    lines = "".join(json.dumps(m) + "\n" for m in messages)
    done = subprocess.run([TRAMA, "encode", protocol], input=lines.encode(), capture_output=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return done.stdout
