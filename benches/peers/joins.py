#!/usr/bin/env python3
"""Graphs for the cheapest join of their odd vertices, and what PyMatching and NetworkX find: peers of `make bench`.

`make FAMILY EDGES FILE` writes a graph of about so many edges, one `from to nanometres` a line, and beside it a wireframe with
the same edges, FILE.obj. `join FILE` reads a graph and prints one JSON line: the weight of PyMatching's cheapest join and the
median time. Only the matching is timed, with the graph in PyMatching's own form. `random COUNT` prints so many random graphs, a
JSON line each, with the weights of NetworkX's cheapest joins that leave no odd vertex and two.

    python benches/peers/joins.py make truss 10000 truss.txt
    python benches/peers/joins.py join truss.txt --runs 5
    python benches/peers/joins.py random 200
"""

import argparse
import json
import statistics
import time

import networkx
import numpy
import pymatching
import scipy.spatial

# Nanometres of a unit: the edges of most families are about a unit long. In the wireframes they are so many millimetres.
UNIT = 1_000_000
MM = 40
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


def rings(edges, _):
    """The same cut to a hexagon: the plate of a truss with so many rings of cells that it has about as many edges."""
    count = max(1, round((edges / 27) ** 0.5))
    points, pairs = truss(27 * (2 * count + 3) ** 2, None)
    centre = points[:, :2].mean(axis=0)
    near = [points[:, 2] == height for height in (0, points[:, 2].max())]
    turns = numpy.array([[1, 0], [0.5, 3**0.5 / 2], [-0.5, 3**0.5 / 2]])
    origin = points[near[0]][numpy.linalg.norm(points[near[0]][:, :2] - centre, axis=1).argmin()][:2]
    normals = numpy.array([[0, 1], [3**0.5 / 2, 0.5], [3**0.5 / 2, -0.5]])
    inside = (numpy.abs((points[:, :2] - origin) @ normals.T) <= count * 3**0.5 / 2 + 1e-9).all(axis=1)
    kept = inside[pairs].all(axis=1)
    used = numpy.unique(pairs[kept])
    number = numpy.full(len(points), -1)
    number[used] = numpy.arange(len(used))
    return points[used], number[pairs[kept]]


FAMILIES = {
    "delaunay-sphere": delaunay_sphere,
    "graded-mesh": graded,
    "geometric": geometric,
    "icosphere": icosphere,
    "isogrid": isogrid,
    "truss": truss,
    "rings": rings,
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
    if points.shape[1] == 2:
        points = numpy.c_[points, numpy.zeros(len(points))]
    with open(f"{file}.obj", "w", encoding="utf-8") as wireframe:
        numpy.savetxt(wireframe, points * MM, fmt="v %.12f %.12f %.12f")
        numpy.savetxt(wireframe, pairs + 1, fmt="l %d %d")


def join(file, runs, is_open):
    table = numpy.loadtxt(file, dtype=numpy.int64, ndmin=2)
    ends, weights = table[:, :2], table[:, 2]
    odd = (numpy.bincount(ends.ravel()) % 2).astype(numpy.uint8)
    count, edges, unit = len(odd), len(weights), int(numpy.gcd.reduce(weights))
    weights //= unit
    # Two vertices that an edge longer than any path joins with every odd one: each takes one of them, and these are left.
    if is_open:
        far, at = int(weights.max()) * count, numpy.flatnonzero(odd)
        ends = numpy.vstack([ends, *(numpy.c_[at, numpy.full(len(at), count + end)] for end in (0, 1))])
        weights = numpy.r_[weights, numpy.full(2 * len(at), far)]
        odd = numpy.r_[odd, [1, 1]].astype(numpy.uint8)
    # Whole weights, halved until they fit: without that they are taken as they are.
    scale = 1
    while weights.max() // scale > WHOLE:
        scale *= 2
    matching = pymatching.Matching()
    for edge, ((a, b), weight) in enumerate(zip(ends.tolist(), (weights // scale).tolist())):
        if a != b:
            matching.add_edge(a, b, weight=weight, fault_ids=edge, merge_strategy="smallest-weight")
    times_ms = []
    # The first of several is not timed.
    for run in range(runs + (runs > 1)):
        start = time.perf_counter()
        chosen = matching.decode(odd)
        if run > 0 or runs == 1:
            times_ms.append((time.perf_counter() - start) * 1000)
    print(json.dumps({
        "peer": "pymatching",
        "weight_nm": int(weights[:edges][numpy.flatnonzero(chosen[:edges])].sum()) * unit,
        "is_exact": scale == 1,
        "median_ms": round(statistics.median(times_ms), 3),
    }))


def random_graphs(count):
    """Connected graphs with up to 60 odd vertices, some edges as long as others, some doubled, some of no length."""
    random = numpy.random.default_rng(20260102)
    for _ in range(count):
        vertices = int(random.integers(2, 70))
        tree = [(int(random.integers(0, vertex)), vertex) for vertex in range(1, vertices)]
        more = random.integers(0, vertices, (int(random.integers(0, 2 * vertices)), 2)).tolist()
        edges = [(a, b, int(w)) for (a, b), w in zip(tree + more, random.integers(0, 40, len(tree) + len(more)))]
        graph = networkx.Graph()
        graph.add_nodes_from(range(vertices))
        degrees = numpy.zeros(vertices, int)
        for a, b, weight in edges:
            degrees[a] += 1
            degrees[b] += 1
            if a != b:
                graph.add_edge(a, b, nm=min(weight, graph.edges[a, b]["nm"] if graph.has_edge(a, b) else weight))
        odd = [vertex for vertex in range(vertices) if degrees[vertex] % 2]
        if len(odd) > 60:
            continue
        yield {"vertices": vertices, "edges": edges, "closed": matched(graph, odd, 0), "open": matched(graph, odd, 2)}


def matched(graph, odd, left):
    """The least length of paths that pair the odd vertices, of which so many are left."""
    far = {vertex: networkx.single_source_dijkstra_path_length(graph, vertex, weight="nm") for vertex in odd}
    pairs = networkx.Graph()
    for k, a in enumerate(odd):
        pairs.add_weighted_edges_from((a, b, far[a][b]) for b in odd[:k])
        if len(odd) > 1:
            pairs.add_weighted_edges_from((a, ("left", end), 0) for end in range(left))
    return sum(pairs.edges[pair]["weight"] for pair in networkx.min_weight_matching(pairs))


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
    joining.add_argument("--open", action="store_true", help="leave two odd vertices")
    drawing = tasks.add_parser("random", help="print random graphs with NetworkX's joins")
    drawing.add_argument("count", type=int)
    given = parser.parse_args()
    if given.task == "make":
        write(given.family, given.edges, given.file)
    elif given.task == "join":
        join(given.file, given.runs, given.open)
    else:
        for graph in random_graphs(given.count):
            print(json.dumps(graph))


if __name__ == "__main__":
    main()
