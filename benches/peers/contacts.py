#!/usr/bin/env python3
"""Contacts of a program with FCL, sampled: the peer of `make bench`.

Reads what `contacts` writes: a line of JSON with the solids and the legs of the wire, then rows of 15 numbers: step, solid, how many
legs count, and its pose in the frame of the wire, row by row. Prints one JSON line: the seconds that it takes, and for each step
which solids touch the wire. Only setting poses and asking is timed.

    python benches/peers/contacts.py program.bin
"""

import json
import sys
import time

import fcl
import numpy


def shape(solid):
    (kind, size), = solid.items()
    return {"box": fcl.Box, "cylinder": fcl.Cylinder, "capsule": fcl.Capsule}[kind](*size)


def leg(begin, end, radius):
    """A capsule from one corner to the next."""
    along = end - begin
    length = numpy.linalg.norm(along)
    z = along / length
    x = numpy.cross(z, [1.0, 0.0, 0.0] if abs(z[0]) < 0.9 else [0.0, 1.0, 0.0])
    x /= numpy.linalg.norm(x)
    turn = numpy.column_stack([x, numpy.cross(z, x), z])
    return fcl.CollisionObject(fcl.Capsule(radius, length), fcl.Transform(turn, (begin + end) / 2))


def main():
    with open(sys.argv[1], "rb") as file:
        header = json.loads(file.readline())
        rows = numpy.frombuffer(file.read(), dtype="<f8").reshape(-1, 15)
    corners = numpy.array(header["corners"])
    legs = [leg(*pair, header["radius_mm"]) for pair in zip(corners, corners[1:])]
    solids = [fcl.CollisionObject(shape(solid)) for solid in header["solids"]]
    # What may touch the last legs has a tree of its own, which ends earlier.
    trees = {}
    touching = set()
    begin = time.perf_counter()
    for row in rows:
        step, solid, count = map(int, row[:3])
        if (step, solid) in touching:
            continue
        tree, held = trees.setdefault(header["lag"][solid], (fcl.DynamicAABBTreeCollisionManager(), []))
        if count > len(held):
            new = legs[len(held):count]
            held.extend(new)
            tree.registerObjects(new)
            tree.setup()
        pose = row[3:].reshape(3, 4)
        solids[solid].setTransform(fcl.Transform(pose[:, :3], pose[:, 3]))
        asked = fcl.CollisionData()
        tree.collide(solids[solid], asked, fcl.defaultCollisionCallback)
        if asked.result.is_collision:
            touching.add((step, solid))
    seconds = time.perf_counter() - begin
    print(json.dumps({"seconds": seconds, "asked": len(rows), "touching": sorted(touching)}))


main()
