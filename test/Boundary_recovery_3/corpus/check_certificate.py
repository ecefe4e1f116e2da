#!/usr/bin/env python3
"""Checks what a report of mesh_surface says of the tetrahedra that stayed bad.

usage: check_certificate.py REPORT.json SURFACE.off MESH.mesh

Demanded is of each entry:
  - the tetrahedron has the angle, at the edge, and it is below the target;
  - `forced`: both facets are the triangles of the surface that are named, they have an edge of the tetrahedron in common,
    the angle between them is the one that is told, and below the target, and the tetrahedron is between them;
  - `gap`: both facets are triangles of the surface that have no edge in common, and the second one is above the center of
    the inscribed circle of the first one, at the distance that is told, which allows no more than the angle that is told,
    and that is below the target. Either the first one is a facet of the tetrahedron, and this has no larger smallest angle,
    or has an edge in common with it, and is as low as that angle would be for the target;
  - `needle`: the facet of the tetrahedron is the triangle of the surface that is named, its smallest angle is the one
    that is told, below the target, and less than twice the tetrahedron's;
  - `not_improved`: if a triangle is named, it has a vertex of the tetrahedron, its smallest angle is the one that is
    told, and below the target; if two are, both are facets of the tetrahedron, with the angle that is told between them,
    which is larger than 180 degrees less the target.
And all tetrahedra of the mesh with an angle below the target have an entry, if the mesh is small. Normals are computed in
integers. Only Python's standard library is used.
"""
import itertools
import json
import math
import sys

TOLERANCE = 1e-6  # in degrees
SMALL = 20000     # tetrahedra


class Wrong(Exception):
    """The certificate says something that is not true."""


def require(condition, *words):
    if not condition:
        raise Wrong(' '.join(map(str, words)))


def minus(p, q):
    return [x - y for x, y in zip(p, q)]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def unit_vector(u):
    """In floating point numbers, of a vector of integers, however large."""
    largest = max(map(abs, u))
    if not largest:
        return [0.0, 0.0, 0.0]
    u = [x / largest for x in u]
    return [x / math.sqrt(dot(u, u)) for x in u]


def angle(u, v):
    """In degrees."""
    u, v = unit_vector(u), unit_vector(v)
    normal = cross(u, v)
    return math.degrees(math.atan2(math.sqrt(dot(normal, normal)), dot(u, v)))


def angle_between(p, q, r, s):
    """Of the half-planes from the line pq to r and to s."""
    axis = minus(q, p)
    return angle(cross(axis, minus(r, p)), cross(axis, minus(s, p)))


def dihedral_angles(corners):
    """The angle at each edge, which is given as two positions."""
    for i, j in itertools.combinations(range(4), 2):
        k, l = (x for x in range(4) if x not in (i, j))
        yield (i, j), angle_between(*(corners[x] for x in (i, j, k, l)))


def smallest_plane_angle(corners):
    return min(angle(minus(corners[i - 1], corners[i]), minus(corners[i - 2], corners[i])) for i in range(3))


def integers(points):
    """All coordinates, multiplied by the same power of two."""
    ratios = [[float(x).as_integer_ratio() for x in p] for p in points]
    scale = max((d for p in ratios for _, d in p), default=1)
    return [tuple(n * (scale // d) for n, d in p) for p in ratios]


class Inscribed_circle:
    """Of a triangle, in floating point numbers, as a place to look from."""
    def __init__(self, corners):
        lengths = [math.dist(corners[i - 1], corners[i - 2]) for i in range(3)]
        perimeter = sum(lengths)
        self.center = [sum(x * p[k] / perimeter for x, p in zip(lengths, corners)) for k in range(3)]
        u, v = ([x / perimeter for x in minus(corners[i], corners[0])] for i in (1, 2))
        normal = cross(u, v)
        length = math.sqrt(dot(normal, normal))
        self.normal = [x / length for x in normal]
        self.radius = length * perimeter

    def height(self, p):
        """Above the plane of the triangle."""
        return dot(self.normal, minus(p, self.center))

    def height_of_triangle(self, corners):
        """Where the line through the center, across the plane, meets another triangle."""
        corners = [minus(p, self.center) for p in corners]
        scale = max(abs(x) for p in corners for x in p)
        corners = [[x / scale for x in p] for p in corners]
        parts = [dot(self.normal, cross(corners[i - 2], corners[i - 1])) for i in range(3)]
        whole = sum(parts)
        require(whole != 0 and min(x / whole for x in parts) > -TOLERANCE, 'no triangle is above', self.center)
        return scale * sum(x / whole * dot(self.normal, p) for x, p in zip(parts, corners))


class Certificate_checker:
    def __init__(self, report, surface, mesh):
        """`surface` and `mesh` are points and lists of vertices, from 0."""
        self.improvement = report['improvement']
        self.target = self.improvement['target_angle']
        self.points, self.triangles = surface
        self.mesh_points, self.tetrahedra = mesh
        self.places = integers(self.mesh_points)

    def __call__(self):
        bad = self.improvement['bad_tetrahedra']
        for reason in ('forced', 'gap', 'needle', 'not_improved'):
            number = sum(entry['reason'] == reason for entry in bad)
            require(self.improvement['number_of_' + reason] == number, 'the number of', reason, 'is', number)
        angles = [entry['min_dihedral_angle'] for entry in bad]
        require(angles == sorted(angles), 'the worst are not the first')
        listed = {entry['tetrahedron'] for entry in bad}
        require(len(listed) == len(bad), 'a tetrahedron is listed twice')
        for entry in bad:
            self.check_entry(entry)
        if len(self.tetrahedra) <= SMALL:
            self.check_all_others(listed)
        return len(bad)

    def corners(self, tetrahedron):
        return [self.places[v] for v in self.tetrahedra[tetrahedron]]

    def check_all_others(self, listed):
        for i in range(len(self.tetrahedra)):
            if i not in listed:
                smallest = min(x for _, x in dihedral_angles(self.corners(i)))
                require(smallest > self.target - TOLERANCE, 'tetrahedron', i, 'is not listed')

    def check_entry(self, entry):
        t = self.tetrahedra[entry['tetrahedron']]
        told = entry['min_dihedral_angle']
        angles = {frozenset((t[i], t[j])): x for (i, j), x in dihedral_angles(self.corners(entry['tetrahedron']))}
        smallest = min(angles.values())
        require(told < self.target and abs(smallest - told) < TOLERANCE, entry, 'has the angle', smallest)
        require(abs(angles[frozenset(entry['edge'])] - told) < TOLERANCE, entry, 'has another angle at the edge')
        facets = entry.get('facets', [])
        require(len(facets) in {'forced': [2], 'gap': [2], 'needle': [1], 'not_improved': [0, 1, 2]}[entry['reason']],
                entry, 'has other facets')
        for facet in facets:
            self.check_facet(facet)
        if not facets:
            return
        is_flat = entry['reason'] == 'not_improved' and len(facets) == 2
        require(entry['surface_angle'] < self.target or is_flat, entry, 'is not below the target')
        {'forced': self.check_forced, 'gap': self.check_gap, 'needle': self.check_needle,
         'not_improved': self.check_flat if is_flat else self.check_needle}[entry['reason']](entry, t, angles)

    def check_facet(self, facet):
        """It is in the surface."""
        triangle = sorted(tuple(self.points[v]) for v in self.triangles[facet['triangle']])
        require(triangle == sorted(tuple(self.mesh_points[v]) for v in facet['points']), facet, 'is another triangle')

    def check_forced(self, entry, t, angles):
        first, second = (set(facet['points']) for facet in entry['facets'])
        edge = first & second & set(t)
        require(len(first & second) == 2 and len(edge) == 2, entry, 'has other facets')
        p, q = (self.places[v] for v in sorted(edge))
        apexes = [self.places[min(facet - edge)] for facet in (first, second)]
        found = angle_between(p, q, *apexes)
        require(abs(found - entry['surface_angle']) < TOLERANCE, entry, 'is between facets at', found)
        require(angles[frozenset(edge)] < found + TOLERANCE, entry, 'has a larger angle')
        for v in set(t) - edge:
            both = [angle_between(p, q, apex, self.places[v]) for apex in apexes]
            require(abs(sum(both) - found) < TOLERANCE, entry, 'is not between its facets')

    def check_gap(self, entry, t, angles):
        first, second = (facet['points'] for facet in entry['facets'])
        common = len(set(first) & set(t))
        require(len(set(first) & set(second)) < 2 and common >= 2, entry, 'has other facets')
        circle = Inscribed_circle([self.mesh_points[v] for v in first])
        heights = [circle.height(self.mesh_points[v]) for v in t]
        limit = circle.radius * math.tan(math.radians(min(self.target, 60)))
        found = circle.height_of_triangle([self.mesh_points[v] for v in second])
        if common == 3:
            require(found * sum(heights) > 0, entry, 'has a facet on the other side')
            require(entry['min_dihedral_angle'] < entry['surface_angle'] + TOLERANCE, entry, 'has a larger angle')
        else:
            require(max(map(abs, heights)) < limit * (1 + TOLERANCE), entry, 'is not low')
        require(abs(found) < limit and math.isclose(abs(found), entry['distance'], rel_tol=TOLERANCE),
                entry, 'has a gap of', found)
        allowed = math.degrees(math.atan2(abs(found), circle.radius))
        require(abs(allowed - entry['surface_angle']) < TOLERANCE, entry, 'has a gap that allows', allowed)

    def check_flat(self, entry, t, angles):
        first, second = (set(facet['points']) for facet in entry['facets'])
        require(first < set(t) and second < set(t) and first != second, entry, 'has other facets')
        found = angles[frozenset(first & second)]
        require(abs(found - entry['surface_angle']) < TOLERANCE and found > 180 - self.target, entry, 'is not flat')

    def check_needle(self, entry, t, angles):
        facet = entry['facets'][0]['points']
        common = len(set(facet) & set(t))
        require(common == 3 if entry['reason'] == 'needle' else common > 0, entry, 'has another facet')
        require(entry['reason'] != 'needle' or entry['surface_angle'] < 2 * entry['min_dihedral_angle'], entry, 'is thinner')
        found = smallest_plane_angle([self.places[v] for v in facet])
        require(abs(found - entry['surface_angle']) < TOLERANCE, entry, 'has a facet with the angle', found)


def words_of(path):
    with open(path) as file:
        for line in file:
            yield from line.split('#')[0].split()


def read_surface(path):
    words = words_of(path)
    require(next(words) == 'OFF', path, 'is no OFF file')
    n, m, _ = (int(next(words)) for _ in range(3))
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(n)]
    return points, [[int(next(words)) for _ in range(int(next(words)))] for _ in range(m)]


def read_tetrahedra(path):
    words, points, tetrahedra = words_of(path), [], []
    for word in words:
        if word == 'Vertices':
            for _ in range(int(next(words))):
                points.append(tuple(float(next(words)) for _ in range(3)))
                next(words)
        elif word == 'Tetrahedra':
            for _ in range(int(next(words))):
                tetrahedra.append([int(next(words)) - 1 for _ in range(4)])
                next(words)
    return points, tetrahedra


def main(arguments):
    if len(arguments) != 3:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    with open(arguments[0]) as file:
        report = json.load(file)
    try:
        number = Certificate_checker(report, read_surface(arguments[1]), read_tetrahedra(arguments[2]))()
    except Wrong as wrong:
        print('wrong:', wrong)
        return 1
    print('right: %d tetrahedra' % number)
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
