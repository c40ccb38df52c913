//! Outlines with known coefficients.

use msape::vehicle::forebody::Forebody;
use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI, RADIANS_PER_DEGREE, atan2, cos, sin, tan};

fn at(x_m: f64, r_m: f64) -> Point {
    Point { x_m, r_m }
}

/// Radius of the lid of the back called `mmeev`, relative to that of the body.
const LID: f64 = 0.6;

/// Sphere-cone of diameter 2 with a half torus as shoulder, and its back: flat, or a cone of 15 deg with a lid.
pub fn sphere_cone(
    half_angle_deg: f64,
    nose: f64,
    shoulder: f64,
    lid_center: Option<f64>,
) -> Profile {
    let theta = half_angle_deg * RADIANS_PER_DEGREE;
    let body = Forebody {
        diameter_m: 2.0,
        nose_radius_m: nose,
        shoulder_radius_m: shoulder,
        cone_half_angle_rad: theta,
    };
    let center = body.shoulder_center();
    let arc = Segment::arc(center, shoulder, FRAC_PI_2 + theta, -(FRAC_PI_2 + theta));
    let rim = at(center.x_m + shoulder, center.r_m);
    let tip = Profile {
        segments: vec![Segment::Line {
            start: Point::default(),
            end: body.shoulder_tangent(0.0),
        }],
    };
    let nose = if nose > 0.0 {
        body.nose(0.0).line_to(body.shoulder_tangent(0.0))
    } else {
        tip
    };
    let front = nose.then(&Profile {
        segments: vec![arc],
    });
    let Some(x_lid) = lid_center else {
        return front.line_to(Point::on_axis(rim.x_m)).closed();
    };
    // (a − slope r)² + r² = 0.36, the distance of the cone from the center of the lid
    let slope = tan(15.0 * RADIANS_PER_DEGREE);
    let a = rim.x_m + slope * rim.r_m - x_lid;
    let (qa, qb, qc) = (1.0 + slope * slope, -2.0 * a * slope, a * a - LID * LID);
    let root = qb * qb - 4.0 * qa * qc;
    if root < 0.0 {
        return front.line_to(Point::on_axis(x_lid + a)).closed();
    }
    let r = (-qb + root.sqrt()) / (2.0 * qa);
    let foot = at(rim.x_m + slope * (rim.r_m - r), r);
    let start = atan2(foot.r_m, foot.x_m - x_lid);
    let lid = Segment::arc(Point::on_axis(x_lid), LID, start, -start);
    let back = front.line_to(foot).then(&Profile {
        segments: vec![lid],
    });
    back.closed()
}

/// A sphere of diameter 2.
pub fn sphere() -> Profile {
    let arc = Segment::arc(Point::on_axis(1.0), 1.0, PI, -PI);
    let half = Profile {
        segments: vec![arc],
    };
    half.closed()
}

/// Nose, optional cone, and shoulder; a nose larger than the cone meets the shoulder tangentially.
pub fn sphere_cone_or_cap(body: &Forebody) -> Profile {
    let theta = body.cone_half_angle_rad;
    let edge = 1.0 - body.shoulder_radius_m + body.shoulder_radius_m * cos(theta);
    if body.nose_radius_m * cos(theta) <= edge {
        return sphere_cone(
            theta / RADIANS_PER_DEGREE,
            body.nose_radius_m,
            body.shoulder_radius_m,
            None,
        );
    }
    // the cap and the torus touch where r = R_n cos t and r = r_s + R_s cos t agree
    let r_s = 1.0 - body.shoulder_radius_m;
    let touch = numerics::math::acos(r_s / (body.nose_radius_m - body.shoulder_radius_m));
    let nose = Segment::arc(
        Point::on_axis(body.nose_radius_m),
        body.nose_radius_m,
        PI,
        -(FRAC_PI_2 - touch),
    );
    let x_s = body.nose_radius_m - (body.nose_radius_m - body.shoulder_radius_m) * sin(touch);
    let shoulder = Segment::arc(
        at(x_s, r_s),
        body.shoulder_radius_m,
        FRAC_PI_2 + touch,
        -(FRAC_PI_2 + touch),
    );
    let end = shoulder.end();
    let segments = vec![nose, shoulder];
    Profile { segments }
        .line_to(Point::on_axis(end.x_m))
        .closed()
}
