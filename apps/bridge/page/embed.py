#!/usr/bin/env python3
"""Writes the page's files as tables of bytes: plain, and packed by gzip, each with its entity tag.

  embed.py --from FOLDER NAME... [--from FOLDER NAME...] -o page_files.cpp

The same files always make the same source.
"""
import argparse
import gzip
import hashlib
import os

HEAD = """// Made by apps/bridge/page/embed.py.
#include "bridge/net/page_files.h"

namespace bridge {

namespace {

"""
MIDDLE = """
template <std::size_t kSize>
PageBody body(const unsigned char (&bytes)[kSize], const char* tag) {
    return {{reinterpret_cast<const char*>(bytes), kSize}, tag};
}

} // namespace

std::span<const PageFile> pageFiles() {
    static const PageFile files[] = {
"""
TAIL = """    };
    return files;
}

} // namespace bridge
"""


def table(name, content):
    rows = (content[at:at + 32] for at in range(0, len(content), 32))
    return "constexpr unsigned char %s[] = {\n%s\n};\n" % (name, "\n".join("".join("%d," % byte for byte in row) for row in rows))


def tag(content):
    return '"\\"%s\\""' % hashlib.sha256(content).hexdigest()[:20]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--from", dest="sets", action="append", nargs="+", required=True, metavar="NAME")
    parser.add_argument("-o", dest="output", required=True)
    arguments = parser.parse_args()
    tables, rows = [], []
    for folder, *names in arguments.sets:
        for name in names:
            with open(os.path.join(folder, name), "rb") as file:
                plain = file.read()
            packed = gzip.compress(plain, 9, mtime=0)
            number = len(rows)
            tables += [table("kPlain%d" % number, plain), table("kPacked%d" % number, packed)]
            rows.append('        {"/%s", body(kPlain%d, %s), body(kPacked%d, %s)},\n' % (name, number, tag(plain), number, tag(packed)))
    with open(arguments.output, "w", encoding="ascii") as output:
        output.write(HEAD + "".join(tables) + MIDDLE + "".join(rows) + TAIL)


if __name__ == "__main__":
    main()
