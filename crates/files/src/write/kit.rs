//! WireBend-kit text: `F 30.000`, `R -90.000`, `B 45.000`, a command a line, R before its B.

use std::fmt::Write as _;

use wirebend_core::bend::{Convention, Step};

use super::number::{fixed, is_zero};

/// How a WireBend-kit program is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KitLayout {
    /// The hash of the design, for the comment in the first line.
    pub design_hash: Option<String>,
    /// Digits behind the decimal point.
    pub decimals: usize,
    /// How the machine counts its axes.
    pub convention: Convention,
}

impl Default for KitLayout {
    /// Three decimals and no comment.
    fn default() -> Self {
        Self { design_hash: None, decimals: 3, convention: Convention::default() }
    }
}

/// Writes a program. Every feed is written; rotations and bends of zero are not.
///
/// ```
/// use wirebend_core::bend::Step;
/// use wirebend_core::units::{Angle, Length};
/// use wirebend_files::write::{KitLayout, kit};
/// let step = Step { feed: Length::from_mm(30.0)?, rotate: Angle::from_deg(-90.0)?, bend: Angle::from_deg(45.0)? };
/// assert_eq!(kit(&[step], &KitLayout::default()), "F 30.000\nR -90.000\nB 45.000\n");
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
#[must_use]
pub fn kit(steps: &[Step], layout: &KitLayout) -> String {
    let mut text = String::new();
    if let Some(hash) = &layout.design_hash {
        let hash: String = hash.chars().filter(|c| !c.is_control()).collect();
        let _ = writeln!(text, "# design {hash}");
    }
    for step in steps.iter().map(|step| layout.convention.apply(*step)) {
        let _ = writeln!(text, "F {}", fixed(step.feed.mm(), layout.decimals));
        for (letter, angle) in [("R", step.rotate), ("B", step.bend)] {
            let angle = fixed(angle.deg(), layout.decimals);
            if !is_zero(&angle) {
                let _ = writeln!(text, "{letter} {angle}");
            }
        }
    }
    text
}
