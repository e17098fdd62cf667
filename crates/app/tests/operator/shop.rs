//! A workshop: an application with its drivers, a job, and what an operator tells.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, LazyLock};
use std::time::Duration;

use serde_json::{Value, json};
use wirebend_app::{
    Answer, App, AppError, ConnectRequest, DesignInput, Input, MachineState, NoProgress, Operator,
    OperatorEvent, Order, Phase, PlanChoices, PlanRequest, Question, Record, Request, Response, RunHow,
    RunRequest, RunResponse,
};

use crate::cases;

/// Nothing that is waited for takes so long.
const PATIENCE: Duration = Duration::from_secs(20);

/// What a front end that knows the schema expects of an event.
static SCHEMA: LazyLock<jsonschema::Validator> = LazyLock::new(|| {
    let settings = schemars::generate::SchemaSettings::draft2020_12().for_serialize();
    let schema = settings.into_generator().into_root_schema_for::<OperatorEvent>();
    jsonschema::validator_for(&schema.to_value()).unwrap()
});

/// A folder for journals and profiles, and an application that knows them.
pub struct Shop {
    pub folder: tempfile::TempDir,
    pub app: Arc<App>,
}

impl Shop {
    /// With the shipped machines.
    pub fn new() -> Self {
        Self::with(tempfile::tempdir().unwrap(), &[])
    }

    fn with(folder: tempfile::TempDir, more: &[PathBuf]) -> Self {
        let mut drivers = cases::drivers();
        drivers.own.iter_mut().for_each(|own| own.extend_from_slice(more));
        let app = App::new(&[folder.path().to_owned()]).unwrap().with_drivers(drivers);
        assert!(app.refused_profiles().is_empty(), "{:?}", app.refused_profiles());
        let app = Arc::new(app.with_runs(Some(folder.path().join("runs"))));
        Self { folder, app }
    }

    /// With a machine `odd`, whose driver misbehaves: `conduct` is the name of its library, which says when and how.
    pub fn odd(conduct: &str, settings: impl FnOnce(&Path) -> Value) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let drivers = folder.path().join("drivers");
        std::fs::create_dir(&drivers).unwrap();
        std::fs::copy(wirebend_tests_built::driver("hostile"), drivers.join(format!("{conduct}.so")))
            .unwrap();
        let profile = json!({"schema_version": 1, "kind": "machine", "id": "odd", "inherits": "wirebend-kit",
            "driver": {"id": "hostile", "settings": settings(folder.path())},
            "export": {"native": "hostile-text"}});
        std::fs::create_dir(folder.path().join("machines")).unwrap();
        std::fs::write(folder.path().join("machines/odd.json"), profile.to_string()).unwrap();
        Self::with(folder, &[drivers])
    }

    /// With a machine `odd` that is kept in a file, and to which something happens at a step.
    pub fn faulty(at: u32, how: &str) -> Self {
        Self::odd(
            "hostile",
            |folder| json!({"machine": folder.join("kept"), "faults": [{"at": at, "how": how}]}),
        )
    }

    /// Every step that the machine in the file has made, in order.
    pub fn made(&self) -> Vec<u64> {
        let kept = std::fs::read(self.folder.path().join("kept")).unwrap();
        let kept: Value = serde_json::from_slice(&kept).unwrap();
        kept["made"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect()
    }

    /// A job of an example.
    pub fn job(&self, example: &str, machine: &str) -> Input {
        let design = DesignInput::file(cases::root().join("examples").join(example));
        let choices =
            PlanChoices { machine: Some(machine.to_owned()), double: true, ..PlanChoices::default() };
        let request = PlanRequest { design, choices, output: None, make_job: true, despite_errors: false };
        match self.app.run(&Request::Plan(request), &NoProgress).unwrap() {
            Response::Plan(planned) => Input::Bytes { name: "a.wbjob".to_owned(), bytes: planned.contents },
            other => panic!("a plan answered {other:?}"),
        }
    }

    /// A wire of 8 steps.
    pub fn cube(&self, machine: &str) -> Input {
        self.job("cube-8-edges.obj", machine)
    }

    /// The job by the command line.
    pub fn run(&self, job: &Input, port: &str, how: RunHow) -> Result<RunResponse, AppError> {
        let request = RunRequest {
            job: job.clone(),
            port: Some(port.to_owned()),
            wire: None,
            how,
            confirmed: true,
            axes_at_zero: false,
            head_at_deg: None,
            accept_settings: false,
            record: None,
        };
        match self.app.run(&Request::Run(request), &NoProgress)? {
            Response::Run(made) => Ok(*made),
            other => panic!("a run answered {other:?}"),
        }
    }

    /// The only record that there is.
    pub fn record(&self) -> Record {
        let mut found = std::fs::read_dir(self.folder.path().join("runs")).unwrap();
        let is_record = |path: &PathBuf| path.to_string_lossy().ends_with(".record.json");
        let file = found.find_map(|entry| Some(entry.unwrap().path()).filter(is_record)).unwrap();
        serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap()
    }

    /// The only record of a head.
    pub fn head_record(&self) -> PathBuf {
        let mut found = std::fs::read_dir(self.folder.path().join("runs/heads")).unwrap();
        found.next().unwrap().unwrap().path()
    }

    pub fn connect(&self, machine: &str, port: Option<&str>) -> Seat {
        let (sender, events) = channel();
        let request = ConnectRequest { machine: machine.to_owned(), port: port.map(str::to_owned) };
        let listener = move |event: &OperatorEvent| drop(sender.send(event.clone()));
        let operator = Operator::connect(Arc::clone(&self.app), request, Arc::new(listener));
        Seat { operator, events }
    }

    /// A simulated machine that has answered.
    pub fn simulated(&self, port: &str) -> Seat {
        let seat = self.connect("wirebend-kit", Some(port));
        seat.until_phase(Phase::Connected);
        seat
    }
}

/// Where a person sits: the buttons, and what is told.
pub struct Seat {
    pub operator: Operator,
    pub events: Receiver<OperatorEvent>,
}

impl Seat {
    /// The next event; it fits its schema.
    #[track_caller]
    pub fn next(&self) -> OperatorEvent {
        let Ok(event) = self.events.recv_timeout(PATIENCE) else {
            panic!("nothing more is told: {:#?}", self.operator.state())
        };
        let value = serde_json::to_value(&event).unwrap();
        let wrong: Vec<String> = SCHEMA.iter_errors(&value).map(|error| error.to_string()).collect();
        assert!(wrong.is_empty(), "{wrong:?}: {value}");
        event
    }

    /// Waits for an event in which something is found. A problem that nobody waits for fails the test.
    #[track_caller]
    pub fn until<T>(&self, find: impl Fn(&OperatorEvent) -> Option<T>) -> T {
        loop {
            let event = self.next();
            if let Some(found) = find(&event) {
                return found;
            }
            if let OperatorEvent::Problem { code, message } = event {
                panic!("{code}: {message}");
            }
        }
    }

    #[track_caller]
    pub fn until_state(&self, fits: impl Fn(&MachineState) -> bool) -> MachineState {
        self.until(|event| match event {
            OperatorEvent::State(state) if fits(state) => Some((**state).clone()),
            _ => None,
        })
    }

    /// Waits until the machine is in a phase; in one in which it rests, with nothing more to come.
    #[track_caller]
    pub fn until_phase(&self, phase: Phase) -> MachineState {
        let moves = matches!(phase, Phase::Homing | Phase::Moving | Phase::Making | Phase::Holding);
        self.until_state(|state| state.phase == phase && (moves || !state.busy))
    }

    #[track_caller]
    pub fn until_problem(&self) -> (String, String) {
        self.until(|event| match event {
            OperatorEvent::Problem { code, message } => Some((code.clone(), message.clone())),
            _ => None,
        })
    }

    #[track_caller]
    pub fn until_question(&self) -> Question {
        self.until(|event| match event {
            OperatorEvent::Question(question) => Some(question.clone()),
            _ => None,
        })
    }

    #[track_caller]
    pub fn until_run(&self) -> RunResponse {
        self.until(|event| match event {
            OperatorEvent::RunEnded(run) => Some((**run).clone()),
            _ => None,
        })
    }

    /// Waits until a step of the wire is made.
    #[track_caller]
    pub fn until_made(&self, step: u32) {
        self.until(|event| match event {
            OperatorEvent::News(wirebend_app::News::Wire { made, .. }) => (*made >= step).then_some(()),
            _ => None,
        });
    }

    #[track_caller]
    pub fn order(&self, order: &Value) -> &Self {
        self.operator.order(serde_json::from_value(order.clone()).unwrap()).unwrap();
        self
    }

    /// Why an order is refused.
    #[track_caller]
    pub fn refused(&self, order: Order) -> (&'static str, String) {
        let error = self.operator.order(order).unwrap_err();
        (error.code(), error.to_string())
    }

    #[track_caller]
    pub fn says(&self, answer: Answer) -> Question {
        let question = self.until_question();
        self.operator.answer(question.id, answer).unwrap();
        question
    }

    pub fn arm(&self, job: &Input) {
        let order = Order::Arm { job: job.clone(), wire: 0, accept_settings: false };
        self.operator.order(order).unwrap();
    }

    /// Arms a wire with a yes, and starts it.
    #[track_caller]
    pub fn start(&self, job: &Input) {
        self.arm(job);
        self.says(Answer::Yes);
        self.until_phase(Phase::Armed);
        self.order(&json!({"order": "start"}));
    }

    /// Goes on with a wire.
    #[track_caller]
    pub fn resume(&self, job: &Input) {
        let order = Order::ResumeRun { job: job.clone(), wire: 0, decided: None, accept_settings: false };
        self.operator.order(order).unwrap();
    }

    #[track_caller]
    pub fn home(&self) {
        self.order(&json!({"order": "home"}));
        self.until_phase(Phase::Ready);
    }
}
