#!/usr/bin/env python3
"""From a file with names to a finite element solution: heat in a block between a cold inlet and a cold outlet.

On the unit cube, -div grad u = f has the solution u = sin(pi x) cos(pi y) cos(pi z). It is 0 at the inlet (x = 0) and at
the outlet (x = 1), and has no flux through the walls. Linear elements on three meshes, each with half the size of the
one before: the error of the gradient halves each time, that of the solution becomes a quarter.
"""
import os
import sys
import tempfile

try:
    import numpy as np
    import scipy.sparse as sparse
    from scipy.sparse.linalg import spsolve
except ImportError as error:
    print("skipped: %s (python3-numpy, python3-scipy)" % error)
    sys.exit(77)

import boundary_recovery as br


def write_block(file, n):
    """A textual .stl file of the unit cube, with n by n squares on each side; a solid for each name."""
    sides = {"inlet": [], "outlet": [], "walls": []}
    for axis in range(3):
        for side in (0, 1):
            for u in range(n):
                for v in range(n):
                    corners = []
                    for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0.0, 0.0, 0.0]
                        p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side, (u + du) / n, (v + dv) / n
                        corners.append(p)
                    a, b, c, d = corners if side else corners[::-1]
                    name = ("inlet", "outlet")[side] if axis == 0 else "walls"
                    sides[name] += [(a, b, c), (a, c, d)]
    with open(file, "w") as stream:
        for name, triangles in sides.items():
            stream.write("solid %s\n" % name)
            for t in triangles:
                stream.write("facet normal 0 0 0\nouter loop\n")
                stream.writelines("vertex %r %r %r\n" % tuple(p) for p in t)
                stream.write("endloop\nendfacet\n")
            stream.write("endsolid %s\n" % name)


def exact(p):
    x, y, z = np.pi * p.T
    return np.sin(x) * np.cos(y) * np.cos(z)


def exact_gradient(p):
    x, y, z = np.pi * p.T
    return np.pi * np.stack([np.cos(x) * np.cos(y) * np.cos(z), -np.sin(x) * np.sin(y) * np.cos(z),
                             -np.sin(x) * np.cos(y) * np.sin(z)], axis=1)


def solve(mesh, fixed):
    """Linear elements; `fixed` are the points where the solution is 0. Returns it, its gradients, and the volumes."""
    tets = mesh.tetrahedra
    corners = mesh.points[tets]
    matrices = np.swapaxes(corners[:, 1:] - corners[:, :1], 1, 2)  # columns are edges
    volumes = np.linalg.det(matrices) / 6
    inverse = np.linalg.inv(matrices)
    gradients = np.concatenate([-inverse.sum(axis=1, keepdims=True), inverse], axis=1)  # of the four basis functions
    local = np.einsum("t,tia,tja->tij", volumes, gradients, gradients)
    rows, columns = np.repeat(tets, 4, axis=1).ravel(), np.tile(tets, 4).ravel()
    n = len(mesh.points)
    stiffness = sparse.csr_matrix((local.ravel(), (rows, columns)), shape=(n, n))
    load = np.bincount(tets.ravel(), np.repeat(volumes / 4 * 3 * np.pi**2 * exact(corners.mean(axis=1)), 4), n)
    free = np.setdiff1d(np.unique(tets), fixed)
    u = np.zeros(n)
    u[free] = spsolve(stiffness[free][:, free].tocsc(), load[free])
    return u, np.einsum("tia,ti->ta", gradients, u[tets]), volumes


def main():
    errors = []
    with tempfile.TemporaryDirectory() as folder:
        for n in (3, 6, 12):
            file = os.path.join(folder, "block.stl")
            write_block(file, n)
            surface = br.read(file)
            mesh = br.tetrahedralize(surface.points, surface.triangles, size=1 / n, patches=surface.patches,
                                     patch_names=surface.patch_names)
            assert mesh, mesh.status
            number = {name: patch for patch, name in mesh.patch_names.items()}
            cold = np.unique(mesh.triangles[np.isin(mesh.patches, [number["inlet"], number["outlet"]])])
            u, gradients, volumes = solve(mesh, cold)
            middles = mesh.points[mesh.tetrahedra].mean(axis=1)
            of_solution = np.sqrt(volumes @ (u[mesh.tetrahedra].mean(axis=1) - exact(middles))**2)
            of_gradient = np.sqrt(volumes @ ((gradients - exact_gradient(middles))**2).sum(axis=1))
            errors.append((of_solution, of_gradient))
            print("size 1/%-2d %6d tetrahedra: error of the solution %.4f, of its gradient %.4f" % (
                n, len(mesh.tetrahedra), of_solution, of_gradient))
    ratios = np.array(errors)[:-1] / np.array(errors)[1:]
    print("the errors are divided by", ", ".join("%.2f and %.2f" % tuple(r) for r in ratios))
    assert (ratios[:, 0] > 3).all() and (ratios[:, 1] > 1.7).all()


main()
