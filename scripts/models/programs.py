"""Runs programs with a time limit and makes one line of why they failed."""
import os
import re
import signal
import subprocess

SECONDS = 60
NOISE = ("alive", "Traceback", "  ", "Error: script failed", "Info:", "Blender ", "Read prefs")
ERROR = re.compile(r"(\w*(Error|Exception)\b|rtimport:|Renderer:)")


class Failed(Exception):
    pass


def run(command, log, **options):
    """Raises Failed with the last telling line of what it said."""
    with open(log, "wb") as file:
        process = subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                   start_new_session=True, **options)
        try:
            status = process.wait(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            raise Failed("took more than %d s" % SECONDS) from None
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
    if status != 0:
        raise Failed(last_line(log) or "ended with %d" % status)


def last_line(log):
    """The last line that names an error, else the last one."""
    with open(log, encoding="utf-8", errors="replace") as file:
        lines = [line.strip() for line in file if line.strip() and not line.startswith(NOISE)]
    errors = [line for line in lines if ERROR.match(line)]
    return (errors or lines or [""])[-1]
