"""A Renderer that stands by for the window, and the frames that it shows: docs/protocol.md has the layout."""
import collections
import glob
import mmap
import os
import struct
import subprocess
import time

import numpy
import programs

SIZES, LATEST, SLOTS, PIXELS = 24, 64, 128, 4096  # offsets in a frame segment
SLOT_BYTES = 64                                   # of a slot there
EXPOSURE = 792                                    # offset of Status::exposure in the control segment
DONE = 1000000                                    # tag of the last frame
TURN = 0.01                                       # seconds between two looks

Shown = collections.namedtuple("Shown", "wall seconds samples exposure codes")


class Preview:
    """A process that renders the scene that it is told, and then what frames() asks for; it ends with the `with`."""

    def __init__(self, command, name, threads):
        self.prefix, self.threads, self.run = "/dev/shm/rts.%d.%s." % (os.getuid(), name), threads, 1
        self.process = subprocess.Popen([*command, "--preview=" + name, "--stand-by", "--run-id=1", "--progress=none",
                                         "--threads=%d" % threads], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()  # which ends it
        self.process.wait()

    def frames(self, scene, camera, seconds):
        """What is shown after the request for a view of the same scene, each as a `Shown`, for so many of its seconds.

        `wall` is by the clock; `seconds` is processor time over the threads, which does not grow while a busy machine
        does something else.
        """
        self._first()
        self.run += 1
        begun, before = time.monotonic(), self._processor()
        self.process.stdin.write(("%d\t%s\t%s\n" % (self.run, scene, camera)).encode())
        self.process.stdin.flush()
        number = 0
        while True:
            wall, used = time.monotonic() - begun, (self._processor() - before) / self.threads
            frame = self._frame(number)
            if frame is not None:
                number, samples, tag, exposure, codes = frame
                yield Shown(wall, used, samples, exposure, codes)
            if used > seconds or (frame is not None and tag == DONE):
                return
            time.sleep(TURN)

    def _first(self):
        """Waits until the scene is loaded and its first frame is there."""
        while self._frame(0) is None:
            time.sleep(TURN)

    def _processor(self):
        if self.process.poll() is not None:
            raise programs.Failed("the preview ended with %d" % self.process.returncode)
        return time.clock_gettime(~self.process.pid << 3 | 2)  # as clock_getcpuclockid() makes it

    def _frame(self, known):
        """The newest whole frame of this run, if it is not `known`."""
        self._processor()
        for path in glob.glob(self.prefix + "f*"):
            try:
                with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as memory:
                    frame = self._read(memory, known)
            except (OSError, ValueError):  # its name was just removed, or its size is not there yet
                continue
            if frame is not None:
                return frame
        return None

    def _read(self, memory, known):
        slot_bytes, slots = struct.unpack_from("<QI", memory, SIZES)
        number, = struct.unpack_from("<Q", memory, LATEST)
        if number in (0, known):
            return None
        at = SLOTS + SLOT_BYTES * (number % slots)
        whole, = struct.unpack_from("<Q", memory, at)
        _, run, width, height, _, samples, _, tag = struct.unpack_from("<QQIIIIqQ", memory, at + 8)
        begin = PIXELS + number % slots * slot_bytes
        pixels = numpy.frombuffer(memory[begin:begin + 4 * width * height], numpy.uint8).copy()
        if whole != 2 * number + 2 or struct.unpack_from("<Q", memory, at)[0] != whole or run != self.run:
            return None
        with open(self.prefix + "ctl", "rb") as control:
            control.seek(EXPOSURE)
            exposure, = struct.unpack("<f", control.read(4))
        return number, samples, tag, exposure, pixels.reshape(height, width, 4)[..., :3]
