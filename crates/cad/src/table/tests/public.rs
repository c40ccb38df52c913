//! Layouts of public files, each with a few lines of our own data; `docs/faults.md` names the files.

use super::*;

/// A listing in fixed columns without wind on most levels, as from the University of Wyoming.
#[test]
fn blanks_in_fixed_columns_leave_the_other_cells_in_their_places() {
    let listing = "
-----------------------------------------------------
   PRES   HGHT   TEMP   DWPT   DRCT   SKNT   THTA
    hPa     m      C      C     deg   knot     K
-----------------------------------------------------
 1000.0    -12
  900.0    990   10.0    2.0    270     10  291.8
  700.0   3010    0.0   -9.0                303.2
  500.0   5570  -20.0  -35.0                308.6
  300.0   9160  -45.0  -55.0                321.8
  200.0  11770  -55.0
";
    let table = air(listing);
    // 50000 / (287.05287 × 253.15) = 0.68806; 6356766 × 5570 / (6356766 − 5570) = 5574.885
    assert_eq!(table.rows.len(), 5, "{table:?}");
    assert!((table.rows[2][0] - 5574.885).abs() < 1e-3, "{table:?}");
    assert!((table.rows[2][1] - 0.68806).abs() < 1e-5, "{table:?}");
    let wind = read(&input::wind::FILE, listing.as_bytes(), &earth()).unwrap();
    assert_eq!(wind.rows.len(), 1);
    // names and numbers aligned at their first characters
    let left =
        "z_m    x     rho_kgm3\n0      1     1.225\n5000         0.7361\n10000        0.4135\n";
    same(&air(left).rows, &AIR);
}

/// An extra tab in the first row; a heading with commas, tabs and blanks; static values beside dynamic ones; falling
/// altitudes.
#[test]
fn atmospheres_in_the_headings_of_public_files() {
    let whole: [&[f64]; 3] = [
        &[0.0, 1.225, 288.15, 101_325.0],
        &[5e3, 0.7361, 255.65, 54_048.0],
        &[1e4, 0.4135, 223.15, 26_499.0],
    ];
    for text in [
        "#Z(m)\tTemp(K)\tPres (Nm2)\trho(kgm3)\ta (m/s)\n0\t\t288.15\t1.01325E+05\t1.225E+00\t340.3\n5000\t255.65\t5.4048E+04\t7.361E-01\t320.5\n10000\t223.15\t2.6499E+04\t4.135E-01\t299.5\n",
        "#h,m\tT, k    P, N/m2\t\trho, kg/m3\t\ta, m/s\n0\t\t288.15\t1.01325E+05\t1.225E+00\t340.3\n5000\t255.65\t5.4048E+04\t7.361E-01\t320.5\n10000\t223.15\t2.6499E+04\t4.135E-01\t299.5\n",
        "Altitude [m];Velocity [m/s];Temperature [K];Static Pressure [Pa];Static Density [kg/m^3];Dynamic Pressure [Pa];\n0;1;288.15;101325;1.225;0.6;\n5000;2;255.65;54048;0.7361;2.4;\n10000;3;223.15;26499;0.4135;5.5;\n",
        "# from a probe\n#Z(km)\tT(K)\tP (N/m2)\trho(kg/m3)\ta (m/s)\n10.00\t223.15\t2.6499E+04\t4.135E-01\t299.5\n5.00\t255.65\t5.4048E+04\t7.361E-01\t320.5\n0.00\t288.15\t1.01325E+05\t1.225E+00\t340.3",
    ] {
        same(&air(text).rows, &whole);
    }
}

/// Altitude in km and in ft, temperature in R and in K.
#[test]
fn a_quantity_in_two_units_is_read_once_and_compared() {
    let text = "Altitude (km)\tAltitude (ft)\ttemp ®\ttemp (K)\tdens (s/cu.ft)\tdens (kg/cu.m)\n0\t0\t518.67\t288.15\t0.002377\t1.2250\n5\t16,404\t460.17\t255.65\t0.001428\t0.7361\n10\t32,808\t401.67\t223.15\t0.000802\t0.4135\n";
    let table = air(text);
    same(&table.rows, &WARM_AIR);
    let told = table.remarks.join("\n");
    assert!(
        told.contains("altitude stands in several columns, of which \"Altitude (km)\" is read"),
        "{told}"
    );
    let crooked = text.replace("32,808", "23,808");
    let said = faults(&input::atmosphere::FILE, &crooked).join("\n");
    assert!(
        said.starts_with("line 4: altitude is 10000 in column 1 and 7256.6784"),
        "{said}"
    );
}

#[test]
fn what_has_no_unit_and_is_not_in_that_taken_is_refused() {
    let said = |text: &str| faults(&input::atmosphere::FILE, text).join("\n");
    let km = said(
        "alt,temp,press,dens\n0,288.1,101325,1.225\n5,255.7,54048,0.736\n10,223.3,26499,0.414\n",
    );
    assert!(
        km.starts_with(
            "header: the altitude has no unit and is no m: density would be 3.0 times less 10 m higher"
        ),
        "{km}"
    );
    let celsius = said("HGHT,PRES,TEMP\n0,101325,15.0\n5000,54048,-17.5\n");
    assert!(
        celsius.starts_with("line 3: the heading names no unit for temperature, and -17.5 is no temperature there in K"),
        "{celsius}"
    );
    let hecto = said("HGHT,PRES,TEMP (C)\n0,1013.25,15.0\n5000,540.48,-17.5\n");
    assert!(
        hecto.starts_with("line 2: the heading names no unit for pressure, and 1013.25 is no pressure there in Pa; name its unit, pressure_hPa"),
        "{hecto}"
    );
}

/// Altitude, temperature, pressure, density without a heading: the second column is not density.
#[test]
fn columns_in_another_order_are_not_taken_for_density() {
    let said = |text: &str| faults(&input::atmosphere::FILE, text).join("\n");
    let warm = said(
        "0\t288.15\t1.01325\t1.225\n40000\t250.35\t0.00287\t0.003996\n80000\t198.64\t1.05e-5\t1.85e-5\n",
    );
    assert!(
        warm.starts_with("line 1: the second column is 288.15, which is no density"),
        "{warm}"
    );
    let pressed = said("0,101325,1.225\n1000,89876,1.1117\n");
    assert!(pressed.contains("the second column is 101325"), "{pressed}");
}

/// A title above the heading that ends in a number.
#[test]
fn a_title_with_a_number_is_no_row() {
    let text = "Title,columns\nCapsule at Mach 5,16\nMach,ALFA,CA,CN\n5,0,1.5,0\n5,10,1.4,0.1\n";
    let table = read(
        &input::vehicle::AERODYNAMICS_FILE,
        text.as_bytes(),
        &earth(),
    )
    .unwrap();
    assert_eq!(table.rows, [[5.0, 0.0, 1.5, 0.0], [5.0, 10.0, 1.4, 0.1]]);
}

/// In an export of RASAero II, CD at every angle is that at 0 deg: CA and CN are used.
#[test]
fn axial_force_without_thrust_counts_above_a_drag_that_does_not_change_with_the_angle() {
    let text = "Mach,Alpha,CD,CD Power-Off,CD Power-On,CA Power-Off,CA Power-On,CL,CN,CP\n0.5,0,0.34,0.34,0.30,0.34,0.30,0,0,54\n0.5,4,0.34,0.41,0.37,0.35,0.31,0.89,0.92,54\n";
    let table = read(
        &input::vehicle::AERODYNAMICS_FILE,
        text.as_bytes(),
        &earth(),
    )
    .unwrap();
    assert_eq!(table.rows, [[0.5, 0.0, 0.34, 0.0], [0.5, 4.0, 0.35, 0.92]]);
}

#[test]
fn a_table_without_mach_number_counts_at_every_one() {
    let text = " alpha[deg], CL, CD\n 0.0 , 0.0 , 1.0\n 90.0 , -0.2 , 0.5\n";
    let table = read(
        &input::vehicle::AERODYNAMICS_FILE,
        text.as_bytes(),
        &earth(),
    )
    .unwrap();
    assert_eq!(table.rows.len(), 4);
    assert_eq!((table.rows[0][0], table.rows[3][0]), (0.0, 1000.0));
    assert!(table.remarks.join("\n").contains("without a Mach number"));
}

#[test]
fn angles_below_zero_may_end_before_those_above() {
    let rows = "0.3,-10,-0.70,0.60\n0.3, 0, 0.00,0.10\n0.3, 10, 0.70,0.60\n0.3, 15, 1.05,1.13\n";
    let text = format!("mach,alpha,cl,cd\n{rows}");
    let table = read(
        &input::vehicle::AERODYNAMICS_FILE,
        text.as_bytes(),
        &earth(),
    )
    .unwrap();
    let angles: Vec<f64> = table.rows.iter().map(|row| row[1]).collect();
    assert_eq!(angles, [0.0, 10.0, 15.0]);
    let crooked = text.replace("-0.70,0.60", "-0.50,0.60");
    let said = faults(&input::vehicle::AERODYNAMICS_FILE, &crooked).join("\n");
    assert!(said.contains("a body of revolution is symmetric"), "{said}");
}

/// 2 and 10 deg in rad.
#[test]
fn whole_degrees_in_radians_are_told() {
    let text = "mach,TotalAOA,CD,CL\n1,0,0.21,0\n1,0.034906585,0.23,0.24\n1,0.174532925,0.48,1.6\n";
    let said = faults(&input::vehicle::AERODYNAMICS_FILE, text).join("\n");
    assert!(said.contains("a whole number of deg in rad"), "{said}");
    let degrees = text
        .replace("0.034906585", "2")
        .replace("0.174532925", "10");
    assert!(
        read(
            &input::vehicle::AERODYNAMICS_FILE,
            degrees.as_bytes(),
            &earth()
        )
        .is_ok()
    );
}

#[test]
fn several_curves_of_drag_are_not_made_one() {
    let said = |text: &str| faults(&input::vehicle::DRAG_FILE, text);
    let brakes =
        "deployment_level, mach, cd\n0, 0.1, 0.77\n1.0, 0.1, 1.10\n0, 0.2, 0.75\n1.0, 0.2, 0.99\n";
    assert_eq!(
        said(brakes),
        [
            "line 2: at mach 0.1 cd goes from 0.77 to 1.1, and the columns left out tell its rows apart: \"deployment_level\"; keep the rows of one curve"
        ]
    );
    // up and down again, as along a flight
    let flight = "0.1,0.5\n0.5,0.4\n0.9,0.6\n0.8,0.5\n0.6,0.45\n0.4,0.5\n0.2,0.55\n0.05,0.6\n";
    assert_eq!(said(flight).len(), 1);
    assert!(said(flight)[0].starts_with("line 4: mach falls here and in 4 more lines"));
}
