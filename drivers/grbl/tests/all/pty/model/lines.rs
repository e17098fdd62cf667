//! What the controller does with a line.

use std::io::{Read, Write};

use super::Build;
use super::controller::{Controller, PLANNER, State, steps, units};

/// A turn takes about a millisecond.
const TURNS_A_MINUTE: f64 = 60_000.0;
/// A dwell, turns.
const DWELL: u32 = 20;
/// Homing, turns.
const SEARCH: u32 = 50;

impl<P: Read + Write> Controller<P> {
    /// Takes one line, if there is one and nothing keeps it.
    pub fn take_line(&mut self) {
        if let Some((line, turns)) = self.waiting.take() {
            if !self.planner.is_empty() || self.state == State::Hold {
                self.waiting = Some((line, turns));
            } else if turns > 0 {
                self.waiting = Some((line, turns - 1));
            } else {
                self.after_motion(&line);
            }
            return;
        }
        if self.planner.len() >= PLANNER || self.state == State::Hold {
            return;
        }
        while let Some(byte) = self.received.pop_front() {
            if byte == b'\n' {
                let line = std::mem::take(&mut self.line);
                let line = self.arrived(line);
                return self.execute(&line);
            }
            self.line.push(char::from(byte));
        }
    }

    fn arrived(&mut self, line: String) -> String {
        let Some(change) = self.build.change.take_if(|change| change.line == line) else { return line };
        let mut bytes = line.into_bytes();
        bytes[change.at] = change.to;
        String::from_utf8(bytes).expect("ASCII")
    }

    fn execute(&mut self, line: &str) {
        let homing = u8::from(self.build.switches);
        match line {
            "$I" => self.say("[VER:1.1h.20190830:model]\r\n[OPT:V,15,128]\r\nok"),
            // It takes too long to write while something moves (`system.c`).
            "$$" | "$#" if !matches!(self.state, State::Idle | State::Alarm) => self.say("error:8"),
            "$#" => self.say("[G54:0.000,0.000,0.000]\r\n[PRB:0.000,0.000,0.000:0]\r\nok"),
            "$$" => {
                let Build { bend_travel, bend_rate, steps_a_turn, .. } = self.build;
                let (soft, travel) = (u8::from(bend_travel.is_some()), bend_travel.unwrap_or(200.0));
                let fastest = units(steps_a_turn) * TURNS_A_MINUTE;
                let bend = bend_rate.unwrap_or(fastest);
                self.say(&format!(
                    "$10=1\r\n$13=0\r\n$20={soft}\r\n$22={homing}\r\n$32=0\r\n$100=80.000\r\n$101=80.000\r\n$102=80.000"
                ));
                self.say(&format!(
                    "$110={fastest:.3}\r\n$111={fastest:.3}\r\n$112={bend:.3}\r\n$132={travel:.3}\r\nok"
                ));
            }
            "$H" if homing == 0 => self.say("error:5"),
            "$H" => self.waiting = Some((line.to_owned(), SEARCH)),
            "$X" if self.state == State::Alarm => {
                self.state = State::Idle;
                self.say("[MSG:Caution: Unlocked]\r\nok");
            }
            "" | "$X" => self.say("ok"),
            _ if self.state == State::Alarm => self.say("error:9"),
            // Where the spindle is off already, nothing has to wait for motion.
            "M5" if self.farthest.is_none() => self.say("ok"),
            "M5" | "M3 S1000" | "M8" | "M9" => self.waiting = Some((line.to_owned(), 0)),
            _ if line.starts_with("G92 ") => self.waiting = Some((line.to_owned(), 0)),
            _ if line.starts_with("G4 P") => self.waiting = Some((line.to_owned(), DWELL)),
            _ => self.plan(line),
        }
    }

    fn plan(&mut self, line: &str) {
        let jog = line.strip_prefix("$J=G91 G21 ");
        let before = (self.planned, self.relative);
        let words = jog.unwrap_or(line).split(' ').try_for_each(|word| self.word(word, jog.is_some()));
        if let Err(code) = words {
            (self.planned, self.relative) = before;
            return self.say(&format!("error:{code}"));
        }
        if self.build.bend_travel.is_some_and(|travel| !(0.0..=travel).contains(&self.planned[2])) {
            return self.kill(Some(2));
        }
        let target = self.planned.map(steps);
        if target != *self.planner.back().unwrap_or(&self.at) {
            self.planner.push_back(target);
        }
        self.say("ok");
    }

    fn word(&mut self, word: &str, jog: bool) -> Result<(), u32> {
        let (letter, number) = word.split_at_checked(1).ok_or(1_u32)?;
        let value: f64 = number.parse().map_err(|_| 2_u32)?;
        match word {
            "G90" => self.relative = false,
            "G91" => self.relative = true,
            "G0" | "G1" | "G21" | "G94" => {}
            _ if letter == "F" && value > 0.0 => {}
            _ if letter == "F" => return Err(22),
            _ => {
                let axis = ["X", "Y", "Z"].iter().position(|known| *known == letter).ok_or(20_u32)?;
                let zero = if self.relative || jog { self.planned[axis] } else { self.offset[axis] };
                self.planned[axis] = zero + value;
            }
        }
        Ok(())
    }

    fn after_motion(&mut self, line: &str) {
        match line {
            "$H" => {
                self.state = State::Idle;
                // Its switches are where the marks are.
                self.stand_at_marks();
                self.planned = [0.0; 3];
            }
            "M8" => self.record.cuts.push(self.really[0]),
            "M3 S1000" => self.farthest = Some(self.really[2]),
            "M5" => {
                if let Some(farthest) = self.farthest.take() {
                    self.record.bends.push([self.really[0], self.really[1], farthest]);
                }
            }
            _ if line.starts_with("G92 ") => {
                self.offset = self.at.map(units);
                self.until_offset = 0;
            }
            _ => {}
        }
        self.say("ok");
    }
}
