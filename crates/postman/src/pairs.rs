//! The cheapest pairs of things of which each may be the partner of any other.

use crate::graph::{NONE, id};
use crate::matching::{Matching, Stop};

/// A cost beyond this counts as this, so that no sum of a solution overflows.
const MAX_COST: u64 = 1 << 57;
/// For each thing so many of the cheapest partners are candidates from the beginning, and all that cost as much as the last of
/// them; twice as many whenever they do not suffice.
const CHEAPEST: usize = 10;

/// The partner of each of `0..count`, an even number, so that the costs of all pairs together are least ("minimum-weight
/// perfect matching" of a complete graph); of an odd number one is its own partner. `cost` is asked once for each pair, lower
/// one first; what is beyond 2^57 counts as that. Room grows with the square of the count.
#[must_use]
pub fn cheapest_pairs(count: u32, cost: impl Fn(u32, u32) -> u64) -> Vec<u32> {
    let mut partners = Partners::new(count as usize, cost);
    let (reach, edges) = partners.first();
    let mut matching = Matching::of_any(reach, edges);
    matching.plant(count as usize);
    while let Stop::AtReach(thing) = matching.run() {
        let (reach, found) = partners.further(thing, matching.reach());
        matching.widen(thing, reach, &found);
    }
    let mates = matching.mates(count as usize);
    // Of an odd number one has no partner.
    (0..).zip(mates).map(|(own, mate)| if mate == NONE { own } else { matching.to(mate) }).collect()
}

/// What there is for each, the cheapest first.
struct Partners {
    count: usize,
    /// Of each pair, as the matching has them.
    weights: Vec<i64>,
    /// Rows of partners.
    order: Vec<u32>,
    /// How many of each row are candidates.
    taken: Vec<usize>,
}

impl Partners {
    fn new(count: usize, cost: impl Fn(u32, u32) -> u64) -> Self {
        let mut weights = vec![0; count * count];
        for a in 0..count {
            for b in a + 1..count {
                let weight = 4 * cost(id(a), id(b)).min(MAX_COST).cast_signed();
                (weights[a * count + b], weights[b * count + a]) = (weight, weight);
            }
        }
        let mut order = Vec::with_capacity(count * count);
        for a in 0..count {
            let from = order.len();
            order.extend((0..id(count)).filter(|&b| b != id(a)));
            order[from..].sort_by_key(|&b| weights[a * count + b as usize]);
        }
        let mut partners = Self { count, weights, order, taken: vec![0; count] };
        for thing in 0..count {
            partners.take(thing, CHEAPEST);
        }
        partners
    }

    /// Makes so many of a row candidates, and all that cost as much as the last of them.
    fn take(&mut self, thing: usize, many: usize) {
        let row = self.row(thing);
        let taken = row.get(..many).and_then(<[u32]>::last).map_or(row.len(), |&last| {
            let most = self.weight(thing, last);
            row.partition_point(|&b| self.weight(thing, b) <= most)
        });
        self.taken[thing] = taken;
    }

    fn row(&self, thing: usize) -> &[u32] {
        let others = self.count - 1;
        &self.order[thing * others..(thing + 1) * others]
    }

    fn weight(&self, a: usize, b: u32) -> i64 {
        self.weights[a * self.count + b as usize]
    }

    /// What is cheaper than this is among the candidates of a thing.
    fn reach(&self, thing: usize) -> i64 {
        self.row(thing).get(self.taken[thing]).map_or(i64::MAX, |&next| self.weight(thing, next))
    }

    /// How far the candidates of each reach at first, and all of them.
    fn first(&self) -> (Vec<i64>, Vec<([u32; 2], i64)>) {
        let of_thing =
            |a: usize| self.row(a)[..self.taken[a]].iter().map(move |&b| [id(a).min(b), id(a).max(b)]);
        let mut pairs: Vec<[u32; 2]> = (0..self.count).flat_map(of_thing).collect();
        pairs.sort_unstable();
        pairs.dedup();
        let edges = pairs.into_iter().map(|[a, b]| ([a, b], self.weight(a as usize, b))).collect();
        ((0..self.count).map(|thing| self.reach(thing)).collect(), edges)
    }

    /// More candidates of one, and how far they reach; `known`: how far those of each did.
    fn further(&mut self, thing: u32, known: &[i64]) -> (i64, Vec<(u32, i64)>) {
        let a = thing as usize;
        let before = self.taken[a];
        self.take(a, 2 * before);
        let more = self.row(a)[before..self.taken[a]].iter().map(|&b| (b, self.weight(a, b)));
        // What is within the reach of the other is there already.
        let found = more.filter(|&(b, weight)| weight >= known[b as usize]).collect();
        (self.reach(a), found)
    }
}
