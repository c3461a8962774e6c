#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Draws what build/release/bench/growth --json has measured as an SVG of four plots: growth.py JSON SVG"""
import json
import math
import sys

WIDTH, HEIGHT, LEFT, TOP, GAP = 340, 210, 52, 30, 40
# series: title, whether the axes are logarithmic
PLOTS = {
    "triangles": ("triangles (both axes logarithmic)", True),
    "lights": ("lights with shadows", False),
    "bounces": ("bounces in a room of mirrors", False),
    "pixels": ("pixels", False),
}


def ticks(low, high, logarithmic):
    if logarithmic:
        return [10.0**e for e in range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)]
    step = 10 ** math.floor(math.log10(high / 2))
    step = next(s for s in (step, 2 * step, 5 * step, 10 * step) if high / s <= 6)
    return [step * i for i in range(int(high / step) + 1)]


def label(value):
    if value >= 1e6:
        return f"{value / 1e6:g}M"
    return f"{value / 1e3:g}k" if value >= 1e4 else f"{value:g}"


def plot(title, points, logarithmic, left, top):
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    low_x, low_y = (min(xs), min(ys) / 1.5) if logarithmic else (0, 0)
    high_x, high_y = max(xs), max(ys) * 1.1
    scale = math.log10 if logarithmic else lambda v: v

    def place(value, low, high, length):
        return (scale(value) - scale(low)) / (scale(high) - scale(low)) * length

    def at_x(value):
        return left + place(value, low_x, high_x, WIDTH)

    def at_y(value):
        return top + HEIGHT - place(value, low_y, high_y, HEIGHT)

    out = [f'<text x="{left}" y="{top - 10}" class="title">{title}</text>']
    for value in ticks(low_x, high_x, logarithmic):
        x = at_x(value)
        out.append(f'<path d="M{x:.1f} {top}V{top + HEIGHT}" class="grid"/>')
        out.append(f'<text x="{x:.1f}" y="{top + HEIGHT + 14}" text-anchor="middle">{label(value)}</text>')
    for value in ticks(low_y, high_y, logarithmic):
        y = at_y(value)
        out.append(f'<path d="M{left} {y:.1f}H{left + WIDTH}" class="grid"/>')
        out.append(f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{label(value)}</text>')
    line = " ".join(f"{at_x(x):.1f},{at_y(y):.1f}" for x, y in points)
    out.append(f'<polyline points="{line}" class="line"/>')
    out += [f'<circle cx="{at_x(x):.1f}" cy="{at_y(y):.1f}" r="3.5" class="dot"/>' for x, y in points]
    return out


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        results = json.load(file)["results"]
    out = []
    for number, (name, (title, logarithmic)) in enumerate(PLOTS.items()):
        points = [(float(r["task"]), r["median"]) for r in results if r["scene"] == name]
        if not points:
            sys.exit(f"growth.py: {sys.argv[1]} has no series '{name}'; run bench/growth without --only")
        left = LEFT + number % 2 * (WIDTH + LEFT + 10)
        top = TOP + number // 2 * (HEIGHT + GAP + TOP)
        out += plot("ms a frame, by " + title, points, logarithmic, left, top)
    width, height = 2 * (WIDTH + LEFT + 10) + 10, 2 * (HEIGHT + GAP + TOP)
    style = (
        "text{font:12px sans-serif;fill:#777}.title{font-weight:bold}.grid{stroke:#8884;fill:none}"
        ".line{stroke:#0a7;stroke-width:2;fill:none}.dot{fill:#0a7}"
    )
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}"><style>{style}</style>\n')
        file.write("\n".join(out) + "\n</svg>\n")


main()
