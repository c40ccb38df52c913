//! Mathematics without physics, with the same bits on every platform.
//!
//! - [`math`]: the only door to elementary functions (all through `libm`).
//! - [`scalar`]: the small trait over which physics is written once for numbers, lanes and derivatives.
//! - [`ode`]: adaptive Runge-Kutta of order 5(4) and 8(5,3), classical RK4, dense output, located events.
//! - [`fixed_point`]: Anderson acceleration.
//! - [`root`]: bracketed roots and one-dimensional extrema.
//! - [`interp`]: linear, log-linear and Hermite interpolation in one variable.
//! - [`linear`]: symmetric matrices under their skyline, lowest eigenvalue.
//! - [`quadrature`]: Gauss-Legendre integration.
//! - [`stats`]: mean, deviation, percentiles.
//!
//! Deliberately absent: files, clocks, threads, random sources, global state.

pub mod fixed_point;
pub mod interp;
pub mod linear;
pub mod math;
pub mod ode;
pub mod quadrature;
pub mod root;
pub mod scalar;
pub mod stats;
