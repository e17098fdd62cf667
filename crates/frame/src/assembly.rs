//! What can be worked out once for a model, whichever of its members are there.

use nalgebra::{Matrix3, Vector3};

use crate::checks;
use crate::element::{Element, Vector12};
use crate::equations::Equations;
use crate::error::ModelError;
use crate::member_set::MemberSet;
use crate::model::{MemberId, Model};
use crate::section::Section;

/// A model that was checked, with the pattern of its stiffness.
pub struct Assembly {
    model: Model,
    pub(crate) elements: Vec<Element>,
    pub(crate) equations: Equations,
    /// mm a radian: what makes rotations as large as displacements, the mean length of the members.
    pub(crate) rotation_unit: f64,
}

impl Assembly {
    /// Checks a model and works out the pattern of its stiffness, which serves every [`MemberSet`].
    ///
    /// ```
    /// # use nalgebra::Point3;
    /// # use wirebend_frame::{Assembly, Load, Material, Member, Model, NodeId, Section, SectionId, Support};
    /// let steel = Material { e: 200_000.0, g: 77_500.0, density: 7.8e-9, yield_strength: 1000.0 };
    /// let section = Section::round(2.0, &steel);
    /// let model = Model {
    ///     nodes: vec![Point3::origin(), Point3::new(100.0, 0.0, 0.0)],
    ///     members: vec![Member::new(NodeId(0), NodeId(1), SectionId(0))],
    ///     sections: vec![section],
    ///     supports: vec![Support::clamped(NodeId(0))],
    /// };
    /// let assembly = Assembly::new(&model)?;
    /// let response = assembly.factor(&assembly.all())?.solve(&Load::self_weight())?;
    /// // A cantilever sags by q L⁴ / 8 E I.
    /// let sag = 7.8e-9 * section.area * 9806.65 * 100.0_f64.powi(4) / (8.0 * 200_000.0 * section.iy);
    /// assert!((response.max_displacement().1 / sag - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A node, member, section or support that describes no frame, by its place in the model.
    pub fn new(model: &Model) -> Result<Self, ModelError> {
        checks::check(model)?;
        let elements: Vec<Element> = model
            .members
            .iter()
            .map(|member| {
                let span = model.nodes[member.b.0] - model.nodes[member.a.0];
                Element::new(span, &model.sections[member.section.0], member.up)
            })
            .collect();
        #[allow(clippy::cast_precision_loss, reason = "members are fewer than 2⁵²")]
        let mean = elements.iter().map(|element| element.length).sum::<f64>() / elements.len() as f64;
        Ok(Self {
            model: model.clone(),
            equations: Equations::new(model).ok_or(ModelError::TooLarge { nodes: model.nodes.len() })?,
            rotation_unit: if elements.is_empty() { 1.0 } else { mean },
            elements,
        })
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// All its members.
    #[must_use]
    pub fn all(&self) -> MemberSet {
        MemberSet::all(self.model.members.len())
    }

    /// mm.
    #[must_use]
    pub fn length(&self, member: MemberId) -> f64 {
        self.elements[member.0].length
    }

    /// The section of a member.
    #[must_use]
    pub fn section(&self, member: MemberId) -> &Section {
        &self.model.sections[self.model.members[member.0].section.0]
    }

    /// The local axes of a member as rows: x from `a` to `b`, y, z.
    #[must_use]
    pub fn axes(&self, member: MemberId) -> Matrix3<f64> {
        self.elements[member.0].axes
    }

    /// The forces and moments at the ends of a member that move so, `K_e q`, all in the model's axes.
    #[must_use]
    pub fn end_forces(&self, member: MemberId, ends: &[f64; 12]) -> [f64; 12] {
        self.elements[member.0].forces(&Vector12::from(*ends)).into()
    }

    /// The mass of some of the members, t.
    #[must_use]
    pub fn mass(&self, members: &MemberSet) -> f64 {
        members.iter().map(|member| self.weight(member) * self.length(member)).sum()
    }

    /// t/mm.
    pub(crate) fn weight(&self, member: MemberId) -> f64 {
        let section = self.section(member);
        section.density * section.area
    }

    /// The diagonal of the box around the nodes, mm.
    pub(crate) fn size(&self) -> f64 {
        let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY].map(Vector3::repeat);
        for node in &self.model.nodes {
            low = low.inf(&node.coords);
            high = high.sup(&node.coords);
        }
        if self.model.nodes.is_empty() { 0.0 } else { (high - low).norm() }
    }

    /// Of each node, whether one of these members touches it.
    pub(crate) fn touched(&self, members: &MemberSet) -> Vec<bool> {
        let mut touched = vec![false; self.model.nodes.len()];
        for member in members.iter() {
            let member = &self.model.members[member.0];
            touched[member.a.0] = true;
            touched[member.b.0] = true;
        }
        touched
    }

    /// The numbers that are at the ends of a member, out of those of nodes.
    pub(crate) fn ends(&self, member: MemberId, of_nodes: &[[f64; 6]]) -> Vector12 {
        let member = &self.model.members[member.0];
        let mut ends = Vector12::zeros();
        ends.as_mut_slice()[..6].copy_from_slice(&of_nodes[member.a.0]);
        ends.as_mut_slice()[6..].copy_from_slice(&of_nodes[member.b.0]);
        ends
    }
}
