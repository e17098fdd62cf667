//! Joints: what holds struts together where the wire alone does not.

/// How struts are held together at a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointKind {
    /// A printed part that the struts snap into.
    SnapFit,
    /// Solder.
    Solder,
    /// A zip tie.
    ZipTie,
}

/// What holds struts together at a vertex. It stiffens nothing: a frame takes the struts as joined rigidly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// How.
    pub kind: JointKind,
    /// What it weighs, in g: from 0 to a tonne.
    pub mass_g: f64,
}

/// Heaviest joint, in g. A tonne is beyond every frame of wire.
pub(super) const MAX_JOINT_G: f64 = 1.0e6;
