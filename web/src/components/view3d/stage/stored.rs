//! What a stage keeps between drawings: the scene, and the pointers that are down.

use crate::state::Solved;
use crate::view3d::camera::Ball;
use crate::view3d::renderer::Renderer;
use crate::view3d::scene::Scene;
use leptos::ev::PointerEvent;
use msape::answer::surface::SurfaceHeating;
use msape::vehicle::profile::Profile;
use std::sync::Arc;

/// What is drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// The vehicle of a design.
    Design(Arc<Solved>),
    /// One body of revolution.
    Body(Arc<Profile>),
}

/// A vehicle that is larger or smaller than what fills the view by more than this is fitted into it anew.
const REFIT: f32 = 1.6;
/// What outlives a drawing.
#[derive(Default)]
pub struct Stored {
    /// Draws.
    pub renderer: Option<Renderer>,
    /// What is drawn.
    pub scene: Scene,
    /// What fills the view.
    pub ball: Ball,
    /// Whether the next frame of the screen draws.
    pub draws_soon: bool,
    /// Pointers that are down: number and place.
    pub pointers: Vec<(i32, f64, f64)>,
    /// How far they moved since the first came down, CSS px.
    pub moved_px: f64,
    /// How often a subject was taken.
    pub loads: u32,
}

/// A pointer: number and place.
pub fn place(event: &PointerEvent) -> (i32, f64, f64) {
    let (x, y) = (event.client_x(), event.client_y());
    (event.pointer_id(), f64::from(x), f64::from(y))
}

/// What a movement of pointers means.
pub enum Moved {
    /// One was dragged.
    Turned {
        /// To the right, CSS px.
        x_px: f64,
        /// Downwards, CSS px.
        y_px: f64,
    },
    /// Of two, the distance changed.
    Pinched {
        /// By this factor.
        factor: f64,
        /// Both moved down, CSS px.
        y_px: f64,
    },
}

impl Stored {
    /// Takes a subject.
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

    /// Moves a pointer that is down.
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

    /// Forgets a pointer; whether it was down.
    pub fn lifted(&mut self, id: i32) -> bool {
        let before = self.pointers.len();
        self.pointers.retain(|(other, _, _)| *other != id);
        self.pointers.len() < before
    }
}
