"""Exports vehicles with the command `msape`, reads the files back with other programs, and compares.

    python check.py PROGRAM ROOT FOLDER

PROGRAM is the command, ROOT the repository, FOLDER takes the files.
"""

import json
import math
import struct
import subprocess
import sys
from collections import Counter
from pathlib import Path

import ezdxf

import cases
import profile
import step

# OpenCASCADE integrates to 1e-9 on request; the files have full precision.
VOLUME_TOLERANCE = 1e-8
AREA_TOLERANCE = 1e-6
# Chord error of 1e-4 of the diameter, along and around, on a wall of area A: the volume error is at most their product.
CHORD_OVER_DIAMETER = 1e-4


class Checks:
    """Counts passed checks and collects failures."""

    def __init__(self):
        self.held = 0
        self.faults = []

    def that(self, holds, message):
        if holds:
            self.held += 1
        else:
            self.faults.append(message)
            print(f"  FAULT {message}")

    def near(self, got, want, tolerance, message):
        error = abs(got - want) / abs(want)
        self.that(error <= tolerance, f"{message}: {got!r}, must be {want!r} to {tolerance:g}")
        return error


def export(program, folder, name, case, formats, settings=()):
    """Writes the files; None if there is no vehicle."""
    options = [word for setting in settings for word in ("--set", setting)]
    files = {}
    for kind in formats:
        files[kind] = folder / f"{name}.{kind}"
        command = [program, "export", case, *options, "--format", kind, "-o", files[kind]]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode == 2 and "there is no vehicle" in done.stderr:
            return None
        assert done.returncode == 0, done.stderr
    return files


def component_of(part):
    """Component of a part: bodies of one component are numbered."""
    return part.name.rstrip("0123456789").strip().lower().replace(" ", "-")


def check_step(checks, name, path, components):
    """Checks that every part is a valid solid with the volume of its profiles; returns the largest error."""
    title, parts = step.read(path)
    checks.that(title != "", f"{name}: the assembly has no name")
    keys = list(dict.fromkeys(map(component_of, parts)))
    checks.that(keys == [key for key in components if key != "outline"], f"{name}: parts {keys}")
    worst = 0.0
    for part in parts:
        what = f"{name}: {part.name}"
        checks.that(part.solids == 1, f"{what}: {part.solids} solids")
        checks.that(part.valid and part.closed, f"{what}: valid {part.valid}, closed {part.closed}")
        odd = set(part.surfaces) - step.ANALYTIC
        checks.that(not odd, f"{what}: surfaces {odd}")
        checks.that(part.color, f"{what}: no colour")
    for key in keys:
        bodies, own = components.get(key, {}), [part for part in parts if component_of(part) == key]
        checks.that(len(own) == len(bodies), f"{name}: {key}: {len(own)} solids of {len(bodies)} profiles")
        for part, body in zip(own, bodies.values()):
            want = {1: body}
            error = checks.near(part.volume, profile.volume(want), VOLUME_TOLERANCE, f"{name}: {part.name}: volume")
            checks.near(part.area, profile.area(want), AREA_TOLERANCE, f"{name}: {part.name}: area")
            worst = max(worst, error)
    return worst, parts


def check_masses(checks, name, program, case, settings, parts):
    """Checks that volume times density of each part is the mass printed by `design`."""
    options = [word for setting in settings for word in ("--set", setting)]
    done = subprocess.run([str(program), "design", str(case), *options, "--json"], capture_output=True, text=True, check=True)
    results = json.loads(done.stdout)["results"]
    masses_kg = Counter()
    for part in parts:
        checks.that(part.material not in (None, ""), f"{name}: {part.name}: no material")
        masses_kg[component_of(part)] += part.volume * 1e-9 * (part.density_kg_m3 or math.nan)
    for component, mass_kg in masses_kg.items():
        key = component.replace("-", "_") + "_mass_kg"
        checks.near(mass_kg, results[key], VOLUME_TOLERANCE, f"{name}: {key}")


def check_iges(checks, name, path, components):
    """Checks that each segment gives one surface, not a spline, with the area of the profiles."""
    kinds, area = step.read_iges(path)
    parts = {key: bodies for key, bodies in components.items() if key != "outline"}
    count = sum(len(body) for bodies in parts.values() for body in bodies.values())
    checks.that(len(kinds) == count, f"{name}: IGES has {len(kinds)} surfaces of {count} segments")
    odd = set(kinds) - step.ANALYTIC - {"SurfaceOfRevolution"}
    checks.that(not odd, f"{name}: IGES surfaces {odd}")
    checks.near(area, sum(map(profile.area, parts.values())), AREA_TOLERANCE, f"{name}: IGES area")


def check_stl(checks, name, path, outline):
    """Checks that every edge is shared by two triangles in opposite directions, and the volume."""
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0]
    checks.that(len(data) == 84 + 50 * count, f"{name}: STL has {len(data)} bytes for {count} triangles")
    edges, volume = Counter(), 0.0
    for i in range(count):
        numbers = struct.unpack_from("<9f", data, 84 + 50 * i + 12)
        a, b, c = numbers[0:3], numbers[3:6], numbers[6:9]
        for edge in ((a, b), (b, c), (c, a)):
            edges[edge] += 1
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    tight = all(n == 1 and edges[(b, a)] == 1 for (a, b), n in list(edges.items()))
    checks.that(tight, f"{name}: STL is not watertight")
    width = 2 * max(r for body in outline.values() for s in body for _, r, _, _, _ in s.points())
    miss = 2 * CHORD_OVER_DIAMETER * 1.01 * width * profile.area(outline)
    checks.that(
        abs(volume / 6 - profile.volume(outline)) <= miss, f"{name}: STL volume {volume / 6}, not {profile.volume(outline)}"
    )


def check_dxf(checks, name, path, components):
    """Checks that the audit has no errors and that lines and arcs are those of the CSV."""
    drawing = ezdxf.readfile(path)
    audit = drawing.audit()
    checks.that(not audit.errors and not audit.fixes, f"{name}: DXF {audit.errors} {audit.fixes}")
    checks.that(drawing.units == 4, f"{name}: DXF unit {drawing.units}")
    lengths = {}
    for entity in drawing.modelspace():
        if entity.dxftype() == "LINE":
            length = entity.dxf.start.distance(entity.dxf.end)
        else:
            length = math.radians((entity.dxf.end_angle - entity.dxf.start_angle) % 360) * entity.dxf.radius
        lengths[entity.dxf.layer] = lengths.get(entity.dxf.layer, 0.0) + length
    for key, bodies in components.items():
        want = sum(math.hypot(dx, dr) * w for b in bodies.values() for s in b for _, _, dx, dr, w in s.points())
        checks.near(lengths.get(key, 0.0), want, 1e-9, f"{name}: DXF layer {key}")


FORMATS = ["step", "iges", "stl", "gltf", "glb", "dxf", "csv"]


def check(checks, program, folder, name, case, settings=(), designed=True):
    """Checks all formats of one vehicle; False if there is no vehicle."""
    files = export(program, folder, name, case, FORMATS, settings)
    if files is None:
        return False
    components = profile.read(files["csv"])
    worst, parts = check_step(checks, name, files["step"], components)
    if designed:
        check_masses(checks, name, program, case, settings, parts)
    check_iges(checks, name, files["iges"], components)
    check_stl(checks, name, files["stl"], components["outline"])
    check_dxf(checks, name, files["dxf"], components)
    print(f"{name}: {len(parts)} solids, largest error of a volume {worst:.1e}", flush=True)
    return True


def main():
    program, root, folder = (Path(argument).resolve() for argument in sys.argv[1:4])
    folder.mkdir(parents=True, exist_ok=True)
    checks = Checks()
    for name in cases.SHIPPED:
        checks.that(check(checks, program, folder, name, root / f"cases/{name}.toml"), f"{name}: no vehicle")
    closed = Counter()
    for number, settings in cases.sampled():
        concept = number % 2
        if closed[concept] >= cases.WANTED:
            continue
        case = root / "cases/run-page.toml"
        closed[concept] += check(checks, program, folder, f"sample-{number}", case, settings)
    for concept in (0, 1):
        checks.that(closed[concept] == cases.WANTED, f"only {closed[concept]} sampled designs closed")
    for name, text in cases.OUTLINES.items():
        case = folder / f"{name}.toml"
        case.write_text(text, encoding="utf-8")
        checks.that(check(checks, program, folder, name, case, designed=False), f"{name}: no outline")
    print(f"{checks.held} checks held, {len(checks.faults)} did not")
    return 1 if checks.faults else 0


if __name__ == "__main__":
    sys.exit(main())
