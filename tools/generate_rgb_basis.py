#!/usr/bin/env python3
"""Prints src/spectrum/rgb_basis.cpp: reflectance spectra of the Rec. 709 primaries.

    tools/generate_rgb_basis.py > src/spectrum/rgb_basis.cpp

Mallett & Yuksel 2019, "Spectral Primary Decomposition for Rendering with sRGB Reflectance": three
spectra r, g, b, each in [0, 1], with sum one at every wavelength, that have the colours {1,0,0},
{0,1,0} and {0,0,1} under D65, and are as smooth as that allows (least sum of squared differences
of neighbours). A reflectance R r + G g + B b then has the colour {R, G, B} for every R, G, B.

The spectra are linear between nodes 5 nm apart and all integrals are exact for the functions that
the renderer interpolates, so the round trip is exact in the renderer and not only in a table.
The quadratic programme is solved by a primal-dual active set method (Hintermueller, Ito & Kunisch
2002). Reads the observer and D65 from src/spectrum; needs nothing but Python.
"""

import pathlib
import re

SOURCE = pathlib.Path(__file__).resolve().parent.parent / "src" / "spectrum"
CELLS = 470  # of 1 nm, from 360 nm
STEP = 5  # nm between nodes
NODES = CELLS // STEP + 1
REC709 = [(0.64, 0.33), (0.30, 0.60), (0.15, 0.06)]


def read_table(name):
    text = (SOURCE / name).read_text()
    body = text[text.index("{{") : text.index("}};")]
    return [float(x) for x in re.findall(r"[0-9][-+.0-9e]*", body)]


def solve(matrix, rhs):
    """Solves a square system by elimination with row pivoting."""
    rows = [row + [value] for row, value in zip(matrix, rhs)]
    n = len(rows)
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        head, tail = rows[i][i], rows[i][i:]
        for k in range(i + 1, n):
            if rows[k][i] != 0.0:
                f = rows[k][i] / head
                rows[k][i:] = [a - f * b for a, b in zip(rows[k][i:], tail)]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (rows[i][n] - sum(a * b for a, b in zip(rows[i][i + 1 : n], x[i + 1 :]))) / rows[i][i]
    return x


def integrate(*functions):
    """Integral of a product of functions given at half nanometres: Simpson's rule per nanometre,
    exact for products of up to three functions that are linear between whole nanometres."""
    total = 0.0
    for i in range(0, 2 * CELLS, 2):
        for k, weight in ((i, 1 / 6), (i + 1, 4 / 6), (i + 2, 1 / 6)):
            product = weight
            for f in functions:
                product *= f[k]
            total += product
    return total


def halves(table):
    """A table at whole nanometres, with the midpoints filled in."""
    return [
        table[k // 2] if k % 2 == 0 else 0.5 * (table[k // 2] + table[k // 2 + 1])
        for k in range(2 * CELLS + 1)
    ]


def hat(node):
    """The function that is one at a node and zero at all others."""
    return [max(0.0, 1.0 - abs(k / 2 - node * STEP) / STEP) for k in range(2 * CELLS + 1)]


def colour_rows():
    """rows[c][i]: Rec. 709 component c of hat function i under D65; all add up to {1, 1, 1}."""
    flat = read_table("cie_1931.cpp")
    observer = [halves(flat[c::3]) for c in range(3)]
    d65 = halves(read_table("cie_d65.cpp"))
    white = [integrate(bar, d65) for bar in observer]
    primaries = [[x / y, 1.0, (1.0 - x - y) / y] for x, y in REC709]
    columns = [[primaries[c][k] for c in range(3)] for k in range(3)]
    strength = solve(columns, white)
    xyz_from_rgb = [[columns[k][c] * strength[c] for c in range(3)] for k in range(3)]
    xyz = [[integrate(bar, d65, hat(i)) for bar in observer] for i in range(NODES)]
    rgb = [solve(xyz_from_rgb, value) for value in xyz]
    return [[rgb[i][c] for i in range(NODES)] for c in range(3)]


def active_set_step(rows, active):
    """The smoothest spectra that meet all equations and are zero where `active`, and the
    multipliers of those zeros. Unknowns: 3 spectra, then one multiplier for every equation."""
    unknowns = 3 * NODES
    equations, rhs = [], []
    for i in range(NODES):
        equations.append({c * NODES + i: 1.0 for c in range(3)})
        rhs.append(1.0)
    for c in range(2):  # the colour of the third follows from the sum
        for k in range(3):
            equations.append({c * NODES + i: rows[k][i] for i in range(NODES)})
            rhs.append(1.0 if k == c else 0.0)
    size = unknowns + len(equations)
    hessian = [[0.0] * size for _ in range(unknowns)]
    for c in range(3):
        for i in range(NODES - 1):
            a, b = c * NODES + i, c * NODES + i + 1
            hessian[a][a] += 1.0
            hessian[b][b] += 1.0
            hessian[a][b] -= 1.0
            hessian[b][a] -= 1.0
    matrix = [row[:] for row in hessian]
    for e, equation in enumerate(equations):
        row = [0.0] * size
        for j, value in equation.items():
            row[j] = value
            matrix[j][unknowns + e] = value
        matrix.append(row)
    # Fixing an unknown at zero takes its row and its column away.
    free = [j for j in range(size) if j >= unknowns or not active[j]]
    right = [0.0] * unknowns + rhs
    reduced = solve([[matrix[a][b] for b in free] for a in free], [right[a] for a in free])
    x = [0.0] * size
    for j, value in zip(free, reduced):
        x[j] = value
    gradient = [sum(a * b for a, b in zip(matrix[j], x)) for j in range(unknowns)]
    return x[:unknowns], [gradient[j] if active[j] else 0.0 for j in range(unknowns)]


def solve_basis():
    rows = colour_rows()
    active = [False] * (3 * NODES)
    for _ in range(100):
        x, multiplier = active_set_step(rows, active)
        following = [value - force < 0.0 for value, force in zip(x, multiplier)]
        if following == active:
            return [[x[c * NODES + i] for c in range(3)] for i in range(NODES)]
        active = following
    raise SystemExit("the active set does not settle")


HEADER = """#include "spectrum/cie_data.h"

namespace lapidary {

// Made by tools/generate_rgb_basis.py from the CIE observer and D65 beside this file: the smoothest
// spectra (least sum of squared differences) that are in [0, 1], add up to one and have the colours
// of the Rec. 709 primaries under D65. Method: Mallett & Yuksel 2019, "Spectral Primary
// Decomposition for Rendering with sRGB Reflectance".
// clang-format off
constinit const std::array<std::array<double, 3>, rgb_basis_samples> rgb_reflectance_basis = {{"""

if __name__ == "__main__":
    print(HEADER)
    for spectra in solve_basis():
        print("    {%.12f, %.12f, %.12f}," % tuple(spectra))
    print("}};\n// clang-format on\n\n}  // namespace lapidary")
