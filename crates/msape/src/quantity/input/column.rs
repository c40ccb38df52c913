//! Columns of the tables of a case.

use super::Range;

/// A column of an input table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Name with unit, such as `altitude_m`.
    pub name: &'static str,
    /// Whether every row must contain it.
    pub required: bool,
    /// Allowed range of the values.
    pub allowed: Range,
}

impl Column {
    /// This column as one that rows may omit.
    pub(super) const fn optional(self) -> Column {
        Column {
            required: false,
            ..self
        }
    }
}

/// Declares the columns, each by its name and the range of its cells; the signs of attitude and the like are free.
macro_rules! columns {
    ($($column:ident = $name:literal, $min:literal, $max:literal;)+) => {
        $(
            #[doc = concat!("`", $name, "`.")]
            pub const $column: Column = Column {
                name: $name,
                required: true,
                allowed: Range::closed($min, $max),
            };
        )+
    };
}

columns! {
    ALTITUDE_M = "altitude_m", -1e6, 1e9;
    // Zero is open: the other two of density, temperature and pressure give it, or the row is refused.
    DENSITY_KG_M3 = "density_kg_m3", 0.0, 1e4;
    TEMPERATURE_K = "temperature_K", 0.0, 1e5;
    PRESSURE_PA = "pressure_Pa", 0.0, 1e12;
    EASTWARD_M_S = "eastward_m_s", -2e3, 2e3;
    NORTHWARD_M_S = "northward_m_s", -2e3, 2e3;
    MACH = "mach", 0.0, 1e3;
    SPEED_M_S = "speed_m_s", 0.0, 1e5;
    TIME_S = "time_s", -1e7, 1e7;
    // Zero means none, if the altitude is given instead.
    KNUDSEN = "knudsen", 0.0, 1e12;
    ALPHA_DEG = "alpha_deg", -180.0, 180.0;
    BANK_DEG = "bank_deg", -36_000.0, 36_000.0;
    P_DEG_S = "p_deg_s", -36_000.0, 36_000.0;
    Q_DEG_S = "q_deg_s", -36_000.0, 36_000.0;
    R_DEG_S = "r_deg_s", -36_000.0, 36_000.0;
    CA = "ca", -100.0, 100.0;
    CN = "cn", -100.0, 100.0;
    CM = "cm", -100.0, 100.0;
    CMQ = "cmq", -100.0, 100.0;
    LIFT_COEFFICIENT = "lift_coefficient", -100.0, 100.0;
    DRAG_COEFFICIENT = "drag_coefficient", 0.0, 100.0;
    CONVECTIVE_W_M2 = "convective_w_m2", 0.0, 1e12;
    RADIATIVE_W_M2 = "radiative_w_m2", 0.0, 1e12;
    RADIUS_FRACTION = "radius_fraction", 0.0, 1.0;
    ARC_FRACTION = "arc_fraction", 0.0, 1.0;
    X_M = "x_m", -1e4, 1e4;
    Y_M = "y_m", -1e4, 1e4;
    Z_M = "z_m", -1e4, 1e4;
    R_M = "r_m", -1e4, 1e4;
    DEPTH_M = "depth_m", 0.0, 100.0;
    // Seconds, pascals ... as the interchange of heat-shield environments names them.
    T_S = "t_s", -1e7, 1e7;
    P_PA = "p_Pa", 0.0, 1e9;
    CH_KG_M2S = "CH_kg_m2s", 0.0, 1e4;
    H_R_J_KG = "h_r_J_kg", -1e8, 1e10;
    Q_RAD_W_M2 = "q_rad_W_m2", 0.0, 1e12;
    CHEMISTRY = "chemistry", 0.0, 1.0;
    T_K = "T_K", 1.0, 1e5;
    RECESSION_M_S = "recession_m_s", 0.0, 1.0;
    BULGE = "bulge", -1e9, 1e9;
    // Elements of inertia, kg-m², and of a quaternion.
    W = "w", -1e9, 1e9;
    X = "x", -1e9, 1e9;
    Y = "y", -1e9, 1e9;
    Z = "z", -1e9, 1e9;
}
