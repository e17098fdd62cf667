#!/usr/bin/env python3
"""Wires bent with errors, all at once with NumPy: the peer of `make bench`.

Reads what `scatter` writes: the commands of a program with the bends that they leave, and standard deviations. Prints one JSON line: the
least seconds of several times, and for each vertex the mean distance from the design and the one that 95 % of the wires keep within.

    python benches/peers/scatter.py wire.json
"""

import json
import sys
import time

import numpy


def arc(turn, length, fraction):
    """Where a part of an arc ends, along its chord and aside from it."""
    along = numpy.sinc(turn * fraction / 2 / numpy.pi) * length * fraction
    direction = turn * (1 - fraction) / 2
    return along * numpy.cos(direction), along * numpy.sin(direction)


def bent(wire, random):
    """Distances of all vertices from the design, a row for each wire."""
    runs, steps = wire["runs"], wire["steps"]
    feed_mm, rotate_deg, bend_deg, curvature = wire["sigma"]
    count = len(steps)
    is_bend = numpy.array([step["bend_deg"] != 0 for step in steps])
    bends = numpy.radians(numpy.array([step["bend_deg"] for step in steps]))
    bends = bends + numpy.radians(random.normal(0, bend_deg, (runs, count))) * is_bend
    turns = numpy.radians(numpy.array([step["rotate_deg"] for step in steps]))
    turns = turns + numpy.radians(random.normal(0, rotate_deg, (runs, count))) * is_bend
    fed = numpy.array([step["feed_mm"] for step in steps]) + random.normal(0, feed_mm, (runs, count))
    corners = wire["bend_radius_mm"] * numpy.tan(numpy.abs(bends) / 2)
    before = numpy.hstack([numpy.zeros((runs, 1)), corners[:, :-1]])
    lengths = fed - wire["neutral_radius_mm"] * numpy.abs(bends) + before + corners
    bows = 4 * numpy.arctan(2 * random.normal(0, curvature, (runs, count)))
    at, t, n, b = (numpy.tile(numpy.array(row, dtype=float), (runs, 1)) for row in wire["start"])
    design = numpy.array(wire["design"])
    distances = [numpy.linalg.norm(at - design[0], axis=1)]
    for k, step in enumerate(steps):
        *inner, _ = step["fractions"]
        if inner:
            side = random.uniform(0, 2 * numpy.pi, runs)[:, None]
            across = n * numpy.cos(side) + b * numpy.sin(side)
        for fraction in inner:
            along, aside = arc(bows[:, k], lengths[:, k], fraction)
            vertex = at + t * along[:, None] + across * aside[:, None]
            distances.append(numpy.linalg.norm(vertex - design[len(distances)], axis=1))
        at = at + t * (lengths[:, k] * numpy.sinc(bows[:, k] / 2 / numpy.pi))[:, None]
        distances.append(numpy.linalg.norm(at - design[len(distances)], axis=1))
        cos, sin = numpy.cos(turns[:, k])[:, None], numpy.sin(turns[:, k])[:, None]
        n, b = n * cos + b * sin, b * cos - n * sin
        cos, sin = numpy.cos(bends[:, k])[:, None], numpy.sin(bends[:, k])[:, None]
        t, n = t * cos + n * sin, n * cos - t * sin
    return numpy.array(distances)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        wire = json.load(file)
    seconds = float("inf")
    for seed in range(wire["times"]):
        begin = time.perf_counter()
        distances = bent(wire, numpy.random.default_rng(seed))
        mean = distances.mean(axis=1)
        radius_95 = numpy.quantile(distances, 0.95, axis=1)
        seconds = min(seconds, time.perf_counter() - begin)
    print(json.dumps({"seconds": seconds, "mean": mean.tolist(), "radius_95": radius_95.tolist()}))


if __name__ == "__main__":
    main()
