//! All faces of a drawing as one mesh.

use std::collections::{HashMap, HashSet};

use nalgebra::{Affine3, Point3};

use super::super::error::{Location, ReadError};
use super::super::note::NoteKind;
use super::super::outline::Pen;
use super::shape::Faces;

/// Corners with the same coordinates are one; a side is hidden if no face shows it.
#[derive(Debug, Default)]
pub(super) struct Skin {
    corners: HashMap<[u64; 3], u32>,
    shown: HashSet<(u32, u32)>,
    hidden: HashSet<(u32, u32)>,
    count: usize,
}

impl Skin {
    pub(super) fn add(
        &mut self,
        pen: &mut Pen<'_>,
        place: &Location,
        faces: &Faces,
        map: &Affine3<f64>,
    ) -> Result<(), ReadError> {
        let mirrored = map.matrix().fixed_view::<3, 3>(0, 0).determinant() < 0.0;
        let points = faces.mapped(map);
        for face in &faces.faces {
            pen.source.room(place.clone(), self.count, "faces")?;
            self.count += 1;
            let mut corners: Vec<(u32, bool)> = Vec::with_capacity(face.corners.len());
            for &(corner, shown) in &face.corners {
                let index = self.corner(pen, place, points[corner as usize])?;
                // A side without length is none; the next one begins at the same corner.
                match corners.last_mut() {
                    Some(last) if last.0 == index => last.1 = shown,
                    _ => corners.push((index, shown)),
                }
            }
            if corners.len() > 1 && corners[0].0 == corners[corners.len() - 1].0 {
                corners.pop();
            }
            if corners.len() < 3 {
                pen.drawing.notes.add(NoteKind::FacesCollapsed, 1);
                continue;
            }
            for (k, &(a, shown)) in corners.iter().enumerate() {
                let b = corners[(k + 1) % corners.len()].0;
                let sides = if shown { &mut self.shown } else { &mut self.hidden };
                sides.insert((a.min(b), a.max(b)));
            }
            // A mirror image has its faces turned over, so that they look outwards again.
            if mirrored {
                corners[1..].reverse();
            }
            pen.drawing.faces.push(corners.into_iter().map(|(corner, _)| corner).collect());
        }
        Ok(())
    }

    fn corner(&mut self, pen: &mut Pen<'_>, place: &Location, point: Point3<f64>) -> Result<u32, ReadError> {
        // Adding zero makes -0 and 0 the same bits.
        let bits = [point.x, point.y, point.z].map(|c| (c + 0.0).to_bits());
        if let Some(&index) = self.corners.get(&bits) {
            return Ok(index);
        }
        let index = pen.corner(place, point)?;
        self.corners.insert(bits, index);
        Ok(index)
    }

    pub(super) fn hidden_sides(self) -> HashSet<(u32, u32)> {
        let Self { shown, mut hidden, .. } = self;
        hidden.retain(|side| !shown.contains(side));
        hidden
    }
}
