#!/usr/bin/env python3
"""Graphs for the cheapest join of their odd vertices, and PyMatching's time for it: a peer of `make bench`.

`make FAMILY EDGES FILE` writes a graph of about so many edges, one `from to nanometres` a line. `join FILE` reads one and
prints one JSON line: the weight of the cheapest join and the median time. Only the matching is timed, with the graph in
PyMatching's own form.

    python benches/peers/joins.py make truss 10000 truss.txt
    python benches/peers/joins.py join truss.txt --runs 5
"""

import argparse
import json
import statistics
import time

import numpy
import pymatching
import scipy.spatial

# Nanometres of a unit: the edges of most families are about a unit long.
UNIT = 1_000_000
# PyMatching computes with whole weights up to this; longer ones are rounded.
WHOLE = 2**24 - 2


def delaunay_sphere(edges, random):
    """The triangulation of random points on a sphere."""
    points = random.normal(size=(edges // 3, 3))
    points /= numpy.linalg.norm(points, axis=1)[:, None]
    return points * numpy.sqrt(len(points)), edges_of(scipy.spatial.ConvexHull(points).simplices)


def graded(edges, random):
    """A plane mesh that is much finer at one side than at the other, as a decimated one is."""
    points = random.random((edges // 3, 2))
    points[:, 0] = points[:, 0] ** 3
    return points * numpy.sqrt(len(points)), edges_of(scipy.spatial.Delaunay(points).simplices)


def geometric(edges, random):
    """Random points of a square, each joined with those near it, eight on average."""
    points = random.random((edges // 4, 2)) * numpy.sqrt(edges // 4)
    return points, scipy.spatial.cKDTree(points).query_pairs(numpy.sqrt(8 / numpy.pi), output_type="ndarray")


def icosphere(edges, _):
    """An icosahedron divided: twelve vertices have five edges, all others six."""
    golden = (1 + 5**0.5) / 2
    corners = [(a, b * golden, 0) for a in (-1, 1) for b in (-1, 1)]
    points = numpy.array([numpy.roll(corner, turn) for turn in range(3) for corner in corners], float)
    points /= numpy.linalg.norm(points, axis=1)[:, None]
    faces = scipy.spatial.ConvexHull(points).simplices
    while len(faces) * 6 <= edges:
        pairs = edges_of(faces)
        middle = points[pairs[:, 0]] + points[pairs[:, 1]]
        number = {tuple(pair): len(points) + k for k, pair in enumerate(pairs.tolist())}
        points = numpy.vstack([points, middle / numpy.linalg.norm(middle, axis=1)[:, None]])
        split = []
        for a, b, c in faces.tolist():
            ab, bc, ca = (number[tuple(sorted(pair))] for pair in ((a, b), (b, c), (c, a)))
            split += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = numpy.array(split)
    return points * numpy.sqrt(len(points)), edges_of(faces)


def isogrid(edges, _):
    """A plate of equal triangles."""
    side = max(2, int((edges / 3) ** 0.5))
    row, column = (grid.ravel() for grid in numpy.mgrid[:side, :side])
    points = numpy.stack([column + row / 2, row * 3**0.5 / 2], axis=1)
    number = lambda r, c: r * side + c
    pairs = [
        (number(row[at], column[at]), number(row[at] + down, column[at] + right))
        for down, right in ((0, 1), (1, 0), (1, -1))
        for at in [(row + down < side) & (0 <= column + right) & (column + right < side)]
    ]
    return points, numpy.vstack([numpy.stack(pair, axis=1) for pair in pairs])


def truss(edges, _):
    """Two such plates and the struts between them, all as long: most vertices have nine edges."""
    top, pairs = isogrid(edges * 3 // 9, None)
    count, side = len(top), int(len(top) ** 0.5)
    bottom = top + [0.5, 3**0.5 / 6]
    points = numpy.vstack([numpy.c_[top, numpy.zeros(count)], numpy.c_[bottom, numpy.full(count, (2 / 3) ** 0.5)]])
    row, column = (grid.ravel() for grid in numpy.mgrid[:side, :side])
    struts = [
        numpy.stack([(row * side + column + down * side + right)[at], (row * side + column + count)[at]], axis=1)
        for down, right in ((0, 0), (0, 1), (1, 0))
        for at in [(row + down < side) & (column + right < side)]
    ]
    return points, numpy.vstack([pairs, pairs + count, *struts])


FAMILIES = {
    "delaunay-sphere": delaunay_sphere,
    "graded-mesh": graded,
    "geometric": geometric,
    "icosphere": icosphere,
    "isogrid": isogrid,
    "truss": truss,
}


def edges_of(faces):
    """The edges of triangles, each once."""
    pairs = numpy.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return numpy.unique(numpy.sort(pairs, axis=1), axis=0)


def write(family, edges, file):
    """Equal lengths are equal to the nanometre."""
    points, pairs = FAMILIES[family](edges, numpy.random.default_rng(20260101))
    lengths = numpy.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
    numpy.savetxt(file, numpy.c_[pairs, numpy.rint(lengths * UNIT)], fmt="%d")


def join(file, runs):
    table = numpy.loadtxt(file, dtype=numpy.int64, ndmin=2)
    ends, weights = table[:, :2], table[:, 2]
    odd = (numpy.bincount(ends.ravel()) % 2).astype(numpy.uint8)
    # Whole weights, halved until they fit: without that they are taken as they are.
    scale = 1
    while weights.max() // scale > WHOLE:
        scale *= 2
    matching = pymatching.Matching()
    for edge, ((a, b), weight) in enumerate(zip(ends.tolist(), (weights // scale).tolist())):
        if a != b:
            matching.add_edge(a, b, weight=weight, fault_ids=edge, merge_strategy="smallest-weight")
    matching.decode(odd)
    times_ms = []
    for _ in range(runs):
        start = time.perf_counter()
        chosen = matching.decode(odd)
        times_ms.append((time.perf_counter() - start) * 1000)
    print(json.dumps({
        "peer": "pymatching",
        "weight_nm": int(weights[numpy.flatnonzero(chosen)].sum()),
        "is_exact": scale == 1,
        "median_ms": round(statistics.median(times_ms), 3),
    }))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    tasks = parser.add_subparsers(dest="task", required=True)
    making = tasks.add_parser("make", help="write a graph")
    making.add_argument("family", choices=FAMILIES)
    making.add_argument("edges", type=int)
    making.add_argument("file")
    joining = tasks.add_parser("join", help="time the peer on one")
    joining.add_argument("file")
    joining.add_argument("--runs", type=int, default=3)
    given = parser.parse_args()
    if given.task == "make":
        write(given.family, given.edges, given.file)
    else:
        join(given.file, given.runs)


if __name__ == "__main__":
    main()
