//! Where the wires of the open design meet the machine or themselves. It takes longer than the other checks: what it needs is
//! copied, so that the design is free meanwhile.

use wirebend_files::document::Document;
use wirebend_planning::collisions::Collisions;
use wirebend_planning::design::Opened;
use wirebend_planning::machine::Setup;
use wirebend_planning::{Installation, NoProgress, PlanChoices};

use super::{Editor, Moved};
use crate::EditorError;

/// A design that is to be looked at for collisions.
pub struct CollisionCheck {
    name: String,
    document: Document,
    setup: Setup,
}

impl Editor {
    /// What [`CollisionCheck::run`] needs of the design, with some vertices elsewhere than they are.
    ///
    /// # Errors
    /// As [`Editor::check`].
    pub fn collision_check(
        &mut self,
        app: &Installation,
        moved: &[Moved],
    ) -> Result<CollisionCheck, EditorError> {
        let document = self.moved_part(moved)?;
        let (names, setup) = self.take_setup(app)?;
        let found = CollisionCheck { name: self.name.clone(), document, setup: setup.clone() };
        self.setup = Some((names, setup));
        Ok(found)
    }
}

impl CollisionCheck {
    /// Looks where the wires meet the machine or themselves. `goes_on` is asked again and again, with how many of how many steps are
    /// done: where it does not, nothing is known.
    pub fn run(self, goes_on: &mut dyn FnMut(usize, usize) -> bool) -> Result<Collisions, EditorError> {
        let opened = Opened::of(self.name, self.document);
        let mut planned = Installation::plan_with(opened, self.setup, &PlanChoices::default(), &NoProgress)?;
        Ok(planned.find_collisions(goes_on))
    }
}
