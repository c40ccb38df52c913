//! Inputs of the mission: planet, atmosphere, wind, entry state, heating, end of the flight, integration.

use super::{Choices, Column, Group, HELD, Input, Kind, Need, OWN_ATMOSPHERE, Preset, Range};
use crate::units::Dimension;

const REPORT_FLIGHT: &str = "NASA/TM-2014-218507, section 3.2";
const RUN_PAGE: &str = "NASA/TM-2014-218507, Appendix D, run page";
const CONVENTION: &str = "convention of this program";

const POSITIVE: Range = Range::above(0.0, 1e30);
/// Below any planet's lowest altitude, m; each has its own limit.
const DEEPEST_M: f64 = -1e6;
/// From an asteroid to a plane, m: altitudes keep two millimetres.
const RADIUS: Range = Range::closed(100.0, 1e13);

pub(super) const INPUTS: &[Input] = &[
    Input::new("entry.planet", "Planet", Group::Models, Kind::Choice(Choices::Planets))
        .preset(Preset::Name("earth-msape"))
        .help("Constants of shape, gravity and rotation.", REPORT_FLIGHT),
    Input::new("entry.atmosphere", "Atmosphere", Group::Models, Kind::Choice(Choices::Atmospheres))
        .preset(Preset::Name(OWN_ATMOSPHERE))
        .help("Density, temperature and pressure against altitude: the planet's own; another planet's is refused.", REPORT_FLIGHT),
    Input::number("entry.altitude_m", "Entry Altitude", Group::Mission, Dimension::Length, Range::closed(DEEPEST_M, 1e9))
        .unit("km")
        .usual(80e3, 200e3)
        .preset(Preset::Number(125_000.0))
        .help("Geodetic altitude at which the flight starts; not below the lowest of the planet.", REPORT_FLIGHT),
    Input::number("entry.radius_m", "Entry Radius", Group::Mission, Dimension::Length, Range::above(0.0, 1e10))
        .unit("km")
        .help("Distance from the centre of the planet at the start, instead of the altitude.", CONVENTION),
    Input::number("entry.latitude_deg", "Entry Latitude", Group::Mission, Dimension::Angle, Range::closed(-90.0, 90.0))
        .unit("deg")
        .preset(Preset::Number(33.0))
        .need(Need::Always)
        .help("Geodetic latitude at the start, north positive.", REPORT_FLIGHT),
    Input::number("entry.longitude_deg", "Entry Longitude", Group::Mission, Dimension::Angle, Range::closed(-360.0, 360.0))
        .unit("deg")
        .preset(Preset::Number(246.3833))
        .need(Need::Always)
        .help("Longitude at the start, east positive.", REPORT_FLIGHT),
    Input::number("entry.speed_m_s", "Entry Velocity", Group::Mission, Dimension::Speed, Range::closed(0.0, 1e5))
        .unit("m/s")
        .usual(10_000.0, 16_000.0)
        .preset(Preset::Number(12_000.0))
        .need(Need::Always)
        .basic()
        .help("Speed at the start, in the frame named by the frame of entry.", RUN_PAGE),
    Input::number("entry.flight_path_angle_deg", "Entry Flight Path Angle", Group::Mission, Dimension::Angle, Range::closed(-90.0, 90.0))
        .unit("deg")
        .usual(-90.0, -1.0)
        .preset(Preset::Number(-8.0))
        .need(Need::Always)
        .basic()
        .help("Angle of the velocity against the geodetic horizon at the start, negative downwards.", RUN_PAGE),
    Input::number("entry.azimuth_deg", "Entry Azimuth", Group::Mission, Dimension::Angle, Range::closed(-360.0, 360.0))
        .unit("deg")
        .preset(Preset::Number(90.0))
        .need(Need::Always)
        .help("Direction of the horizontal velocity at the start, from north, clockwise; not printed in the report, 90 deg is assumed.", CONVENTION),
    Input::new(
        "entry.frame",
        "Frame of Entry",
        Group::Mission,
        Kind::Choice(Choices::Fixed(&[("relative", "Relative to the planet"), ("inertial", "Inertial")])),
    )
    .preset(Preset::Name("relative"))
    .help("Whether speed, angle and azimuth are relative to the rotating planet or inertial, both in the local geodetic horizon.", CONVENTION),
    Input::number("planet.mu_m3_s2", "Gravitational Parameter", Group::Models, Dimension::GravitationalParameter, Range::above(0.0, 1e28))
        .unit("m^3/s^2")
        .aliases(&["planet.mu_m3s2", "planet.gravitational_parameter_m3_s2"])
        .help("Gravitational parameter of a planet given in the case itself.", CONVENTION),
    Input::number("planet.equatorial_radius_m", "Equatorial Radius", Group::Models, Dimension::Length, RADIUS)
        .unit("m")
        .aliases(&["planet.radius_m", "planet.r_equatorial_m"])
        .help("Equatorial radius of a planet given in the case itself; alone it makes a sphere.", CONVENTION),
    Input::number("planet.polar_radius_m", "Polar Radius", Group::Models, Dimension::Length, RADIUS)
        .unit("m")
        .aliases(&["planet.r_polar_m"])
        .help("Polar radius of a planet given in the case itself; the equatorial radius when absent.", CONVENTION),
    Input::number("planet.rotation_rate_rad_s", "Rotation Rate", Group::Models, Dimension::AngularRate, Range::closed(-1.0, 1.0))
        .unit("rad/s")
        .aliases(&["planet.omega_rad_s", "planet.omega_rads"])
        .help("Rate of rotation, eastward positive; zero when absent.", CONVENTION),
    Input::number("planet.j2", "J2", Group::Models, Dimension::One, Range::closed(-1.0, 1.0))
        .help("Zonal coefficient of degree 2; zero when absent.", REPORT_FLIGHT),
    Input::number("planet.j3", "J3", Group::Models, Dimension::One, Range::closed(-1.0, 1.0))
        .help("Zonal coefficient of degree 3; zero when absent.", REPORT_FLIGHT),
    Input::number("planet.j4", "J4", Group::Models, Dimension::One, Range::closed(-1.0, 1.0))
        .help("Zonal coefficient of degree 4; zero when absent.", REPORT_FLIGHT),
    Input::number("planet.j_reference_radius_m", "Reference Radius of J2-J4", Group::Models, Dimension::Length, RADIUS)
        .unit("m")
        .aliases(&["planet.reference_radius_m", "planet.j_ref_radius_m"])
        .help("Radius to which the zonal coefficients belong; the equatorial radius when absent.", CONVENTION),
    Input::number("planet.uniform_gravity_m_s2", "Uniform Gravity", Group::Models, Dimension::Acceleration, Range::closed(0.0, 1e4))
        .unit("m/s^2")
        .aliases(&["planet.gravity_m_s2", "planet.g_m_s2"])
        .help("Gravity of constant magnitude towards the centre, instead of the gravitational parameter.", CONVENTION),
    Input::new(
        "atmosphere.table",
        "Atmosphere Table",
        Group::Models,
        Kind::Rows(&[
            Column { name: "altitude_m", required: true },
            Column { name: "density_kg_m3", required: true },
            Column { name: "temperature_K", required: false },
            Column { name: "pressure_Pa", required: false },
        ]),
    )
    .help("Rows of altitude, density and, if known, temperature and pressure; density is interpolated in its logarithm. Where two of the three are given, the third may be 0 in every row: it is that of the planet's gas.", CONVENTION),
    Input::new("atmosphere.file", "Atmosphere File", Group::Models, Kind::Text)
        .help("Name of a text file with the atmosphere: altitude (geometric, geopotential or of pressure), density or pressure and temperature, in columns with names and units.", CONVENTION),
    Input::new(
        "atmosphere.extrapolation",
        "Beyond the Atmosphere",
        Group::Models,
        Kind::Choice(Choices::Fixed(&[
            ("extend", "Density goes on with its last slope"),
            ("refuse", "Refuse"),
        ])),
    )
    .preset(Preset::Name("extend"))
    .help("Rule beyond the first and the last altitude of the atmosphere, of the case or of the planet; density never grows with height there. Refuse ends the flight there.", CONVENTION),
    Input::number("atmosphere.molar_mass_kg_kmol", "Molar Mass of the Gas", Group::Models, Dimension::MolarMass, Range::closed(1.0, 200.0))
        .unit("kg/kmol")
        .help("Molar mass of the gas of an atmosphere given in the case; that of the planet's gas when absent.", CONVENTION),
    Input::number("atmosphere.heat_capacity_ratio", "Ratio of Heat Capacities", Group::Models, Dimension::One, Range::above(1.0, 1.7))
        .help("Ratio of the heat capacities of the gas of an atmosphere given in the case; that of the planet's gas when absent.", CONVENTION),
    Input::number("atmosphere.exponential.density_kg_m3", "Exponential Atmosphere Density", Group::Models, Dimension::Density, POSITIVE)
        .unit("kg/m^3")
        .help("Density at altitude zero of an exponential atmosphere.", CONVENTION),
    Input::number("atmosphere.exponential.scale_height_m", "Exponential Atmosphere Scale Height", Group::Models, Dimension::Length, Range::above(0.0, 1e7))
        .unit("m")
        .help("Altitude over which the density falls to 1/e.", CONVENTION),
    Input::new(
        "wind.table",
        "Wind Table",
        Group::Models,
        Kind::Rows(&[
            Column { name: "altitude_m", required: true },
            Column { name: "eastward_m_s", required: true },
            Column { name: "northward_m_s", required: true },
        ]),
    )
    .help("Rows of altitude and the velocity of the air towards east and north.", CONVENTION),
    Input::new("wind.file", "Wind File", Group::Models, Kind::Text)
        .help("Name of a text file with the wind: altitude, eastward and northward, or speed and the direction from which it blows.", CONVENTION),
    Input::new(
        "wind.extrapolation",
        "Beyond the Wind Table",
        Group::Models,
        Kind::Choice(Choices::Fixed(HELD)),
    )
    .preset(Preset::Name("hold"))
    .help("Rule beyond the first and the last altitude of the table of wind; refuse ends the flight there.", CONVENTION),
    Input::number("wind.eastward_m_s", "Wind towards East", Group::Models, Dimension::Speed, Range::closed(-500.0, 500.0))
        .unit("m/s")
        .help("Velocity of the air towards the east at every altitude.", CONVENTION),
    Input::number("wind.northward_m_s", "Wind towards North", Group::Models, Dimension::Speed, Range::closed(-500.0, 500.0))
        .unit("m/s")
        .help("Velocity of the air towards the north at every altitude.", CONVENTION),
    Input::new(
        "heating.convective",
        "Convective Heat Rate Model",
        Group::Models,
        Kind::Choice(Choices::Fixed(&[("sutton-graves", "SuttonGraves"), ("brandis-johnston", "BrandisJohnston")])),
    )
    .preset(Preset::Name("sutton-graves"))
    .basic()
    .help("Relation for convective heating at the stagnation point.", RUN_PAGE),
    Input::new(
        "heating.radiative",
        "Radiative Heat Rate Model",
        Group::Models,
        Kind::Choice(Choices::Fixed(&[("tauber-sutton", "TauberSutton"), ("brandis-johnston", "BrandisJohnston"), ("none", "None")])),
    )
    .preset(Preset::Name("tauber-sutton"))
    .basic()
    .help("Relation for radiative heating at the stagnation point.", RUN_PAGE),
    Input::number("heating.convective_margin", "Convective Heat Rate Margin", Group::Margins, Dimension::One, Range::closed(0.0, 10.0))
        .usual(0.0, 10.0)
        .preset(Preset::Number(1.3))
        .basic()
        .help("Factor on convective heating chosen by the designer; results say whether they carry it.", RUN_PAGE),
    Input::number("heating.radiative_margin", "Radiative Heat Rate Margin", Group::Margins, Dimension::One, Range::closed(0.0, 10.0))
        .usual(0.0, 2.0)
        .preset(Preset::Number(1.0))
        .basic()
        .help("Factor on radiative heating chosen by the designer; results say whether they carry it.", RUN_PAGE),
    Input::number("heating.convective_model_factor", "Convective Model Factor", Group::Models, Dimension::One, Range::above(0.0, 10.0))
        .usual(1.0, 1.5)
        .preset(Preset::Number(1.0))
        .help("Correction of the convective relation itself, apart from the margin and not of heat fluxes that the case gives; the report's comparison with DPLR gives 1.33.", "NASA/TM-2014-218507, section 3.4.3"),
    Input::new(
        "heating.wall",
        "Wall for Convective Heating",
        Group::Models,
        Kind::Choice(Choices::Fixed(&[("cold", "Cold wall"), ("radiative-equilibrium", "Hot wall in radiative equilibrium")])),
    )
    .preset(Preset::Name("cold"))
    .help("Whether convective heating is that of a cold wall, or is lowered by the enthalpy of a wall in radiative equilibrium.", CONVENTION),
    Input::number("heating.wall_emissivity", "Wall Emissivity", Group::Models, Dimension::One, Range::above(0.0, 1.0))
        .usual(0.5, 1.0)
        .preset(Preset::Number(0.85))
        .help("Emissivity of the wall for its radiative-equilibrium temperature.", "NASA/TM-2014-218507, section 3.4.2"),
    Input::new(
        "heating.stagnation_pressure",
        "Stagnation Pressure",
        Group::Models,
        Kind::Choice(Choices::Fixed(&[
            ("newtonian-limit", "Newtonian limit, twice the dynamic pressure"),
            ("equation-9", "Equation 9, fit to Navier-Stokes results"),
            ("perfect-gas", "Perfect gas, equations 10 to 12"),
        ])),
    )
    .preset(Preset::Name("newtonian-limit"))
    .help("How the pressure at the stagnation point is found, which loads the walls and is held against the limits of the heat shield; the Newtonian limit bounds the others.", "NASA/TM-2014-218507, equations 9 to 12"),
    Input::new(
        "heating.judged_at",
        "Heat Shield Judged at",
        Group::Models,
        Kind::Choice(Choices::Fixed(&[
            ("hottest-point", "Hottest point of each part, shoulder included"),
            ("stagnation-point", "Stagnation point"),
        ])),
    )
    .preset(Preset::Name("hottest-point"))
    .help("Where heat flux and heat load are taken for the thickness of the forebody's heat shield and for its limits; the report's relations took those of the stagnation point.", "NASA/TM-2014-218507, sections 3.4.3 and 3.5"),
    Input::number("stop.altitude_m", "Final Altitude", Group::Mission, Dimension::Length, Range::closed(DEEPEST_M, 1e7))
        .unit("m")
        .usual(-500.0, 5_000.0)
        .help("Geodetic altitude at which a falling vehicle ends its flight, not below the lowest of the planet; 0 m when nothing else ends it.", CONVENTION),
    Input::number("stop.time_s", "Final Time", Group::Mission, Dimension::Time, Range::above(0.0, 1e7))
        .unit("s")
        .help("Time after the start at which the flight ends; a vehicle that leaves the atmosphere on a bound orbit flies on until then.", CONVENTION),
    Input::number("stop.passes", "Passes", Group::Mission, Dimension::One, Range::closed(1.0, 1000.0))
        .whole()
        .help("Number of passes through the atmosphere after which leaving it ends the flight; when absent the first, or with a final time none: a vehicle on a bound orbit flies on to its next entry.", CONVENTION),
    Input::number("solver.tolerance", "Integration Tolerance", Group::Solver, Dimension::One, Range::closed(1e-13, 1e-2))
        .help("Relative error allowed in one step; when absent, chosen so that peak deceleration and heat load are good to 1e-5.", CONVENTION),
    Input::new(
        "solver.method",
        "Integration Method",
        Group::Solver,
        Kind::Choice(Choices::Fixed(&[
            ("dormand-prince-54", "Runge-Kutta of order 5(4), adaptive"),
            ("dormand-prince-853", "Runge-Kutta of order 8(5,3), adaptive"),
            ("rk4", "Classical Runge-Kutta of order 4, fixed step"),
        ])),
    )
    .preset(Preset::Name("dormand-prince-54"))
    .help("Method that integrates the equations of motion.", "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I"),
    Input::new(
        "solver.flight_model",
        "Flight Model",
        Group::Solver,
        Kind::Choice(Choices::Fixed(&[
            ("three-dof", "Three degrees of freedom, integrated"),
            ("allen-eggers", "Closed form of Allen and Eggers"),
        ])),
    )
    .preset(Preset::Name("three-dof"))
    .help("High- or low-fidelity model of the flight.", "NASA/TM-2014-218507, section 2.2"),
    Input::number("solver.step_s", "Integration Step", Group::Solver, Dimension::Time, Range::closed(1e-4, 10.0))
        .unit("s")
        .preset(Preset::Number(0.05))
        .help("Step of the classical Runge-Kutta method.", CONVENTION),
];
