#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the diagrams of the documentation with matplotlib: figures.py [NAME ...]

NAME is a figure (algorithm-collapse), all of them by default. The files are the same in every run with the same matplotlib.
"""

import pathlib
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.patches import Circle, Ellipse, FancyBboxPatch, Polygon  # noqa: E402

IMAGES = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "images"
INPUT, RESULT, GRAY, LIGHT, GOOD = "#2f6fab", "#c8552d", "#777777", "#dfe7ef", "#3c8d5a"
plt.rcParams.update({"svg.hashsalt": "vtkBoneDecimate", "font.size": 9, "font.family": "DejaVu Sans"})


def axes(width, height, panels=1):
    """Empty axes of equal scale, as a list; inches."""
    figure, found = plt.subplots(1, panels, figsize=(width, height), squeeze=False)
    for one in found[0]:
        one.set_aspect("equal")
        one.axis("off")
    figure.tight_layout(pad=0.4)
    return list(found[0])


def fill(at, corners, color=LIGHT, edge=GRAY, alpha=1.0, width=1.0):
    at.add_patch(Polygon(np.array(corners, float), closed=True, facecolor=color, edgecolor=edge, alpha=alpha, linewidth=width))


def line(at, points, color=GRAY, width=1.5, style="-"):
    points = np.array(points, float)
    at.plot(points[:, 0], points[:, 1], color=color, linewidth=width, linestyle=style, solid_capstyle="round")


def dots(at, points, color="black", size=18, face=None):
    points = np.array(points, float)
    at.scatter(points[:, 0], points[:, 1], s=size, color=face or color, edgecolors=color, zorder=3)


def arrow(at, start, end, color="black", width=1.2, style="-|>"):
    at.annotate("", xy=end, xytext=start, arrowprops={"arrowstyle": style, "color": color, "linewidth": width, "shrinkA": 0, "shrinkB": 0})


def text(at, where, words, color="black", size=9, **more):
    at.text(*where, words, color=color, fontsize=size, **{"ha": "center", "va": "center", **more})


def boxes(at, names, colors, top=0.0, step=2.6):
    """Boxes in a row, joined by arrows."""
    for i, (name, color) in enumerate(zip(names, colors)):
        at.add_patch(FancyBboxPatch((i * step, top - 0.4), 1.9, 0.8, boxstyle="round,pad=0.08", facecolor=color, edgecolor=GRAY))
        text(at, (i * step + 0.95, top), name, size=8)
        if i > 0:
            arrow(at, (i * step - 0.58, top), (i * step - 0.12, top))


def half_edge():
    (at,) = axes(4.4, 2.6)
    v, w, a, b = np.array([(0, 0), (3, 0), (1.6, 1.9), (1.4, -1.9)], float)
    for corners in ((v, w, a), (w, v, b)):
        fill(at, corners)
        middle = sum(corners) / 3
        for start, end in zip(corners, (*corners[1:], corners[0])):
            inner = [middle + 0.74 * (p - middle) for p in (start, end)]
            is_pair = {tuple(start), tuple(end)} == {tuple(v), tuple(w)}
            arrow(at, *inner, color=RESULT if is_pair else INPUT, width=1.6)
    dots(at, (v, w, a, b))
    for where, words in (((-0.25, 0), "v"), ((3.25, 0), "w"), ((1.6, 2.15), "a"), ((1.4, -2.15), "b")):
        text(at, where, words, style="italic")
    text(at, (1.5, 0.34), "h", RESULT, style="italic")
    text(at, (1.5, -0.36), "opposite(h)", RESULT)
    text(at, (2.45, 1.05), "next(h)", INPUT, ha="left")
    text(at, (0.5, 1.05), "previous(h)", INPUT, ha="right")
    at.set_ylim(-2.4, 2.4)


RING = np.array([(-1.7, 0.1), (-0.9, 1.3), (0.6, 1.45), (1.9, 0.9), (2.3, -0.5), (1.3, -1.4), (-0.2, -1.5), (-1.3, -0.9)])


def collapse():
    left, right = axes(6.0, 2.5, 2)
    v, w = np.array([-0.2, 0.0]), np.array([0.9, 0.05])
    for at, near in ((left, (v, w)), (right, (np.array([0.4, 0.15]),) * 2)):
        for i, corner in enumerate(RING):
            after = RING[(i + 1) % len(RING)]
            own = near[0] if i in (0, 1, 6, 7) or at is right else near[1]
            fill(at, (corner, after, own))
        at.set_xlim(-2.1, 2.7)
        at.set_ylim(-1.8, 1.75)
    for i in (2, 6):
        fill(left, (RING[i], v, w), "#f3c9b8")
        line(left, (RING[i], v))
        line(left, (RING[i], w))
    line(left, (v, w), RESULT, 2.5)
    dots(left, (v, w, *RING))
    dots(right, RING)
    dots(right, [(0.4, 0.15)], RESULT, 30)
    text(left, (-0.45, 0.12), "v", style="italic")
    text(left, (1.12, 0.12), "w", style="italic")
    text(right, (0.62, 0.36), "x", RESULT, style="italic")


def quadric_of(lines):
    """Sum of squared distances to lines through two points: the matrix, and the position of the minimum."""
    matrix, right = np.zeros((2, 2)), np.zeros(2)
    for p, q in lines:
        normal = np.array([q[1] - p[1], p[0] - q[0]]) / np.hypot(*(q - p))
        matrix += np.outer(normal, normal)
        right += normal * (normal @ p)
    return matrix, np.linalg.solve(matrix, right)


def quadric():
    (at,) = axes(4.6, 2.4)
    points = np.array([(-3, -1.1), (-1.0, 0.45), (0.9, 0.6), (3, -0.9)])
    lines = list(zip(points[:-1], points[1:]))
    matrix, x = quadric_of(lines)
    values, vectors = np.linalg.eigh(matrix)
    for level in (0.15, 0.35, 0.6):
        size = 2 * level / np.sqrt(values)
        angle = np.degrees(np.arctan2(vectors[1, 0], vectors[0, 0]))
        at.add_patch(Ellipse(x, *size, angle=angle, facecolor="none", edgecolor=RESULT, alpha=0.6))
    for p, q in lines:
        d = (q - p) / np.hypot(*(q - p))
        line(at, (p - 0.8 * d, q + 0.8 * d), GRAY, 0.8, "--")
    line(at, points, INPUT, 2)
    line(at, (points[0], x, points[3]), RESULT, 2)
    dots(at, points, INPUT)
    dots(at, [x], RESULT, 30)
    text(at, points[1] + (-0.3, 0.25), "v", style="italic")
    text(at, points[2] + (0.3, 0.25), "w", style="italic")
    text(at, x + (0.0, 0.3), "x", RESULT, style="italic")


def deviation():
    flat, sharp = axes(5.6, 1.9, 2)
    for at, rise, words in ((flat, 0.25, "small deviation: collapsed early"), (sharp, 1.3, "large deviation: collapsed late")):
        points = np.array([(-2, -rise / 2), (0, rise / 2), (2, -rise / 2)])
        line(at, points, INPUT, 2.2)
        dots(at, points, INPUT)
        for p, q in zip(points[:-1], points[1:]):
            middle, d = (p + q) / 2, (q - p) / np.hypot(*(q - p))
            arrow(at, middle, middle + 1.1 * np.array([-d[1], d[0]]))
        text(at, (0, -1.15), words)
        at.set_xlim(-2.4, 2.4)
        at.set_ylim(-1.4, 1.9)


def two_sided():
    left, right = axes(6.2, 2.1, 2)
    spike = [(-2.5, 0), (-0.4, 0), (0, 1.5), (0.4, 0), (2.5, 0)]
    for at, first, second, words in ((left, spike, [(-2.5, 0), (2.5, 0)], "the result lost a spike"),
                                     (right, [(-2.5, 0), (2.5, 0)], spike, "the result grew a spike")):
        line(at, first, INPUT, 2.2)
        line(at, np.array(second) - (0, 0.06), RESULT, 2.2)
        arrow(at, (0, 1.42), (0, 0.02), "black", 1.1, "<|-|>")
        text(at, (0, -0.45), words)
        at.set_xlim(-2.9, 2.9)
        at.set_ylim(-0.7, 1.8)
    text(left, (1.6, 1.0), "input to result: far\nresult to input: near", size=8)
    text(right, (1.6, 1.0), "input to result: near\nresult to input: far", size=8)


def cover():
    left, right = axes(6.0, 2.3, 2)
    triangle = np.array([(0, 0), (4, 0.3), (1.6, 2.8)])
    faces = ([(-1.2, -0.8), (5.4, -0.5), (1.7, 4.0)],)
    fill(left, faces[0], "#f6dcd1", RESULT)
    fill(left, triangle, LIGHT, INPUT, 0.85, 1.6)
    dots(left, triangle, INPUT)
    text(left, (1.9, -1.1), "all corners near one face: proved", size=8)
    fill(right, [(-1.2, -0.8), (2.2, -0.8), (1.2, 3.6)], "#f6dcd1", RESULT)
    fill(right, [(2.2, -0.8), (5.4, -0.5), (1.2, 3.6)], "#fbeee7", RESULT)
    middles = [(triangle[i] + triangle[(i + 1) % 3]) / 2 for i in range(3)]
    fill(right, triangle, LIGHT, INPUT, 0.85, 1.6)
    line(right, (*middles, middles[0]), INPUT, 1)
    dots(right, (*triangle, *middles), INPUT)
    text(right, (1.9, -1.1), "cut into pieces: each near one face", size=8)
    for at in (left, right):
        at.set_xlim(-1.4, 5.6)
        at.set_ylim(-1.4, 4.1)


def parity():
    (at,) = axes(5.2, 2.2)
    curve = np.array([(-3, 0.5), (-1.4, 0.75), (0.7, 1.05), (-0.5, 0.55), (1.3, 0.3), (3, 0.6)])
    at.fill_between((-3, 3), -0.0, 1.35, color=LIGHT)
    line(at, [(-3, 0), (3, 0)], RESULT, 2.5)
    line(at, curve, INPUT, 2)
    for x, count in ((-2.0, 1), (0.1, 3), (2.1, 1)):
        line(at, [(x, -0.15), (x, 1.4)], GRAY, 0.9, ":")
        text(at, (x, -0.4), str(count))
    text(at, (0, -0.8), "number of layers of the input over the face: odd, so never 0", size=8)
    text(at, (3.15, 0.0), "face", RESULT, ha="left")
    text(at, (3.15, 0.6), "input", INPUT, ha="left")
    text(at, (3.15, 1.3), "e", GRAY, ha="left", style="italic")
    at.set_xlim(-3.2, 4.1)
    at.set_ylim(-1.0, 1.5)


def draft():
    (at,) = axes(6.6, 1.7)
    boxes(at, ("draft:\ncollapses, sampled", "proof of all\nchanged faces", "undo\nwhat failed", "collapses,\nproved one by one"),
          ("#fbeee7", LIGHT, "#f6dcd1", LIGHT))
    at.annotate("", xy=(3.5, -0.55), xytext=(6.15, -0.55),
                arrowprops={"arrowstyle": "-|>", "color": "black", "connectionstyle": "arc3,rad=-0.25"})
    text(at, (4.85, -1.15), "until nothing fails", size=8)
    at.set_xlim(-0.3, 10.0)
    at.set_ylim(-1.4, 0.7)


def voxels():
    left, right = axes(5.6, 2.4, 2)
    old = np.array([(-0.5, 1.5), (1.0, 1.5), (1.5, 2.0), (2.0, 2.5), (4.5, 2.5)])
    for at, new, words in ((left, [(-0.5, 1.7), (1.0, 1.3), (2.0, 2.7), (4.5, 2.3)], "accepted"),
                           (right, [(-0.5, 1.5), (4.5, 2.5)], "rejected")):
        for x in range(5):
            for y in range(5):
                is_inside = y <= (1 if x < 2 else 2)
                dots(at, [(x, y)], GRAY, 16, "black" if is_inside else "white")
        new = np.array(new)
        line(at, old, INPUT, 2)
        line(at, new, RESULT, 2, "--")
        text(at, (2, -0.75), words)
        at.set_xlim(-0.7, 4.7)
        at.set_ylim(-1.0, 4.3)
    right.add_patch(Circle((2, 2), 0.3, facecolor="none", edgecolor=RESULT, linewidth=2))


def smoothing():
    (at,) = axes(5.2, 2.5)
    heights = [0, 0, 1, 1, 1, 2, 2, 2, 2]
    points = []
    for x, height in enumerate(heights):
        if x > 0 and height != heights[x - 1]:
            points.append((x - 0.5, height))
        points.append((x, height + 0.5))
    points = np.array(points, float)
    smooth = points.copy()
    for _ in range(200):
        smooth[1:-1] = (smooth[:-2] + smooth[2:]) / 2
        for i, (p, middle) in enumerate(zip(smooth, points)):
            size = np.abs(p - middle).sum() / 0.42
            smooth[i] = middle + (p - middle) / max(size, 1.0)
    for middle in points:
        fill(at, middle + 0.5 * np.array([(1, 0), (0, 1), (-1, 0), (0, -1)]), LIGHT, GRAY, 0.7, 0.6)
    for x, height in enumerate(heights):
        for y in range(4):
            dots(at, [(x, y)], GRAY, 14, "black" if y <= height else "white")
    line(at, points, INPUT, 1.5)
    line(at, smooth, RESULT, 2.2)
    at.set_xlim(-0.7, 8.7)
    at.set_ylim(-0.4, 3.4)


def samples():
    (at,) = axes(5.0, 1.9)
    curve = np.array([(0, 0), (1.55, 0.12), (2.05, 1.0), (2.4, 0.1), (5, 0)])
    line(at, [(0, 0), (5, 0)], RESULT, 2.2)
    line(at, curve, INPUT, 2.2)
    spots = np.array([(x, np.interp(x, curve[:, 0], curve[:, 1])) for x in (0.4, 1.1, 1.75, 2.45, 3.2, 4.0, 4.7)])
    for spot in spots:
        line(at, (spot, (spot[0], 0)), GRAY, 0.9)
    dots(at, spots, "black")
    arrow(at, (2.05, 0.02), (2.05, 0.98), RESULT, 1.4, "<|-|>")
    text(at, (3.5, 0.85), "largest distance: between samples", RESULT, 8)
    at.set_ylim(-0.15, 1.2)


def chain():
    (at,) = axes(7.2, 1.3)
    boxes(at, ("bone", "scan", "segmentation\nor threshold", "input\nsurface", "result"), ("#f2f2f2",) * 3 + (LIGHT, "#f6dcd1"))
    arrow(at, (8.75, -0.75), (11.35, -0.75), GOOD, 2.0, "<|-|>")
    text(at, (10.05, -1.02), "guarantee: at most e", GOOD, 8)
    arrow(at, (0.95, -0.75), (8.55, -0.75), GRAY, 1.4, "<|-|>")
    text(at, (4.75, -1.02), "not known to the software", GRAY, 8)
    at.set_xlim(-0.2, 12.6)
    at.set_ylim(-1.2, 0.6)


def pipeline():
    (at,) = axes(6.6, 1.6)
    boxes(at, ("vtkMetaImage-\nReader", "vtkBone-\nSurfaces", "vtkBone-\nDecimate", "vtkXMLPolyData-\nWriter"), (LIGHT,) * 4)
    at.add_patch(FancyBboxPatch((5.2, -2.0), 1.9, 0.8, boxstyle="round,pad=0.08", facecolor="#f6dcd1", edgecolor=GRAY))
    text(at, (6.15, -1.6), "vtkBoneSurface-\nDistance", size=8)
    line(at, [(3.55, -0.48), (3.55, -1.6)], "black", 1.2)
    arrow(at, (3.55, -1.6), (5.08, -1.6))
    line(at, [(8.75, -0.48), (8.75, -1.6)], "black", 1.2)
    arrow(at, (8.75, -1.6), (7.22, -1.6))
    text(at, (8.9, -1.1), "file", size=8, ha="left")
    at.set_xlim(-0.2, 10.0)
    at.set_ylim(-2.2, 0.6)


FIGURES = {"algorithm-half-edge": half_edge, "algorithm-collapse": collapse, "algorithm-quadric": quadric, "algorithm-deviation": deviation,
           "algorithm-two-sided": two_sided, "algorithm-cover": cover, "algorithm-parity": parity, "algorithm-draft": draft,
           "algorithm-voxels": voxels, "algorithm-smoothing": smoothing, "guarantee-samples": samples, "guarantee-chain": chain,
           "tutorial-cpp": pipeline}


def main():
    for name in sys.argv[1:] or FIGURES:
        FIGURES[name]()
        plt.savefig(IMAGES / f"{name}.svg", metadata={"Date": None, "Creator": None}, facecolor="white")
        plt.close()


if __name__ == "__main__":
    main()
