#!/usr/bin/env python3
"""The route of a wireframe by NetworkX: the peer that `make bench` compares with.

Reads the edges of an OBJ file (its `l` lines when it has any, else the edges of its faces) and finds the shortest
single wire along them: odd vertices, metric closure, minimum weight perfect matching with two odd vertices left free
(the wire may be open), doubled edges, Euler path. The matching is exact: weights are whole nanometres.
Prints one JSON line. Only the graph work is timed, not the start of Python and not reading the file.

    python benches/peers/euler_networkx.py examples/bunny.obj --runs 5
"""

import argparse
import json
import math
import statistics
import sys
import time

import networkx as nx

WELD_MM = 1e-3
NM_PER_MM = 1_000_000
FREE_ENDS = ("free end", 0), ("free end", 1)


def read_obj(path):
    """The wireframe of an OBJ file in mm: vertices closer than WELD_MM are one, an edge is counted once."""
    points, lines, face_edges = [], [], []
    with open(path, encoding="utf-8") as file:
        for number, text in enumerate(file, start=1):
            words = text.split()
            if not words or words[0] not in ("v", "l", "f"):
                continue
            if words[0] == "v":
                points.append(tuple(float(word) for word in words[1:4]))
                continue
            ring = [obj_index(word, len(points), path, number) for word in words[1:]]
            if words[0] == "l":
                lines += zip(ring, ring[1:])
            else:
                face_edges += zip(ring, ring[1:] + ring[:1])
    names = weld(points)
    graph = nx.Graph()
    for a, b in lines or face_edges:
        if names[a] != names[b]:
            graph.add_edge(names[a], names[b], mm=math.dist(points[names[a]], points[names[b]]))
    for _, _, edge in graph.edges(data=True):
        edge["nm"] = round(edge["mm"] * NM_PER_MM)
    return graph


def obj_index(word, count, path, number):
    """Index from 0 of a vertex reference such as `3`, `3/1/2` or `-1`."""
    index = int(word.split("/")[0])
    index = index - 1 if index > 0 else count + index
    if not 0 <= index < count:
        sys.exit(f"{path}:{number}: vertex {word} does not exist; {count} vertices are known here")
    return index


def weld(points):
    """For every point the index of the first point within WELD_MM."""
    names = []
    for index, point in enumerate(points):
        names.append(next((i for i in range(index) if math.dist(points[i], point) <= WELD_MM), index))
    return names


def edges_to_double(graph):
    """Edges to travel twice so that a connected graph has an open Euler path, at the least total length."""
    odd = [vertex for vertex, degree in graph.degree() if degree % 2]
    if len(odd) <= 2:
        return []
    metric = nx.Graph()
    ways = {}
    for vertex in odd:
        distance, way = nx.single_source_dijkstra(graph, vertex, weight="nm")
        ways[vertex] = way
        metric.add_weighted_edges_from((vertex, other, distance[other]) for other in odd if other != vertex)
    # Each free end takes one odd vertex out of the matching for nothing: these two become the ends of the wire.
    for end in FREE_ENDS:
        metric.add_weighted_edges_from((end, vertex, 0) for vertex in odd)
    doubled = []
    for a, b in nx.min_weight_matching(metric):
        if a not in FREE_ENDS and b not in FREE_ENDS:
            way = ways[a][b]
            doubled += zip(way, way[1:])
    return doubled


def route(graph):
    """One walk for each component: (edges travelled in order, edges doubled)."""
    walks = []
    for vertices in nx.connected_components(graph):
        part = graph.subgraph(vertices)
        doubled = edges_to_double(part)
        wire = nx.MultiGraph(part)
        wire.add_edges_from(doubled)
        walks.append((list(nx.eulerian_path(wire)), doubled))
    return walks


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("files", nargs="+", metavar="FILE.obj")
    arguments.add_argument("--runs", type=int, default=5, help="how often the graph work is timed (default 5)")
    given = arguments.parse_args()
    if given.runs < 1:
        arguments.error("--runs must be at least 1")
    for path in given.files:
        graph = read_obj(path)
        times_ms = []
        for _ in range(given.runs):
            start = time.perf_counter()
            walks = route(graph)
            times_ms.append((time.perf_counter() - start) * 1000)
        print(json.dumps({
            "peer": "networkx",
            "file": path,
            "open_length_mm": round(sum(graph.edges[edge]["mm"] for walk, _ in walks for edge in walk), 4),
            "doubled_mm": round(sum(graph.edges[edge]["mm"] for _, doubled in walks for edge in doubled), 4),
            "feeds": sum(len(walk) for walk, _ in walks),
            "median_ms": round(statistics.median(times_ms), 3),
            "runs": given.runs,
        }))


if __name__ == "__main__":
    main()
