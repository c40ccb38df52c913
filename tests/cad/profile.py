"""CSV of a half-section, and volume and area of its closed profiles when revolved about the axis."""

import csv
import math
from collections import defaultdict

# Gauss-Legendre nodes and weights with 20 points on -1..1: exact to rounding for arcs up to a half-turn.
def _legendre(n):
    nodes = []
    for i in range(1, n + 1):
        x = math.cos(math.pi * (i - 0.25) / (n + 0.5))
        for _ in range(100):
            p, q = 1.0, 0.0
            for k in range(n):
                p, q = ((2 * k + 1) * x * p - k * q) / (k + 1), p
            slope = n * (x * p - q) / (x * x - 1)
            x -= p / slope
        nodes.append((x, 2 / ((1 - x * x) * slope * slope)))
    return nodes


GAUSS = _legendre(20)


class Segment:
    """Row: a line or an arc in the half-plane, in mm."""

    def __init__(self, row):
        number = lambda key: float(row[key]) if row[key] else None
        self.kind = row["kind"]
        self.start = (number("x_start_mm"), number("r_start_mm"))
        self.end = (number("x_end_mm"), number("r_end_mm"))
        self.center = (number("x_center_mm"), number("r_center_mm"))
        self.radius = number("radius_mm")
        self.sweep = math.radians(number("sweep_deg") or 0.0)

    def points(self):
        """Quadrature points with derivatives with respect to t, and weights over t = 0..1."""
        (x0, r0), (x1, r1) = self.start, self.end
        if self.kind == "arc":
            x, r = self.center
            first = math.atan2(r0 - r, x0 - x)
        for node, weight in GAUSS:
            t = (node + 1) / 2
            if self.kind == "line":
                yield x0 + t * (x1 - x0), r0 + t * (r1 - r0), x1 - x0, r1 - r0, weight / 2
            else:
                u = first + t * self.sweep
                c, s = self.radius * math.cos(u), self.radius * math.sin(u)
                yield x + c, r + s, -s * self.sweep, c * self.sweep, weight / 2

    def volume(self):
        """Contribution to the volume: pi times the integral of r^2 dx."""
        return math.pi * sum(r * r * dx * w for _, r, dx, _, w in self.points())

    def area(self):
        """Area of the surface of revolution."""
        return 2 * math.pi * sum(r * math.hypot(dx, dr) * w for _, r, dx, dr, w in self.points())


def read(path):
    """Segments by component and body, in the order of the file."""
    components = defaultdict(lambda: defaultdict(list))
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            components[row["component"]][row["body"]].append(Segment(row))
    return components


def volume(bodies):
    """Volume of a component, mm^3."""
    return sum(abs(sum(s.volume() for s in body)) for body in bodies.values())


def area(bodies):
    """Area of a component's whole surface, mm^2."""
    return sum(s.area() for body in bodies.values() for s in body)
