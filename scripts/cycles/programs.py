"""Runs the Renderer and Cycles on what write_scene.py wrote, one thread each, and measures their processor time."""
import os
import subprocess

from geometry import beside
from images import exists


class Failed(Exception):
    pass


def run(command, log):
    """Seconds that the command and its children computed in user mode."""
    with open(log, "wb") as file:
        process = subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        try:
            _, status, usage = os.wait4(process.pid, 0)
        except BaseException:
            process.kill()
            raise
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise Failed("%s failed (%d); its report is %s" % (command[0], process.returncode, log))
    return usage.ru_utime


class Ours:
    def __init__(self, program, name="ours", options=()):
        self.program, self.name, self.options, status = program, name, list(options), os.stat(program)
        self.version = "%d-%d" % (status.st_size, status.st_mtime)

    def render(self, scene, output, size, samples, seed=0, threads=1):
        return run([self.program, scene + ".scn", "-o", output, "-w", str(size[0]), "-h", str(size[1]),
                    "--samples=%d" % samples, "--setting", "path.seed=%d" % seed, "--threads=%d" % threads,
                    "--progress=none"] + self.options, output + ".log")


class Theirs:
    name = "theirs"

    def __init__(self, program, own_spheres=False):
        self.program = program
        self.version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split("\n")[0]
        self.options = ["--own-spheres"] if own_spheres else []

    def render(self, scene, output, size, samples, seed=0, threads=1):
        if os.path.exists(output):
            os.remove(output)
        seconds = run([self.program, "--background", "--factory-startup", "-noaudio", "--threads", str(threads),
                       "--python-exit-code", "1", "--python", beside("render_cycles.py"), "--", scene, output,
                       str(size[0]), str(size[1]), str(samples), str(seed)] + self.options, output + ".log")
        if not exists(output):
            raise Failed("Blender wrote no %s; its report is %s.log" % (output, output))
        return seconds


def cached(program, scene, checksum, label, size, samples, seed=0):
    """Renders unless the image of this scene, size and program is there. Gives its path and the seconds it took."""
    output = "%s-%s-%s.pfm" % (scene, program.name, label)
    key = "%s %s %dx%d %d %d" % (checksum, program.version, *size, samples, seed)
    if exists(output) and exists(output + ".key"):
        with open(output + ".key", encoding="ascii") as file:
            stored, seconds = file.read().split("\n")[:2]
        if stored == key:
            return output, float(seconds)
    seconds = program.render(scene, output + ".part.pfm", size, samples, seed)
    os.replace(output + ".part.pfm", output)
    with open(output + ".key", "w", encoding="ascii") as file:
        file.write("%s\n%.3f\n" % (key, seconds))
    return output, seconds
