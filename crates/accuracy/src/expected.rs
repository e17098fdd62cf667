//! What is expected of all the wires that a machine could make, without drawing any: errors are independent and their effects add up, so
//! that squares do.

use wirebend_core::simulate::ErrorModel;

use super::closing::{Closed, Closing, mean};
use super::draw::Terms;
use super::model::{ClosingError, Prepared};
use super::surface::Surface;

/// So many unit errors are closed at once.
const AT_ONCE: usize = 32;

/// Roots of expected squares. They are a few percent above the means of the same over wires.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// How far the faces are from their planes, mm: the mean over the faces of the root of the expected mean square.
    pub surface_rms: f64,
    /// Of each face the root of its expected mean square, mm. Squares of these add where errors are independent.
    pub faces_rms: Vec<f64>,
    /// How far the vertices are from where they should be, after the motion of the whole that fits them best, mm.
    pub vertices_rms: f64,
    /// Force along a strut, over all struts, N.
    pub axial_rms: f64,
    /// Von Mises stress, over all struts, MPa.
    pub von_mises_rms: f64,
    /// The force that pulls a pass to its vertex, where it is largest, N.
    pub largest_pull: Option<f64>,
    /// The mean of the energy that is stored, N mm.
    pub energy: f64,
}

/// Sums of squares of effects.
#[derive(Debug, Default)]
struct Squares {
    surface: Vec<f64>,
    vertices: f64,
    axial: f64,
    von_mises: f64,
    pulls: Option<Vec<f64>>,
    energy: f64,
}

impl Squares {
    /// Adds a closed frame.
    fn add(&mut self, closed: &Closed, surface: &Surface, whole: &Surface) {
        let add = |sums: &mut Vec<f64>, squares: &mut dyn Iterator<Item = f64>| {
            for (k, square) in squares.enumerate() {
                if k == sums.len() {
                    sums.push(0.0);
                }
                sums[k] += square;
            }
        };
        add(&mut self.surface, &mut surface.mean_squares(&closed.displacements));
        if let Some(pulls) = &closed.pulls {
            add(self.pulls.get_or_insert_default(), &mut pulls.iter().map(|pull| pull * pull));
        }
        self.vertices += whole.rms(&closed.displacements).powi(2);
        self.axial += closed.axial_rms().powi(2);
        self.von_mises += closed.von_mises_rms().powi(2);
        self.energy += closed.energy;
    }
}

impl Prepared<'_> {
    /// The exact expectation with straight struts.
    ///
    /// # Errors
    /// [`ClosingError::Bowed`] with errors that bow struts, [`ClosingError::Errors`] with errors that are none.
    pub fn expected(
        &self,
        closing: Closing,
        errors: &ErrorModel,
        surface: &Surface,
    ) -> Result<Expected, ClosingError> {
        let terms = Terms::new(errors)?;
        if terms.bows() {
            return Err(ClosingError::Bowed);
        }
        let (mut squares, whole) = (Squares::default(), self.model.whole());
        let sources = &self.model.sources;
        // What is always off is one frame, whose effects count once.
        let biased =
            self.own_ends(sources.iter().map(|source| (source, terms.of(source.of).bias * source.side)));
        for closed in self.close_all(closing, vec![biased]) {
            squares.add(&closed, surface, &whole);
        }
        let random: Vec<_> = sources
            .iter()
            .map(|source| (source, terms.of(source.of).sigma))
            .filter(|&(_, sigma)| sigma > 0.0)
            .collect();
        for some in random.chunks(AT_ONCE) {
            let own =
                some.iter().map(|&(source, sigma)| self.own_ends(std::iter::once((source, sigma)))).collect();
            for closed in self.close_all(closing, own) {
                squares.add(&closed, surface, &whole);
            }
        }
        let faces_rms: Vec<f64> = squares.surface.iter().map(|square| square.sqrt()).collect();
        Ok(Expected {
            surface_rms: mean(faces_rms.iter().copied()),
            faces_rms,
            vertices_rms: squares.vertices.sqrt(),
            axial_rms: squares.axial.sqrt(),
            von_mises_rms: squares.von_mises.sqrt(),
            largest_pull: squares.pulls.map(|pulls| pulls.into_iter().fold(0.0, f64::max).sqrt()),
            energy: squares.energy,
        })
    }
}
