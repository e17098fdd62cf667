//! A bender whose axes a person brings to zero, and a job for it.

use std::time::Instant;

use super::bender::Bender;
use super::runs::{LOOK, PATIENCE, Shop};
use crate::Ran;

pub struct Bench {
    pub shop: Shop,
    pub bender: Bender,
}

impl Bench {
    pub fn new() -> Self {
        Self { shop: Shop::on("u-sample.obj", "grbl-bender"), bender: Bender::without_switches() }
    }

    /// A program that was killed leaves its terminal locked: the machine is plugged in anew.
    pub fn plugged_in_anew(self) -> Self {
        let Self { shop, bender } = self;
        bender.model.end();
        Self { shop, bender: Bender::without_switches() }
    }

    pub fn run_with<'a>(&'a self, more: &[&'a str]) -> Vec<&'a str> {
        [&["run", "a.wbjob", "--port", &self.bender.port], more].concat()
    }

    pub fn jog_with<'a>(&'a self, more: &[&'a str]) -> Vec<&'a str> {
        [&["jog", "-m", "grbl-bender", "--port", &self.bender.port], more].concat()
    }

    pub fn run(&self, more: &[&str]) -> Ran {
        self.shop.run(&self.run_with(more))
    }

    pub fn jog(&self, more: &[&str]) -> Ran {
        self.shop.run(&self.jog_with(more))
    }

    /// Waits until the machine has come so far.
    #[track_caller]
    pub fn until(&self, so_far: impl Fn(&Bender) -> bool) {
        let begun = Instant::now();
        while !so_far(&self.bender) {
            assert!(begun.elapsed() < PATIENCE, "it does not come so far: {:?}", self.bender.model.now());
            std::thread::sleep(LOOK);
        }
    }
}
