#!/usr/bin/env python3
"""Frames under their own weight and their modes, by others: peers of `make bench`.

`prefixes PEER FILE` solves a frame again and again while it is built, strut by strut in the order of its members from `first` on, and
prints how long that takes and the largest displacement of each. `solve PEER FILE` reads a frame and prints one JSON line: how long the peer takes to build its model and to solve it, medians, and the
largest displacement. `modes PEER FILE` prints how long it takes to find the lowest modes that bend something, and their frequencies.
PyNite, pyconmech and OpenSees are programs for frames, the last where its libraries are; `scipy` is the textbook's element put together with NumPy and solved by `spsolve`,
`scipy-best` by `splu` with the ordering that suits symmetric matrices. `eigsh` is ARPACK, shift-invert with SciPy's own
factorisation, `eigsh-symmetric` with that of `scipy-best`.

    python benches/peers/frames.py solve pynite frame.json
    python benches/peers/frames.py modes eigsh frame.json
"""

import argparse
import json
import logging
import statistics
import time

import numpy
import scipy.sparse
import scipy.sparse.linalg


class Absent(Exception):
    """A peer that cannot be loaded here."""


class Frame:
    """A frame of round members that are all alike, clamped at some nodes; mm, N, t, s."""

    def __init__(self, file):
        with open(file, encoding="utf-8") as text:
            given = json.load(text)
        self.nodes = numpy.array(given["nodes_mm"])
        self.members = numpy.array(given["members"])
        self.clamped = given["clamped"]
        self.e, self.g, self.density = given["e_mpa"], given["g_mpa"], given["density_t_mm3"]
        self.gravity, self.modes, self.shift_hz = given["gravity_mm_s2"], given["modes"], given["shift_hz"]
        self.first = given["first"]
        radius = given["radius_mm"]
        self.area = numpy.pi * radius**2
        self.i = numpy.pi * radius**4 / 4
        self.j = 2 * self.i
        self.weight = self.density * self.area * self.gravity


def axes_of(spans):
    """Local axes of members, rows x, y, z: y across both x and z, or across x and y where a member is along z."""
    x = spans / numpy.linalg.norm(spans, axis=1)[:, None]
    along_z = numpy.hypot(x[:, 0], x[:, 1]) < 1e-6
    up = numpy.where(along_z[:, None], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])
    y = numpy.cross(up, x)
    y /= numpy.linalg.norm(y, axis=1)[:, None]
    return numpy.stack([x, y, numpy.cross(x, y)], axis=1)


def filled(length, axial, twist, bend):
    """12 by 12 matrices in local axes, from those of a rod, of a shaft and of a beam; `bend` is [shear, lever, near, far] by ends."""
    k = numpy.zeros((len(length), 12, 12))
    for at, pair in ((0, axial), (3, twist)):
        for a, end_a in enumerate((at, at + 6)):
            for b, end_b in enumerate((at, at + 6)):
                k[:, end_a, end_b] = pair[a == b]
    # In the plane of x and y rotations are about z; in that of x and z they are about -y.
    for shift, turn, sign in ((1, 5, 1), (2, 4, -1)):
        places = (shift, turn, shift + 6, turn + 6)
        for a, row in enumerate(places):
            for b, column in enumerate(places):
                signs = (sign if a % 2 else 1) * (sign if b % 2 else 1)
                k[:, row, column] = signs * bend[a][b]
    return k


def assembled(frame, with_mass):
    """K, M and the load of the weight over all degrees of freedom (Przemieniecki 1968)."""
    spans = frame.nodes[frame.members[:, 1]] - frame.nodes[frame.members[:, 0]]
    length = numpy.linalg.norm(spans, axis=1)
    axes = axes_of(spans)
    ei = frame.e * frame.i
    rod, shaft = frame.e * frame.area / length, frame.g * frame.j / length
    shear, lever, near, far = 12 * ei / length**3, 6 * ei / length**2, 4 * ei / length, 2 * ei / length
    beam = [[shear, lever, -shear, lever], [lever, near, -lever, far], [-shear, -lever, shear, -lever], [lever, far, -lever, near]]
    k = filled(length, (-rod, rod), (-shaft, shaft), beam)
    turn = numpy.zeros((len(length), 12, 12))
    for block in range(0, 12, 3):
        turn[:, block : block + 3, block : block + 3] = axes
    turned = lambda local: numpy.einsum("mji,mjk,mkl->mil", turn, local, turn, optimize=True)
    places = (6 * frame.members[:, :, None] + numpy.arange(6)).reshape(len(length), 12)
    size = 6 * len(frame.nodes)
    rows, columns = numpy.repeat(places, 12, axis=1).ravel(), numpy.tile(places, (1, 12)).ravel()
    sparse = lambda local: scipy.sparse.csc_matrix((turned(local).ravel(), (rows, columns)), shape=(size, size))
    mass = None
    if with_mass:
        m = frame.density * frame.area * length
        spin = m * frame.j / frame.area
        a, b, c, d = 156 / 420 * m, 22 / 420 * m * length, 54 / 420 * m, 13 / 420 * m * length
        e, f = 4 / 420 * m * length**2, -3 / 420 * m * length**2
        beam = [[a, b, c, -d], [b, e, d, f], [c, d, a, -b], [-d, f, -b, e]]
        mass = sparse(filled(length, (m / 6, m / 3), (spin / 6, spin / 3), beam))
    line = numpy.array([0.0, 0.0, -frame.weight])
    force = line * length[:, None] / 2
    moment = numpy.cross(spans / length[:, None], line) * (length**2 / 12)[:, None]
    load = numpy.zeros(size)
    numpy.add.at(load, places, numpy.hstack([force, moment, force, -moment]))
    used = (6 * numpy.unique(frame.members)[:, None] + numpy.arange(6)).ravel()
    free = numpy.setdiff1d(used, [6 * node + k for node in frame.clamped for k in range(6)])
    return sparse(k), mass, load, free


def largest(displacements):
    return float(numpy.linalg.norm(displacements, axis=1).max())


def by_scipy(frame, best):
    start = time.perf_counter()
    k, _, load, free = assembled(frame, False)
    k = k[free][:, free].tocsc()
    built = time.perf_counter()
    if best:
        found = symmetric(k).solve(load[free])
    else:
        found = scipy.sparse.linalg.spsolve(k, load[free])
    solved = time.perf_counter()
    moved = numpy.zeros(6 * len(frame.nodes))
    moved[free] = found
    return built - start, solved - built, largest(moved.reshape(-1, 6)[:, :3])


def symmetric(matrix):
    """SuperLU for symmetric matrices that need no pivots."""
    options = {"SymmetricMode": True}
    return scipy.sparse.linalg.splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)


def by_pynite(frame):
    from Pynite import FEModel3D

    start = time.perf_counter()
    model = FEModel3D()
    # Its density is a weight.
    model.add_material("material", frame.e, frame.g, frame.e / (2 * frame.g) - 1, frame.density * frame.gravity)
    model.add_section("section", frame.area, frame.i, frame.i, frame.j)
    for k, (x, y, z) in enumerate(frame.nodes.tolist()):
        model.add_node(f"N{k}", x, y, z)
    for k, (a, b) in enumerate(frame.members.tolist()):
        model.add_member(f"M{k}", f"N{a}", f"N{b}", "material", "section")
    for node in frame.clamped:
        model.def_support(f"N{node}", *[True] * 6)
    model.add_member_self_weight("FZ", -1)
    built = time.perf_counter()
    model.analyze_linear(check_stability=False, sparse=True)
    solved = time.perf_counter()
    moved = [[getattr(node, axis)["Combo 1"] for axis in ("DX", "DY", "DZ")] for node in model.nodes.values()]
    return built - start, solved - built, largest(numpy.array(moved))


def checker_of(frame):
    """pyconmech turns members along z wrongly, and so the whole model is turned, and its gravity."""
    from pyconmech import StiffnessChecker
    from pyconmech.frame_analysis import CrossSec, Element, GravityLoad, LoadCase, Material, Model, Node, Support

    logging.disable(logging.CRITICAL)
    angles = numpy.array([0.4, 0.7])
    (c1, c2), (s1, s2) = numpy.cos(angles), numpy.sin(angles)
    turn = numpy.array([[1, 0, 0], [0, c1, -s1], [0, s1, c1]]) @ numpy.array([[c2, 0, s2], [0, 1, 0], [-s2, 0, c2]])
    metres = (frame.nodes @ turn.T / 1000).tolist()
    fixed = set(frame.clamped)
    nodes = [Node(point, k, k in fixed) for k, point in enumerate(metres)]
    elements = [Element((a, b), k, elem_tag="", bending_stiff=True) for k, (a, b) in enumerate(frame.members.tolist())]
    supports = [Support([True] * 6, node) for node in frame.clamped]
    i = frame.i * 1e-12
    section = CrossSec(frame.area * 1e-6, frame.j * 1e-12, i, i, elem_tags=[""])
    # kN and m; its density is a weight.
    weight = frame.density * frame.gravity * 1e6
    material = Material(frame.e * 1e3, frame.g * 1e3, 1.0, weight, elem_tags=[""])
    checker = StiffnessChecker(Model(nodes, elements, supports, [], [material], [section]))
    checker.set_loads(LoadCase(gravity_load=GravityLoad((turn @ [0, 0, -1]).tolist())))
    return checker


def moved_by(checker):
    _, moved, _, _ = checker.get_solved_results()
    return largest(numpy.array([u[:3] for u in moved.values()])) * 1000


def by_pyconmech(frame):
    start = time.perf_counter()
    checker = checker_of(frame)
    built = time.perf_counter()
    checker.solve(eid_sanity_check=False)
    solved = time.perf_counter()
    return built - start, solved - built, moved_by(checker)


def prefixes_by_pyconmech(frame):
    checker = checker_of(frame)
    start = time.perf_counter()
    most = []
    for count in range(frame.first, len(frame.members) + 1):
        checker.solve(exist_element_ids=list(range(count)), eid_sanity_check=False)
        most.append(moved_by(checker))
    return time.perf_counter() - start, most


def prefixes_by_scipy(frame):
    start = time.perf_counter()
    most, members = [], frame.members
    for count in range(frame.first, len(members) + 1):
        frame.members = members[:count]
        most.append(by_scipy(frame, True)[2])
    frame.members = members
    return time.perf_counter() - start, most


def modes(frame, is_symmetric):
    start = time.perf_counter()
    k, m, _, free = assembled(frame, True)
    k, m = k[free][:, free].tocsc(), m[free][:, free].tocsc()
    shift = (2 * numpy.pi * frame.shift_hz) ** 2
    inverse = None
    if is_symmetric:
        solve = symmetric((k + shift * m).tocsc()).solve
        inverse = scipy.sparse.linalg.LinearOperator(k.shape, matvec=solve, dtype=float)
    rigid = 0 if frame.clamped else 6
    squared = scipy.sparse.linalg.eigsh(k, frame.modes + rigid, m, sigma=-shift, OPinv=inverse, return_eigenvectors=False)
    ms = (time.perf_counter() - start) * 1000
    return {"ms": ms, "hz": (numpy.sqrt(numpy.sort(squared)[rigid:]) / (2 * numpy.pi)).tolist()}


def by_opensees(frame):
    # Beside what its package brings it needs libblas.so.3 of the system, and says so by an error of its own.
    try:
        import openseespy.opensees as ops
    except (ImportError, RuntimeError) as error:
        raise Absent(str(error)) from error

    start = time.perf_counter()
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    used = numpy.unique(frame.members)
    for node in used.tolist():
        ops.node(node, *frame.nodes[node].tolist())
    for node in frame.clamped:
        ops.fix(node, 1, 1, 1, 1, 1, 1)
    ops.geomTransf("Linear", 1, 0.0, 0.0, 1.0)
    ops.geomTransf("Linear", 2, 0.0, 1.0, 0.0)
    ops.timeSeries("Constant", 1)
    ops.pattern("Plain", 1, 1)
    spans = frame.nodes[frame.members[:, 1]] - frame.nodes[frame.members[:, 0]]
    local = axes_of(spans) @ numpy.array([0.0, 0.0, -frame.weight])
    along_z = numpy.hypot(spans[:, 0], spans[:, 1]) < 1e-6 * numpy.linalg.norm(spans, axis=1)
    section = (frame.area, frame.e, frame.g, frame.j, frame.i, frame.i)
    for member, (ends, load, upright) in enumerate(zip(frame.members.tolist(), local.tolist(), along_z.tolist(), strict=True)):
        ops.element("elasticBeamColumn", member, *ends, *section, 2 if upright else 1)
        along, y, z = load
        ops.eleLoad("-ele", member, "-type", "-beamUniform", y, z, along)
    ops.system("UmfPack")
    ops.numberer("RCM")
    ops.constraints("Plain")
    ops.integrator("LoadControl", 1.0)
    ops.algorithm("Linear")
    ops.analysis("Static")
    built = time.perf_counter()
    if ops.analyze(1) != 0:
        raise RuntimeError("OpenSees does not solve it")
    solved = time.perf_counter()
    moved = numpy.array([ops.nodeDisp(node)[:3] for node in used.tolist()])
    return built - start, solved - built, largest(moved)


SOLVERS = {
    "opensees": by_opensees,
    "pyconmech": by_pyconmech,
    "pynite": by_pynite,
    "scipy": lambda frame: by_scipy(frame, False),
    "scipy-best": lambda frame: by_scipy(frame, True),
}


PREFIXES = {"pyconmech": prefixes_by_pyconmech, "scipy": prefixes_by_scipy}


def prefixes(frame, peer):
    results = [PREFIXES[peer](frame) for _ in range(3)]
    return {"ms": statistics.median(seconds for seconds, _ in results) * 1000, "max_mm": results[-1][1]}


def solve(frame, peer):
    runs = 5 if len(frame.members) < 1000 else 3
    SOLVERS[peer](frame)
    results = [SOLVERS[peer](frame) for _ in range(runs)]
    build, solved = (statistics.median(result[k] for result in results) * 1000 for k in (0, 1))
    return {"build_ms": round(build, 3), "solve_ms": round(solved, 3), "max_mm": results[-1][2]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    tasks = parser.add_subparsers(dest="task", required=True)
    solving = tasks.add_parser("solve", help="time a peer on one frame")
    solving.add_argument("peer", choices=SOLVERS)
    solving.add_argument("file")
    vibrating = tasks.add_parser("modes", help="time SciPy on the modes of one frame")
    vibrating.add_argument("peer", choices=("eigsh", "eigsh-symmetric"))
    vibrating.add_argument("file")
    building = tasks.add_parser("prefixes", help="time a peer on one frame while it is built")
    building.add_argument("peer", choices=PREFIXES)
    building.add_argument("file")
    given = parser.parse_args()
    frame = Frame(given.file)
    if given.task == "solve":
        try:
            print(json.dumps({"peer": given.peer, **solve(frame, given.peer)}))
        except Absent as absent:
            print(json.dumps({"peer": given.peer, "absent": str(absent)}))
    elif given.task == "prefixes":
        print(json.dumps({"peer": given.peer, **prefixes(frame, given.peer)}))
    else:
        print(json.dumps({"peer": given.peer, **modes(frame, given.peer == "eigsh-symmetric")}))


if __name__ == "__main__":
    main()
