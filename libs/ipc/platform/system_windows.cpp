#error                                                                                                       \
    "The shared memory between the programs does not work on Windows yet: write the functions of platform/system.h here."
