"""Signs and squared lengths on homogeneous points, all exact."""

from __future__ import annotations

from gmpy2 import mpq, mpz, sign

from bern_exact.exact.points import HPoint, Line, Vector


def cross(u: Vector, v: Vector) -> mpz:
    """The cross product of two integer vectors."""
    return u[0] * v[1] - u[1] * v[0]


def dot(u: Vector, v: Vector) -> mpz:
    """The dot product of two integer vectors."""
    return u[0] * v[0] + u[1] * v[1]


def orientation(p: HPoint, q: HPoint, r: HPoint) -> int:
    """1 if p, q, r turn left, -1 if they turn right, 0 if they lie on one line.

    >>> from bern_exact.exact.points import hpoint
    >>> orientation(hpoint(0, 0), hpoint(1, 0), hpoint(0, mpq(1, 10**30)))
    1
    """
    px, py, pw = p
    qx, qy, qw = q
    rx, ry, rw = r
    return int(
        sign((qx * pw - px * qw) * (ry * pw - py * rw) - (qy * pw - py * qw) * (rx * pw - px * rw))
    )


def side(line: Line, p: HPoint) -> int:
    """1 if p lies left of the line, -1 right of it, 0 on it."""
    return int(sign(line[0] * p[0] + line[1] * p[1] + line[2] * p[2]))


def compare_xy(p: HPoint, q: HPoint) -> int:
    """-1, 0 or 1 as p comes before, equals or comes after q lexicographically."""
    difference = p[0] * q[2] - q[0] * p[2]
    if difference == 0:
        difference = p[1] * q[2] - q[1] * p[2]
    return int(sign(difference))


def squared_distance(p: HPoint, q: HPoint) -> mpq:
    """The squared distance of two points."""
    px, py, pw = p
    qx, qy, qw = q
    dx = qx * pw - px * qw
    dy = qy * pw - py * qw
    w = pw * qw
    return mpq(dx * dx + dy * dy, w * w)


def squared_distance_to_line(line: Line, p: HPoint) -> mpq:
    """The squared distance of a point from a line."""
    a, b, c = line
    value = a * p[0] + b * p[1] + c * p[2]
    return mpq(value * value, (a * a + b * b) * p[2] * p[2])


def squared_distance_to_segment(p: HPoint, a: HPoint, b: HPoint) -> mpq:
    """The squared distance of p from the closed segment ab; a = b is allowed."""
    px, py, pw = p
    ax, ay, aw = a
    bx, by, bw = b
    ux, uy = bx * aw - ax * bw, by * aw - ay * bw  # aw bw (b - a)
    vx, vy = px * aw - ax * pw, py * aw - ay * pw  # aw pw (p - a)
    if ux * vx + uy * vy <= 0:
        return mpq(vx * vx + vy * vy, (aw * pw) ** 2)
    wx, wy = px * bw - bx * pw, py * bw - by * pw  # bw pw (p - b)
    if ux * wx + uy * wy >= 0:
        return mpq(wx * wx + wy * wy, (bw * pw) ** 2)
    area = ux * vy - uy * vx
    return mpq(area * area, (ux * ux + uy * uy) * (aw * pw) ** 2)


def squared_height(p: HPoint, q: HPoint, r: HPoint) -> mpq:
    """The squared height of a triangle: the distance from its longest edge to the third vertex.

    Zero for a degenerate triangle of at least two distinct vertices.
    """
    px, py, pw = p
    qx, qy, qw = q
    rx, ry, rw = r
    ax, ay = qx * pw - px * qw, qy * pw - py * qw  # pw qw (q - p)
    bx, by = rx * pw - px * rw, ry * pw - py * rw  # pw rw (r - p)
    cx, cy = rx * qw - qx * rw, ry * qw - qy * rw  # qw rw (r - q)
    area = ax * by - ay * bx  # pw^2 qw rw twice the area
    longest = max(
        (ax * ax + ay * ay) * rw * rw, (bx * bx + by * by) * qw * qw, (cx * cx + cy * cy) * pw * pw
    )
    return mpq(area * area, longest * pw * pw)


def is_in_wedge(p: HPoint, before: HPoint, apex: HPoint, after: HPoint) -> bool:
    """Is p in the closed wedge at `apex`, counter-clockwise from `after` round to `before`?

    The wedge of a polygon's vertex is its interior cone: `after` is the next
    vertex along the boundary (interior on the left), `before` the previous
    one.  A 180-degree wedge is a half-plane.  p = apex lies in it.
    """
    left_of_out = orientation(apex, after, p)
    left_of_in = orientation(before, apex, p)
    if orientation(before, apex, after) >= 0:
        return left_of_out >= 0 and left_of_in >= 0
    return left_of_out >= 0 or left_of_in >= 0
