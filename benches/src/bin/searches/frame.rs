//! Random frames of straight struts that a bender could make, were it not for collisions.

use anyhow::{Result, bail};
use nalgebra::Point3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wirebend_core::wireframe::{Vertex, Wireframe};

/// mm between vertices at least, and of struts at most.
const APART: f64 = 35.0;
const LONGEST: f64 = 90.0;
/// Cosine of the sharpest corner between two struts: 30°, so that no bend is beyond 150°.
const SHARPEST: f64 = 0.866;

/// A connected frame of so many struts.
pub fn random(seed: u64, edges: usize) -> Result<Wireframe> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    for _ in 0..200 {
        if let Some(frame) = tried(&mut random, edges)? {
            return Ok(frame);
        }
    }
    bail!("no frame of {edges} struts for seed {seed}")
}

fn tried(random: &mut ChaCha8Rng, edges: usize) -> Result<Option<Wireframe>> {
    let size = 30.0 * f64::from(u32::try_from(edges)?).cbrt();
    let mut points: Vec<Point3<f64>> = vec![Point3::origin()];
    let mut links: Vec<[usize; 2]> = Vec::new();
    for _ in 0..edges * 400 {
        if links.len() == edges {
            break;
        }
        let from = random.random_range(0..points.len());
        let close = random.random_bool(0.6) && points.len() > 3;
        let to = if close {
            random.random_range(0..points.len())
        } else {
            let at = Point3::from(std::array::from_fn(|_| random.random_range(-size..size)));
            if points.iter().any(|point| (point - at).norm() < APART) {
                continue;
            }
            points.push(at);
            points.len() - 1
        };
        if fits(&points, &links, from, to) {
            links.push([from, to]);
        } else if to == points.len() - 1 && !links.iter().any(|link| link.contains(&to)) {
            points.pop();
        }
    }
    if links.len() < edges {
        return Ok(None);
    }
    let mut frame = Wireframe::new();
    let ids =
        points.iter().map(|point| frame.add_vertex(Vertex::at(*point))).collect::<Result<Vec<_>, _>>()?;
    for [from, to] in links {
        frame.add_edge(ids[from], ids[to])?;
    }
    Ok((frame.components().len() == 1).then_some(frame))
}

fn fits(points: &[Point3<f64>], links: &[[usize; 2]], from: usize, to: usize) -> bool {
    let length = (points[to] - points[from]).norm();
    if from == to
        || !(APART..LONGEST).contains(&length)
        || links.iter().any(|link| link.contains(&from) && link.contains(&to))
    {
        return false;
    }
    links.iter().all(|&[a, b]| {
        for (here, there) in [(from, to), (to, from)] {
            for (one, other) in [(a, b), (b, a)] {
                if one == here {
                    let (u, v) = (points[there] - points[here], points[other] - points[here]);
                    return u.dot(&v) < SHARPEST * u.norm() * v.norm();
                }
            }
        }
        let (distance, _) =
            wirebend_collide::between_pieces(&[points[from], points[to]], &[points[a], points[b]]);
        distance > 8.0
    })
}
