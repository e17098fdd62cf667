//! A port and a clock for [`Timed`].

use std::time::Instant;

use wirebend_driver_api::serial::Line;
use wirebend_driver_api::{ArmedReply, Batch, DriverError, Event, MachineSession, Run, Sent};

use crate::Settings;
use crate::timed::Timed;

/// A connection to a machine.
pub(crate) struct Session {
    timed: Timed,
    /// Gone once it has failed.
    line: Option<Box<dyn Line>>,
    opened: Instant,
}

impl Session {
    /// On a line that has been opened just now.
    pub fn new(line: Box<dyn Line>, settings: Settings) -> Self {
        Self { timed: Timed::new(settings), line: Some(line), opened: Instant::now() }
    }

    /// Lets the time pass, and sends what is due.
    fn turn(&mut self) {
        let now = self.opened.elapsed();
        self.timed.pass(now);
        let output = self.timed.take_output();
        let written =
            self.line.as_mut().map(|line| if output.is_empty() { Ok(()) } else { line.write(&output) });
        if matches!(written, Some(Err(_))) {
            self.lose();
        }
    }

    fn read(&mut self) {
        match self.line.as_mut().map(|line| line.read()) {
            Some(Ok(bytes)) => self.timed.receive(&bytes, self.opened.elapsed()),
            Some(Err(_)) => self.lose(),
            None => {}
        }
    }

    fn lose(&mut self) {
        self.line = None;
        self.timed.unplugged();
    }
}

impl MachineSession for Session {
    fn arm(&mut self, run: &Run) -> Result<ArmedReply, DriverError> {
        self.turn();
        self.timed.arm(run).map(|()| ArmedReply::default())
    }

    fn send(&mut self, batch: &Batch) -> Result<Sent, DriverError> {
        let sent = self.timed.send(batch)?;
        self.turn();
        Ok(sent)
    }

    fn stop(&mut self) -> Result<(), DriverError> {
        self.timed.stop();
        Ok(())
    }

    fn poll(&mut self) -> Result<Option<Event>, DriverError> {
        self.read();
        self.turn();
        Ok(self.timed.next_event())
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;
    use std::io;
    use std::rc::Rc;

    use wirebend_driver_api::{NumberedStep, Step};

    use super::*;

    /// What has been written, and whether the cable is in.
    #[derive(Default)]
    struct Cable {
        written: Vec<u8>,
        pulled: bool,
    }

    struct End(Rc<RefCell<Cable>>);

    impl Line for End {
        fn read(&mut self) -> io::Result<Vec<u8>> {
            if self.0.borrow().pulled { Err(io::ErrorKind::BrokenPipe.into()) } else { Ok(Vec::new()) }
        }

        fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
            let mut cable = self.0.borrow_mut();
            cable.written.extend_from_slice(bytes);
            if cable.pulled { Err(io::ErrorKind::BrokenPipe.into()) } else { Ok(()) }
        }
    }

    /// Everything takes no time, so that the clock of the computer has no say.
    fn session(cable: &Rc<RefCell<Cable>>) -> Session {
        let settings =
            Settings { boot_s: 0.0, command_s: 0.0, feed_rate_mm_per_s: 1e300, ..Settings::default() };
        Session::new(Box::new(End(cable.clone())), settings)
    }

    fn events(session: &mut Session) -> Vec<Event> {
        std::iter::from_fn(|| session.poll().unwrap()).collect()
    }

    fn run_of_one(session: &mut Session) -> Result<Sent, DriverError> {
        session.arm(&Run {
            job_hash: "0".repeat(64),
            name: "sample".to_owned(),
            wire: 0,
            steps: 1,
            ..Run::default()
        })?;
        let step = Step { feed_mm: 38.0, ..Step::default() };
        session.send(&Batch { steps: vec![NumberedStep { n: 1, step }], last: true })
    }

    #[test]
    fn a_wire_goes_over_the_line() {
        let cable = Rc::default();
        let mut session = session(&cable);
        assert!(matches!(events(&mut session)[0], Event::Connected { .. }));
        run_of_one(&mut session).unwrap();
        let ends = events(&mut session);
        assert_eq!(cable.borrow().written, b"manual\nf38\n");
        assert!(matches!(ends[ends.len() - 2..], [Event::Done { n: 1 }, Event::Finished]), "{ends:?}");
    }

    #[test]
    fn a_line_that_fails_is_reported_once() {
        for while_writing in [false, true] {
            let cable = Rc::default();
            let mut session = session(&cable);
            events(&mut session);
            cable.borrow_mut().pulled = true;
            if while_writing {
                run_of_one(&mut session).unwrap();
            }
            let faults = events(&mut session);
            let faults =
                faults.iter().filter(|event| matches!(event, Event::Fault { disconnected: true, .. }));
            assert_eq!(faults.count(), 1, "while writing: {while_writing}");
            assert_eq!(run_of_one(&mut session).unwrap_err().code, "not-homed");
        }
    }
}
