#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Stands the robot in rooms of real buildings and puts pictures of what `enfilade room` finds there side by side.

Usage: draw.py ENFILADE LOGS OUT.svg [spots.txt [--only LOG]] where LOGS holds LOG_raw_and_corrected.clf for each log of
the list. Green: door, light green: perhaps a door, grey: not seen, red: wall. Writes OUT.json with the rooms too.
"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TILE, COLUMNS, TITLE = 240, 7, 18


def spots(file):
    for line in file.read_text().splitlines():
        if line and not line.startswith("#"):
            log, x, y, name = line.split(maxsplit=3)
            yield log, float(x), float(y), name


def find_room(enfilade, log, x, y, folder):
    svg, room = folder / "room.svg", folder / "room.json"
    subprocess.run([enfilade, "room", str(log), f"--at={x},{y}", "--svg", str(svg), "--json", str(room)],
                   stdout=subprocess.DEVNULL, check=False)
    return svg.read_text(), json.loads(room.read_text())


def tile(svg, title, column, row):
    width, height = (float(re.search(rf'\b{side}="([0-9.]+)"', svg).group(1)) for side in ("width", "height"))
    body = re.search(r"<svg[^>]*>(.*)</svg>", svg, re.S).group(1)
    x, y = column * TILE, row * (TILE + TITLE)
    return (f'<text x="{x + 4}" y="{y + 13}" font-family="sans-serif" font-size="12">{title}</text>'
            f'<svg x="{x}" y="{y + TITLE}" width="{TILE - 4}" height="{TILE - 4}" viewBox="0 0 {width} {height}">{body}</svg>')


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit("usage: draw.py ENFILADE LOGS OUT.svg [SPOTS.txt]")
    enfilade, logs, out = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    places = list(spots(Path(sys.argv[4]) if len(sys.argv) > 4 else Path(__file__).with_name("spots.txt")))
    tiles, rooms = [], []
    with tempfile.TemporaryDirectory() as folder:
        for i, (log, x, y, name) in enumerate(places):
            file = logs / f"{log}_raw_and_corrected.clf"
            if not file.exists():
                sys.exit(f"draw.py: {file} is not there: give the folder of the logs")
            svg, room = find_room(enfilade, file, x, y, Path(folder))
            rooms.append({"log": log, "x": x, "y": y, "place": name, "room": room})
            size = f'{room["width_m"]:.1f} × {room["height_m"]:.1f} m' if room["width_m"] else "none"
            tiles.append(tile(svg, f"{i + 1} {log}, {name}: {size}", i % COLUMNS, i // COLUMNS))
    height = (len(places) + COLUMNS - 1) // COLUMNS * (TILE + TITLE)
    out.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="{COLUMNS * TILE}" height="{height}">'
                   f'<rect width="100%" height="100%" fill="white"/>{"".join(tiles)}</svg>\n')
    out.with_suffix(".json").write_text(json.dumps(rooms, indent=1) + "\n")


if __name__ == "__main__":
    main()
