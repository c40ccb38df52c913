//! Scale and markup.

use super::*;
use crate::export::model::Measures;
use msape::vehicle::profile::Profile;
use msape::vehicle::segment::Segment;
use numerics::math::PI;

fn ball() -> Model {
    let half = Segment::arc(Point::on_axis(1.0), 0.5, PI, -PI);
    let profile = Profile {
        segments: vec![half],
    }
    .closed();
    Model::of_outline("Ball <1> & \"more\"", &profile, Measures::default())
}

#[test]
fn a_ball_of_1_m_is_drawn_at_1_to_15_with_its_diameter() {
    let model = ball();
    // 1000 mm in a box of 90 mm: 11.1, the next scale of the list is 15
    assert_eq!(view(&model).scale, 15.0);
    let text = svg(&model, &Info::default());
    // the upper half by two quarter-circles of 500 / 15 mm: body, its edge, outline
    assert_eq!(text.matches("A33.3333 33.3333 0 0 1").count(), 6);
    assert!(text.contains("⌀ 1000.0") && text.contains("R 500.0"));
    assert!(text.contains("1:15, mm"));
}

#[test]
fn a_name_is_no_markup() {
    let text = svg(&ball(), &Info::default());
    assert!(text.contains("Ball &lt;1&gt; &amp; &quot;more&quot;"));
    assert!(!text.contains("<1>"));
    assert_eq!(cut("abcdef", 4), "abc…");
}
