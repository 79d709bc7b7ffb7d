#!/usr/bin/env python3
"""Looks for headers of the operating system that are included outside the rooms that may call it. Prints file:line:
what to do; exits with 1 if there are any. Tests are free.

  scripts/check_system_headers.py
"""
import os
import re
import subprocess
import sys

ROOMS = ("libs/rtcore/platform/", "libs/ipc/platform/", "apps/common/process/")
FOLDERS = r"(sys|linux|asm|net|netinet|arpa|mach)/[\w/]+\.h"
FILES = (
    "aio|dirent|dlfcn|fcntl|fnmatch|ftw|glob|grp|ifaddrs|langinfo|libgen|malloc|mqueue|netdb|poll|pthread|pwd|sched|"
    "semaphore|signal|spawn|syslog|termios|ucontext|unistd|utime|wait|windows|wordexp")
INCLUDE = re.compile(r'\s*#\s*include\s*[<"](%s|(%s)\.h|csignal)[>"]' % (FOLDERS, FILES), re.IGNORECASE)


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    names = subprocess.run(["git", "ls-files", "-z", "libs", "apps"], check=True, capture_output=True, text=True).stdout
    found = 0
    for name in names.split("\0"):
        if not name.endswith((".cpp", ".h")) or name.startswith(ROOMS) or not os.path.isfile(name):
            continue
        with open(name, encoding="utf-8") as lines:
            for number, line in enumerate(lines, 1):
                if match := INCLUDE.match(line):
                    print("%s:%d: %s: system calls stand in %s only; call a function of theirs, or add one there"
                          % (name, number, match.group(1), ", ".join(ROOMS)), file=sys.stderr)
                    found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
