//! The closed curves of a vehicle's parts, drawn one after the other in the same memory.
//!
//! A search draws every part thousands of times and keeps none of them: it reads each curve while it exists.

use crate::vehicle::kinds::ComponentKind;
use crate::vehicle::profile::Profile;
use core::mem::{swap, take};
use numerics::scalar::Single;

/// Memory in which curves are drawn; the parts of the next vehicle take the place of those of the last.
#[derive(Clone, Debug)]
pub struct Memory<S = f64> {
    path: Profile<S>,
    surfaces: [Profile<S>; 2],
}

impl<S> Default for Memory<S> {
    fn default() -> Self {
        Self {
            path: Profile::default(),
            surfaces: Default::default(),
        }
    }
}

/// Draws parts and shows each to a reader.
pub struct Draft<'a, S = f64> {
    memory: &'a mut Memory<S>,
    reader: &'a mut dyn FnMut(ComponentKind, &Profile<S>),
}

impl<'a, S: Single> Draft<'a, S> {
    /// Shows to `reader` each closed curve with the part to which it belongs; one that is empty for a part without a body.
    pub fn new(
        memory: &'a mut Memory<S>,
        reader: &'a mut dyn FnMut(ComponentKind, &Profile<S>),
    ) -> Self {
        Self { memory, reader }
    }

    /// A part, or one of its pieces: `draw` continues the path that it is given.
    pub fn part(&mut self, kind: ComponentKind, draw: impl FnOnce(Profile<S>) -> Profile<S>) {
        let path = draw(take(&mut self.memory.path).cleared()).closed();
        (self.reader)(kind, &path);
        self.memory.path = path;
    }

    /// The layers between the surface at no depth and those at `depths_m`, from outside in; `draw` continues a path with the surface at
    /// a depth.
    pub fn layers<const N: usize>(
        &mut self,
        kinds: [ComponentKind; N],
        depths_m: [S; N],
        draw: impl Fn(Profile<S>, S) -> Profile<S>,
    ) {
        let [outer, mut inner] = take(&mut self.memory.surfaces);
        let mut outer = draw(outer.cleared(), S::constant(0.0));
        for (kind, depth_m) in kinds.into_iter().zip(depths_m) {
            inner = draw(inner.cleared(), depth_m);
            // a layer of no thickness is no body
            self.part(kind, |path| match outer.is_along(&inner) {
                true => path,
                false => path.then(&outer).back_along(&inner),
            });
            swap(&mut outer, &mut inner);
        }
        self.memory.surfaces = [outer, inner];
    }
}
