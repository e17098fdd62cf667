#!/usr/bin/env python3
"""Wires bent with errors, all at once with NumPy: the peer of `make bench`.

Reads what `scatter` writes: the commands of a program with the bends that they leave, and standard deviations. Prints one JSON line: the
least seconds of several times, for each vertex the mean distance from the design and the one that 95 % of the wires keep within, and
without errors its place, and with errors that are `small` times as large how far it is from there on average, and its covariance.

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


def bent(wire, random, see, times=1.0):
    """Bends wires and gives what `see` makes of the places of each vertex, a row for each wire, and of its number."""
    runs, steps = wire["runs"], wire["steps"]
    feed_mm, rotate_deg, bend_deg, curvature = (times * sigma for sigma in wire["sigma"])
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
    seen = [see(at, 0)]
    for k, step in enumerate(steps):
        *inner, _ = step["fractions"]
        if inner:
            side = random.uniform(0, 2 * numpy.pi, runs)[:, None]
            across = n * numpy.cos(side) + b * numpy.sin(side)
        for fraction in inner:
            along, aside = arc(bows[:, k], lengths[:, k], fraction)
            vertex = at + t * along[:, None] + across * aside[:, None]
            seen.append(see(vertex, len(seen)))
        at = at + t * (lengths[:, k] * numpy.sinc(bows[:, k] / 2 / numpy.pi))[:, None]
        seen.append(see(at, len(seen)))
        cos, sin = numpy.cos(turns[:, k])[:, None], numpy.sin(turns[:, k])[:, None]
        n, b = n * cos + b * sin, b * cos - n * sin
        cos, sin = numpy.cos(bends[:, k])[:, None], numpy.sin(bends[:, k])[:, None]
        t, n = t * cos + n * sin, n * cos - t * sin
    return seen


def scattered(wire):
    """The places of all vertices without errors, and with small ones their mean distance from there and their covariance."""
    perfect = numpy.array(bent({**wire, "runs": 1}, numpy.random.default_rng(0), lambda at, _: at[0].copy(), 0.0))
    batches = wire["drawn"] // wire["runs"]
    total, squares = numpy.zeros((len(perfect), 3)), numpy.zeros((len(perfect), 3, 3))

    def add(places, vertex):
        off = places - perfect[vertex]
        total[vertex] += off.sum(axis=0)
        squares[vertex] += off.T @ off

    for batch in range(batches):
        bent(wire, numpy.random.default_rng([1, batch]), add, wire["small"])
    mean = total / (batches * wire["runs"])
    covariance = squares / (batches * wire["runs"]) - mean[:, :, None] * mean[:, None, :]
    return perfect, mean, covariance


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        wire = json.load(file)
    design = numpy.array(wire["design"])
    seconds = float("inf")
    for seed in range(wire["times"]):
        begin = time.perf_counter()
        distances = numpy.array(
            bent(wire, numpy.random.default_rng(seed), lambda at, vertex: numpy.linalg.norm(at - design[vertex], axis=1))
        )
        mean = distances.mean(axis=1)
        radius_95 = numpy.quantile(distances, 0.95, axis=1)
        seconds = min(seconds, time.perf_counter() - begin)
    perfect, off, covariance = scattered(wire)
    print(
        json.dumps(
            {
                "seconds": seconds,
                "mean": mean.tolist(),
                "radius_95": radius_95.tolist(),
                "perfect": perfect.tolist(),
                "off": off.tolist(),
                "covariance": covariance.reshape(-1, 9).tolist(),
            }
        )
    )


if __name__ == "__main__":
    main()
