//! All findings of a kind fixed at once: one fix after the other, each for the design as the one before has left it.

use std::rc::Rc;

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::checks::{Code, Diagnostic};

use super::trials::{Trial, Trials};
use super::{EditRequest, reach, verdict};
use super::{Fix, FixChange, FixPreview, FixSearch, FixTotals, candidates, fixes_for, is_collision, to_fix};
use crate::EditorError;
use wirebend_planning::Installation;

/// The most work of all trials together, as in [`super::trials`]: some seconds of a large design.
const MAX_WORK: usize = 4000;
/// The trials of one finding count as so many findings that share the trials of a design.
const SHARES: usize = 16;

/// What fixes all findings of a kind, as one edit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct FixAll {
    /// The edit, with the design after it; `mends` is the first of the findings.
    pub fix: Fix,
    /// How many findings of the kind there are less.
    pub fixed: usize,
    /// How many there are now.
    pub of: usize,
}

impl FixSearch {
    /// What fixes all findings of a kind, or as many as have a fix; none where fewer than two are fixed together, or where
    /// that would leave more errors than there are, also such as could not be seen before for want of a route. All
    /// together they move no vertex farther than one fix may. Of collisions there is none. `goes_on` is asked again and
    /// again; where it does not there is none.
    ///
    /// # Errors
    /// [`EditorError`] where the design cannot be planned.
    pub fn fix_all(
        self,
        app: &Installation,
        code: Code,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<FixAll>, EditorError> {
        if is_collision(code) {
            return Ok(None);
        }
        let (base, mut trials) = Trials::begin(self.document.clone(), app, &self.setup)?;
        let edits = self.edits(app, code, goes_on)?;
        if edits.len() < 2 || !goes_on() {
            return Ok(None);
        }
        let count = edits.len();
        let edit = EditRequest::Several { label: format!("{count} fixes"), edits };
        let Some(trial) = trials.of(&edit) else { return Ok(None) };
        let said = |trial: &Trial| worth(trial, code).len();
        let (before, after) = (said(&base), said(&trial));
        let first = base.findings().iter().position(|finding| finding.diagnostic.code() == code);
        let Some(first) = first else { return Ok(None) };
        let is_error = base.findings()[first].diagnostic.is_error();
        let is_worse = trial.errors() > base.errors() || !verdict::is_no_worse(&base, &trial, is_error);
        if after + 1 >= before || is_worse || !reach::is_near(&edit, &trial, &trials) {
            return Ok(None);
        }
        let fixed = before - after;
        let title = if after == 0 {
            format!("Fix all {before} places")
        } else {
            format!("Fix {fixed} of {before} places")
        };
        let fix = Fix {
            mends: base.check.diagnostics[first].clone(),
            title,
            preview: FixPreview::of(trials.document(), &edit, &trial),
            edit,
            change: FixChange::between(&base, &trial),
            after: FixTotals::of(&trial),
            errors_after: trial.errors(),
            feasible_after: trial.check.feasible,
        };
        Ok(Some(FixAll { fix, fixed, of: before }))
    }

    /// The fixes in their order, until no finding of the kind has one or enough was tried.
    fn edits(
        &self,
        app: &Installation,
        code: Code,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Vec<EditRequest>, EditorError> {
        let mut document = self.document.clone();
        let mut edits = Vec::new();
        let mut unfixed: Vec<Diagnostic> = Vec::new();
        let mut left = MAX_WORK;
        let work = 1 + document.wireframe.edge_count() / 100;
        while left > 0 && goes_on() {
            let (now, mut trials) = Trials::begin(document.clone(), app, &self.setup)?;
            let next = worth(&now, code)
                .into_iter()
                .find(|diagnostic| !unfixed.iter().any(|other| verdict::same_place(other, diagnostic)));
            let Some(next) = next else { break };
            trials.share(SHARES);
            let scaled = edits.iter().any(reach::scales);
            let near = |(edit, trial): &(EditRequest, Rc<Trial>)| {
                let mut after = document.wireframe.clone();
                scaled
                    || reach::scales(edit)
                    || after.commit(&trial.change.wireframe).is_ok()
                        && reach::stay_near(&self.document.wireframe, &after, &self.setup.model)
            };
            match fixes_of(&now, &next, &mut trials).into_iter().find(near) {
                Some((edit, trial)) => {
                    document.commit(&trial.change).map_err(EditorError::from)?;
                    edits.push(edit);
                }
                None => unfixed.push(next),
            }
            left = left.saturating_sub((1 + trials.count()) * work);
        }
        Ok(edits)
    }
}

/// The findings of a kind that are worth a fix.
fn worth(trial: &Trial, code: Code) -> Vec<Diagnostic> {
    let findings = trial.findings();
    let of_kind = to_fix(&findings).into_iter().map(|k| findings[k].diagnostic);
    of_kind.filter(|diagnostic| diagnostic.code() == code).cloned().collect()
}

/// The fixes of a finding, best first.
fn fixes_of(now: &Trial, diagnostic: &Diagnostic, trials: &mut Trials) -> Vec<(EditRequest, Rc<Trial>)> {
    let findings = now.findings();
    let Some(finding) = findings.iter().find(|finding| finding.diagnostic == diagnostic) else {
        return Vec::new();
    };
    let all = candidates(*finding, &findings, trials);
    let fixes = fixes_for(diagnostic, all.into_iter(), now, trials).into_iter();
    fixes.map(|(candidate, trial)| (candidate.edit, trial)).collect()
}
