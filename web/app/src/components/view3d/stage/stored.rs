//! State of a stage between drawings: scene and active pointers.

use crate::state::Solved;
use leptos::ev::PointerEvent;
use msape::answer::surface::SurfaceHeating;
use msape::vehicle::profile::Profile;
use msape_view3d::camera::Ball;
use msape_view3d::renderer::Renderer;
use msape_view3d::scene::Scene;
use std::sync::Arc;

/// Subject of a view.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// The vehicle of a design.
    Design(Arc<Solved>),
    /// A body of revolution.
    Body(Arc<Profile>),
}

/// Ratio of sizes above which a changed vehicle is fitted to the view again.
const REFIT: f32 = 1.6;
/// State kept between drawings.
#[derive(Default)]
pub struct Stored {
    /// Renderer, once there is one.
    pub renderer: Option<Renderer>,
    /// Scene.
    pub scene: Scene,
    /// Bounding sphere that fills the view.
    pub ball: Ball,
    /// Whether a drawing is requested for the next frame.
    pub draws_soon: bool,
    /// Pointers that are pressed: identifier and position.
    pub pointers: Vec<(i32, f64, f64)>,
    /// Movement since the first was pressed, CSS px.
    pub moved_px: f64,
    /// Number of subjects loaded so far.
    pub loads: u32,
}

/// Identifier and position of a pointer.
pub fn place(event: &PointerEvent) -> (i32, f64, f64) {
    let (x, y) = (event.client_x(), event.client_y());
    (event.pointer_id(), f64::from(x), f64::from(y))
}

/// Meaning of a pointer movement.
pub enum Moved {
    /// Drag of one pointer.
    Turned {
        /// To the right, CSS px.
        x_px: f64,
        /// Downwards, CSS px.
        y_px: f64,
    },
    /// Pinch of two pointers.
    Pinched {
        /// Ratio of distances.
        factor: f64,
        /// Common downward movement, CSS px.
        y_px: f64,
    },
}

impl Stored {
    /// Loads a subject.
    pub fn load(&mut self, subject: Option<&Subject>) {
        match subject {
            Some(Subject::Design(solved)) => {
                let Some(design) = &solved.answer.design else {
                    return;
                };
                let heating = SurfaceHeating::of(&solved.answer);
                self.scene.fill(&design.vehicle, heating.as_ref());
            }
            Some(Subject::Body(outline)) => self.scene.fill_body(outline),
            None => return,
        }
        let grown = self.scene.ball.radius_m / self.ball.radius_m;
        if !(1.0 / REFIT..=REFIT).contains(&grown) {
            self.ball = self.scene.ball;
        }
        self.loads += 1;
        if let Some(renderer) = &mut self.renderer {
            renderer.load(&self.scene);
        }
    }

    /// Moves a pressed pointer.
    pub fn moved(&mut self, (id, x, y): (i32, f64, f64)) -> Option<Moved> {
        let other = self
            .pointers
            .iter()
            .copied()
            .find(|(other, _, _)| *other != id);
        let at = self.pointers.iter_mut().find(|(down, _, _)| *down == id)?;
        let (before_x, before_y) = (at.1, at.2);
        (at.1, at.2) = (x, y);
        let (x_px, y_px) = (x - before_x, y - before_y);
        self.moved_px += x_px.abs() + y_px.abs();
        Some(match other {
            None => Moved::Turned { x_px, y_px },
            Some((_, other_x, other_y)) => {
                let apart = |x: f64, y: f64| (x - other_x).hypot(y - other_y).max(1.0);
                Moved::Pinched {
                    factor: apart(x, y) / apart(before_x, before_y),
                    y_px: 0.5 * y_px,
                }
            }
        })
    }

    /// Removes a pointer; returns whether it was pressed.
    pub fn lifted(&mut self, id: i32) -> bool {
        let before = self.pointers.len();
        self.pointers.retain(|(other, _, _)| *other != id);
        self.pointers.len() < before
    }
}
