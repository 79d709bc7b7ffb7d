"""Where the project is; and the modules of the comparison with Cycles, which measure images, too."""
import os
import sys

PROJECT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(1, os.path.join(PROJECT, "scripts", "cycles"))
