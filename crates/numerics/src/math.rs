//! Elementary functions, all through `libm`: the same bits natively and in the browser.
//!
//! `sqrt` and `abs` of the standard library are exact everywhere and may be used directly.

/// π.
pub const PI: f64 = core::f64::consts::PI;
/// π/2.
pub const FRAC_PI_2: f64 = core::f64::consts::FRAC_PI_2;
/// Radians in a degree.
pub const RADIANS_PER_DEGREE: f64 = PI / 180.0;

macro_rules! unary {
    ($($name:ident = $libm:ident : $doc:literal;)*) => {$(
        #[doc = $doc]
        #[inline]
        pub fn $name(x: f64) -> f64 {
            libm::$libm(x)
        }
    )*};
}

unary! {
    sin = sin: "Sine of `x`, rad.";
    cos = cos: "Cosine of `x`, rad.";
    tan = tan: "Tangent of `x`, rad.";
    asin = asin: "Arc sine, rad.";
    acos = acos: "Arc cosine, rad.";
    atan = atan: "Arc tangent, rad.";
    sinh = sinh: "Hyperbolic sine.";
    cosh = cosh: "Hyperbolic cosine.";
    tanh = tanh: "Hyperbolic tangent.";
    exp = exp: "Exponential function.";
    ln = log: "Natural logarithm.";
    log10 = log10: "Logarithm to base 10.";
    cbrt = cbrt: "Cube root.";
    erf = erf: "Error function.";
}

/// Angle of the point (`x`, `y`), rad, in −π…π.
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// `x` to the power `y`.
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Length of the vector (`x`, `y`).
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

/// Sine and cosine of `x`, rad.
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// `x` to a whole power, by repeated multiplication in a fixed order.
#[inline]
pub fn powi(x: f64, n: u32) -> f64 {
    let (mut result, mut base, mut n) = (1.0, x, n);
    while n > 0 {
        if n & 1 == 1 {
            result *= base;
        }
        base *= base;
        n >>= 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_to_the_tenth_is_1024() {
        assert_eq!(powi(2.0, 10), 1024.0);
        assert_eq!(powi(3.0, 0), 1.0);
    }

    #[test]
    fn one_degree_is_pi_over_180() {
        assert_eq!(RADIANS_PER_DEGREE * 180.0, PI);
    }
}
