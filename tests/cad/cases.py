"""Cases to export: shipped cases, designs sampled over the trade space, outlines."""

SHIPPED = ["msr-eev-pica", "msr-eev-cp", "galahad", "run-page"]

# Six closed designs of each concept are needed; this is the largest number of samples tried.
SAMPLES = 200
WANTED = 6


def sampled():
    """Settings over the trade space, from a portable pseudo-random generator (Park and Miller)."""
    state = 20141

    def uniform(low, high):
        nonlocal state
        state = state * 48271 % 2147483647
        return low + (high - low) * state / 2147483647

    for number in range(SAMPLES):
        settings = {
            "design.msr_mode": "true" if number % 2 else "false",
            "design.diameter_m": uniform(0.5, 2.0),
            "design.payload_mass_kg": uniform(5.0, 30.0),
            "design.nose_radius_ratio": uniform(0.25, 0.9),
            "design.shoulder_radius_ratio": uniform(0.02, 0.1),
            "design.payload_diameter_ratio": "",
            "design.payload_density_kg_m3": uniform(1500.0, 6000.0),
        }
        yield number, [f"{key}={value}" for key, value in settings.items()]


def _points(rows):
    return "schema = \"msape/1\"\n[outline]\npoints = [" + ", ".join(str(row) for row in rows) + "]\n"


def _shape(**keys):
    lines = [f"{key} = {value!r}".replace("'", '"') for key, value in keys.items()]
    return "schema = \"msape/1\"\n[outline]\n" + "\n".join(lines) + "\n"


PRESETS = ["apollo", "genesis", "hayabusa", "sphere-cone-45", "sphere-cone-60", "sphere-cone-70", "stardust"]

OUTLINES = {
    **{name: _shape(preset=name) for name in PRESETS},
    "sphere-cone-flat": _shape(
        cone_half_angle_deg=60.0, diameter_m=1.0, nose_radius_m=0.25, shoulder_radius_m=0.05, aft="flat"
    ),
    "sphere-cone-mmeev": _shape(
        cone_half_angle_deg=45.0, diameter_m=1.5, nose_radius_m=0.3, shoulder_radius_m=0.03, aft="mmeev"
    ),
    "sharp-edges": _shape(
        cone_half_angle_deg=70.0, diameter_m=2.0, nose_radius_m=0.0, shoulder_radius_m=0.0, aft="flat"
    ),
    # arcs whose circle crosses the axis: an ogive (its outer part is revolved), a bulging disc, a sphere
    "ogive": _points([[0.0, 0.0, -0.2], [1.0, 0.4, 0.0], [1.0, 0.0, 0.0]]),
    "apple": _points([[0.0, 0.0, 0.0], [0.0, 0.2, -1.3], [0.5, 0.2, 0.0], [0.5, 0.0, 0.0]]),
    "ball": _points([[-0.5, 0.0, -1.0], [0.5, 0.0, 0.0]]),
    # a waist, and a cylinder
    "waist": _points([[0.0, 0.0, -0.4], [0.3, 0.4, 0.5], [0.9, 0.4, 0.0], [1.4, 0.4, 0.0], [1.4, 0.0, 0.0]]),
}
