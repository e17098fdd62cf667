//! Stiffness, mass and fixed-end forces of one beam, in the model's axes.
//!
//! Euler-Bernoulli, two nodes, twelve degrees of freedom, cubic shapes: the textbook matrix (Przemieniecki, Theory of Matrix
//! Structural Analysis, 1968, ch. 5 and 11) turned into the model's axes as blocks. With x along the beam, X = x xᵀ and
//! P = 1 - X a round section needs no axes across the beam, and a beam along z is no special case.

use nalgebra::{Matrix3, Matrix6, SMatrix, SVector, Vector3, Vector6};

use crate::section::Section;

/// Displacement and rotation at `a`, then at `b`.
pub(crate) type Vector12 = SVector<f64, 12>;
/// Between two of those.
pub(crate) type Matrix12 = SMatrix<f64, 12, 12>;

/// A beam: where it points, and its stiffness in blocks.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Element {
    pub length: f64,
    /// Rows are local x, y, z.
    pub axes: Matrix3<f64>,
    /// Force at `a` by displacement at `a`.
    along: Matrix3<f64>,
    /// Force at `a` by rotation at either end.
    across: Matrix3<f64>,
    /// Moment at an end by rotation at the same end.
    near: Matrix3<f64>,
    /// Moment at an end by rotation at the other end.
    far: Matrix3<f64>,
}

impl Element {
    /// A beam along `span`. `up` is not along it; `None` is z, or y for a beam within 1e-6 of z.
    pub fn new(span: Vector3<f64>, section: &Section, up: Option<Vector3<f64>>) -> Self {
        let length = span.norm();
        let x = span / length;
        let axes = axes(x, up);
        let shapes = Shapes::new(x, &axes, section);
        let (e, l) = (section.e, length);
        let axial = shapes.axial * (e * section.area / l);
        let torsion = shapes.axial * (section.g * section.j / l);
        Self {
            length,
            axes,
            along: axial + shapes.across * (12.0 * e / (l * l * l)),
            across: shapes.skew * (6.0 * e / (l * l)),
            near: torsion + shapes.turned * (4.0 * e / l),
            far: shapes.turned * (2.0 * e / l) - torsion,
        }
    }

    /// Local x.
    pub fn x(&self) -> Vector3<f64> {
        self.axes.row(0).transpose()
    }

    /// The stiffness, with rotations measured as `rotation_unit` times the angle; 1 gives radian.
    pub fn stiffness(&self, rotation_unit: f64) -> Matrix12 {
        let across = self.across / rotation_unit;
        let square = rotation_unit * rotation_unit;
        let (near, far) = (self.near / square, self.far / square);
        let mut k = Matrix12::zeros();
        let mut put = |row: usize, column: usize, block: Matrix3<f64>| {
            k.fixed_view_mut::<3, 3>(row, column).copy_from(&block);
        };
        put(0, 0, self.along);
        put(0, 3, across);
        put(0, 6, -self.along);
        put(0, 9, across);
        put(3, 0, across.transpose());
        put(3, 3, near);
        put(3, 6, -across.transpose());
        put(3, 9, far);
        put(6, 0, -self.along);
        put(6, 3, -across);
        put(6, 6, self.along);
        put(6, 9, -across);
        put(9, 0, across.transpose());
        put(9, 3, far);
        put(9, 6, -across.transpose());
        put(9, 9, near);
        k
    }

    /// The forces and moments at the ends that move so.
    pub fn forces(&self, ends: &Vector12) -> Vector12 {
        let part = |k: usize| Vector3::new(ends[k], ends[k + 1], ends[k + 2]);
        let (apart, turn_a, turn_b) = (part(0) - part(6), part(3), part(9));
        let force = self.along * apart + self.across * (turn_a + turn_b);
        let bent = self.across.transpose() * apart;
        let moment_a = bent + self.near * turn_a + self.far * turn_b;
        let moment_b = bent + self.far * turn_a + self.near * turn_b;
        let mut forces = Vector12::zeros();
        for (k, block) in [force, moment_a, -force, moment_b].iter().enumerate() {
            forces.fixed_rows_mut::<3>(3 * k).copy_from(block);
        }
        forces
    }

    /// Twice the energy of ends that move so, from how they move against each other: exact zero of a rigid motion is not lost
    /// among large figures.
    pub fn twice_energy(&self, ends: &Vector12) -> f64 {
        let deformed = self.deformation(ends);
        deformed.dot(&(self.at_b() * deformed))
    }

    /// How end `b` moves, seen from end `a` as if the beam were rigid.
    pub fn deformation(&self, ends: &Vector12) -> Vector6<f64> {
        let (a, b) = (ends.fixed_rows::<6>(0), ends.fixed_rows::<6>(6));
        b - self.carried(&a.into_owned())
    }

    /// The stiffness at end `b` while end `a` is clamped.
    pub fn at_b(&self) -> Matrix6<f64> {
        let mut k = Matrix6::zeros();
        k.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.along);
        k.fixed_view_mut::<3, 3>(0, 3).copy_from(&-self.across);
        k.fixed_view_mut::<3, 3>(3, 0).copy_from(&-self.across.transpose());
        k.fixed_view_mut::<3, 3>(3, 3).copy_from(&self.near);
        k
    }

    /// The flexibility of end `b` while end `a` is clamped; the inverse of [`Element::at_b`].
    pub fn cantilever(&self, section: &Section) -> Matrix6<f64> {
        let shapes = Shapes::new(self.x(), &self.axes, section);
        let (e, l) = (section.e, self.length);
        let (iy, iz) = (section.iy, section.iz);
        // Shapes hold I; their inverse holds 1/I, which of `across / (iy iz)` is the one with y and z exchanged.
        let across = shapes.turned / (iy * iz);
        let turned = shapes.across / (iy * iz);
        let skew = if section.is_round() {
            shapes.skew / (iy * iz)
        } else {
            let (y, z) = (self.axes.row(1).transpose(), self.axes.row(2).transpose());
            y * z.transpose() / iz - z * y.transpose() / iy
        };
        let mut c = Matrix6::zeros();
        let displaced = shapes.axial * (l / (e * section.area)) + across * (l * l * l / (3.0 * e));
        let rotated = shapes.axial * (l / (section.g * section.j)) + turned * (l / e);
        let mixed = skew * (l * l / (2.0 * e));
        c.fixed_view_mut::<3, 3>(0, 0).copy_from(&displaced);
        c.fixed_view_mut::<3, 3>(0, 3).copy_from(&mixed);
        c.fixed_view_mut::<3, 3>(3, 0).copy_from(&mixed.transpose());
        c.fixed_view_mut::<3, 3>(3, 3).copy_from(&rotated);
        c
    }

    /// How `b` moves when `a` moves so and the beam is rigid.
    pub fn carried(&self, a: &Vector6<f64>) -> Vector6<f64> {
        let (moved, turned) = (a.fixed_rows::<3>(0), a.fixed_rows::<3>(3).into_owned());
        let b = moved + turned.cross(&(self.x() * self.length));
        Vector6::new(b[0], b[1], b[2], turned[0], turned[1], turned[2])
    }

    /// The force and moment at `a` that a force and moment at `b` amount to.
    pub fn carried_back(&self, b: &Vector6<f64>) -> Vector6<f64> {
        let (force, moment) = (b.fixed_rows::<3>(0).into_owned(), b.fixed_rows::<3>(3));
        let at_a = moment + (self.x() * self.length).cross(&force);
        Vector6::new(force[0], force[1], force[2], at_a[0], at_a[1], at_a[2])
    }

    /// The forces and moments at the ends that stand for a force spread along the beam, N/mm.
    pub fn spread(&self, line: &Vector3<f64>) -> Vector12 {
        let half = line * (self.length / 2.0);
        let moment = self.x().cross(line) * (self.length * self.length / 12.0);
        let mut forces = Vector12::zeros();
        for (k, block) in [half, moment, half, -moment].iter().enumerate() {
            forces.fixed_rows_mut::<3>(3 * k).copy_from(block);
        }
        forces
    }

    /// The consistent mass, with rotations measured as in [`Element::stiffness`]. The inertia of turning about the beam's
    /// own axis is there; that of cross-sections in bending is not.
    pub fn mass(&self, section: &Section, rotation_unit: f64) -> Matrix12 {
        let x = self.x();
        let along = x * x.transpose();
        let across = Matrix3::identity() - along;
        let skew = -x.cross_matrix() / rotation_unit;
        let l = self.length;
        let mass = section.density * section.area * l;
        let spin = (section.iy + section.iz) / section.area;
        let square = rotation_unit * rotation_unit;
        let bend = across * (l * l / (420.0 * square));
        let twist = along * (spin / square);
        let mut m = Matrix12::zeros();
        let mut put = |row: usize, column: usize, block: Matrix3<f64>| {
            let block = block * mass;
            m.fixed_view_mut::<3, 3>(row, column).copy_from(&block);
            m.fixed_view_mut::<3, 3>(column, row).copy_from(&block.transpose());
        };
        let same = along / 3.0 + across * (156.0 / 420.0);
        put(0, 0, same);
        put(6, 6, same);
        put(0, 6, along / 6.0 + across * (54.0 / 420.0));
        put(0, 3, skew * (22.0 * l / 420.0));
        put(0, 9, skew * (-13.0 * l / 420.0));
        put(6, 3, skew * (13.0 * l / 420.0));
        put(6, 9, skew * (-22.0 * l / 420.0));
        let turned = bend * 4.0 + twist / 3.0;
        put(3, 3, turned);
        put(9, 9, turned);
        put(3, 9, bend * -3.0 + twist / 6.0);
        m
    }
}

/// What the two planes of bending make of directions, each weighed with its second moment of area.
struct Shapes {
    /// x xᵀ.
    axial: Matrix3<f64>,
    /// Iz y yᵀ + Iy z zᵀ: for displacements.
    across: Matrix3<f64>,
    /// Iy y yᵀ + Iz z zᵀ: for rotations.
    turned: Matrix3<f64>,
    /// Iz y zᵀ - Iy z yᵀ: from rotations to displacements.
    skew: Matrix3<f64>,
}

impl Shapes {
    fn new(x: Vector3<f64>, axes: &Matrix3<f64>, section: &Section) -> Self {
        let axial = x * x.transpose();
        if section.is_round() {
            let across = (Matrix3::identity() - axial) * section.iy;
            return Self { axial, across, turned: across, skew: -x.cross_matrix() * section.iy };
        }
        let (y, z) = (axes.row(1).transpose(), axes.row(2).transpose());
        let (yy, zz) = (y * y.transpose(), z * z.transpose());
        Self {
            axial,
            across: yy * section.iz + zz * section.iy,
            turned: yy * section.iy + zz * section.iz,
            skew: y * z.transpose() * section.iz - z * y.transpose() * section.iy,
        }
    }
}

fn axes(x: Vector3<f64>, up: Option<Vector3<f64>>) -> Matrix3<f64> {
    let up = up.unwrap_or_else(|| if x.x.hypot(x.y) < 1e-6 { Vector3::y() } else { Vector3::z() });
    let y = up.cross(&x).normalize();
    Matrix3::from_rows(&[x.transpose(), y.transpose(), x.cross(&y).transpose()])
}
