#!/usr/bin/env python3
"""Draws docs/images/cube_faces.svg: where the faces of a cube environment lie in each layout, and which way up."""
import os

SIDE = 60
# Name in cube maps, where it is seen, direction, colour.
FACES = [("px", "right", "+x", "#f4c7c3"), ("nx", "left", "-x", "#c9e7cb"), ("py", "up", "+y", "#cfe2f3"),
         ("ny", "down", "-y", "#e0d4c3"), ("pz", "ahead", "-z", "#fff2b3"), ("nz", "behind", "+z", "#ddd3ee")]
# Column and row of each face; those that stand on their heads.
LAYOUTS = [("cross, 4 x 3", 0, 0, [(2, 1), (0, 1), (1, 0), (1, 2), (1, 1), (3, 1)], ()),
           ("cross, 3 x 4", 5, 0, [(2, 1), (0, 1), (1, 0), (1, 2), (1, 1), (1, 3)], (5,)),
           ("strip, 6 x 1 (or 1 x 6, downwards)", 0, 5, [(i, 0) for i in range(6)], ())]


def cell(x, y, face, turned):
    name, where, direction, colour = FACES[face]
    middle = f"{x + SIDE / 2:g} {y + SIDE / 2:g}"
    turn = f' transform="rotate(180 {middle})"' if turned else ""
    lines = "".join(f'<text x="{x + SIDE / 2:g}" y="{y + height:g}">{text}</text>'
                    for height, text in ((18, name), (35, where), (52, direction)))
    return (f'<g{turn}><rect x="{x:g}" y="{y:g}" width="{SIDE}" height="{SIDE}" fill="{colour}" stroke="#555"/>'
            f"{lines}</g>\n")


def main():
    out = ""
    for title, left, top, places, turned in LAYOUTS:
        x0, y0 = 10 + left * SIDE, 30 + top * SIDE
        out += f'<text x="{x0}" y="{y0 - 10}" style="text-anchor:start">{title}</text>\n'
        for face, (column, row) in enumerate(places):
            out += cell(x0 + column * SIDE, y0 + row * SIDE, face, face in turned)
    width, height = 10 + 8 * SIDE + 10, 30 + 6 * SIDE + 10
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "docs", "images", "cube_faces.svg")
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                   'font-family="sans-serif" font-size="13" text-anchor="middle">\n'
                   f'<rect width="{width}" height="{height}" fill="white"/>\n{out}</svg>\n')


if __name__ == "__main__":
    main()
