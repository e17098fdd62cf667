//! A workshop: an application with its drivers, a job, and what an operator reports.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, LazyLock};
use std::time::Duration;

use serde_json::{Value, json};
use wirebend_error::ProblemReport;
use wirebend_operation::{
    Answer, Answers, ConnectRequest, Decided, MachineState, OperationError, Operator, OperatorEvent, Order,
    Phase, Question, Record, Repeat, RunHow, RunRequest, RunResponse,
};
use wirebend_planning::job::SimulatedAs;
use wirebend_planning::pauses::StepPause;
use wirebend_planning::plan::PlanRequest;
use wirebend_planning::{DesignInput, DriverFolders, Input, Installation, NoProgress, PlanChoices};

/// The root of the repository.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn drivers() -> DriverFolders {
    DriverFolders {
        own: Some(vec![wirebend_tests_built::shipped_drivers()]),
        program: Some(wirebend_tests_built::driver_child()),
        ..DriverFolders::default()
    }
}

/// Nothing that is waited for takes so long.
const PATIENCE: Duration = Duration::from_secs(20);

/// What a front end that knows the schema expects of an event.
static SCHEMA: LazyLock<jsonschema::Validator> = LazyLock::new(|| {
    let settings = schemars::generate::SchemaSettings::draft2020_12().for_serialize();
    let schema = settings.into_generator().into_root_schema_for::<OperatorEvent>();
    jsonschema::validator_for(&schema.to_value()).unwrap()
});

/// Writes a machine of one's own.
fn profile(folder: &tempfile::TempDir, keys: &Value) {
    let mut profile = json!({"schema_version": 1, "kind": "machine"});
    profile.as_object_mut().unwrap().extend(keys.as_object().unwrap().clone());
    let machines = folder.path().join("machines");
    std::fs::create_dir(&machines).unwrap();
    let file = machines.join(format!("{}.json", keys["id"].as_str().unwrap()));
    std::fs::write(file, profile.to_string()).unwrap();
}

/// A folder for journals and profiles, and an application that knows them.
pub struct Shop {
    pub folder: tempfile::TempDir,
    pub app: Arc<Installation>,
}

impl Shop {
    /// With the shipped machines.
    pub fn new() -> Self {
        Self::with(tempfile::tempdir().unwrap(), &[])
    }

    fn with(folder: tempfile::TempDir, more: &[PathBuf]) -> Self {
        let mut drivers = drivers();
        drivers.own.iter_mut().for_each(|own| own.extend_from_slice(more));
        let app = Installation::new(&[folder.path().to_owned()]).unwrap().with_drivers(drivers);
        assert!(app.refused_profiles().is_empty(), "{:?}", app.refused_profiles());
        let app = Arc::new(app.with_runs(Some(folder.path().join("runs"))));
        Self { folder, app }
    }

    /// With a machine `odd`, whose driver misbehaves: `conduct` is the name of its library, which states when and how.
    pub fn odd(conduct: &str, settings: impl FnOnce(&Path) -> Value) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let drivers = folder.path().join("drivers");
        std::fs::create_dir(&drivers).unwrap();
        wirebend_tests_built::place_hostile(&drivers.join(format!("{conduct}.so")));
        let driver = json!({"id": "hostile", "settings": settings(folder.path())});
        profile(
            &folder,
            &json!({"id": "odd", "inherits": "wirebend-kit", "driver": driver, "export": {"native": "hostile-text"}}),
        );
        Self::with(folder, &[drivers])
    }

    /// With a machine that has other settings than the one that it inherits from.
    pub fn with_machine(id: &str, inherits: &str, settings: &Value) -> Self {
        let folder = tempfile::tempdir().unwrap();
        profile(&folder, &json!({"id": id, "inherits": inherits, "driver": {"settings": settings}}));
        Self::with(folder, &[])
    }

    /// With a machine `odd` that is kept in a file, and to which something happens at a step.
    pub fn faulty(at: u32, how: &str) -> Self {
        Self::odd(
            "hostile",
            |folder| json!({"machine": folder.join("kept"), "faults": [{"at": at, "how": how}]}),
        )
    }

    /// Every step that the machine in the file has done, in order.
    pub fn made(&self) -> Vec<u64> {
        let kept = std::fs::read(self.folder.path().join("kept")).unwrap();
        let kept: Value = serde_json::from_slice(&kept).unwrap();
        kept["made"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect()
    }

    pub fn job(&self, example: &str, machine: &str) -> Input {
        self.pausing(example, machine, Vec::new())
    }

    /// A job with pause points.
    pub fn pausing(&self, example: &str, machine: &str, pauses: Vec<StepPause>) -> Input {
        let design = DesignInput::file(root().join("examples").join(example));
        let choices =
            PlanChoices { machine: Some(machine.to_owned()), double: true, ..PlanChoices::default() };
        let request =
            PlanRequest { design, choices, output: None, make_job: true, pauses, despite_errors: false };
        let planned = wirebend_planning::plan::plan(&self.app, &request, &NoProgress).unwrap();
        Input::Bytes { name: "a.wbjob".to_owned(), bytes: planned.contents }
    }

    /// A wire of 8 steps.
    pub fn cube(&self, machine: &str) -> Input {
        self.job("cube-8-edges.obj", machine)
    }

    /// The job by the command line.
    pub fn run(&self, job: &Input, port: &str, how: RunHow) -> Result<RunResponse, OperationError> {
        let request = RunRequest {
            job: job.clone(),
            machine: None,
            material: None,
            despite_errors: false,
            port: Some(port.to_owned()),
            wire: None,
            repeat: Repeat::default(),
            how,
            simulated_as: SimulatedAs::default(),
            answers: Answers { confirmed: true, ..Answers::default() },
            accept_settings: false,
            record: None,
        };
        wirebend_operation::run::run(&self.app, &request, &NoProgress)
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
        let request = ConnectRequest { port: port.map(str::to_owned), ..ConnectRequest::simulated(machine) };
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

/// The order to arm a wire.
pub fn arm(wire: usize, accept_settings: bool) -> Order {
    Order::Arm { wire: Some(wire), repeat: Repeat::default(), accept_settings, despite_errors: false }
}

/// The order to resume a wire; which job is meant is said with it.
pub fn resume(decided: Option<Decided>) -> Order {
    Order::ResumeRun { job_hash: String::new(), wire: 0, decided, accept_settings: false }
}

/// The order to give up a wire; which job is meant is said with it.
pub fn abandon(wire: usize) -> Order {
    Order::Abandon { job_hash: String::new(), wire }
}

/// Where a person sits: the buttons, and what is reported.
pub struct Seat {
    pub operator: Operator,
    pub events: Receiver<OperatorEvent>,
}

impl Seat {
    /// The next event; it fits its schema.
    #[track_caller]
    pub fn next(&self) -> OperatorEvent {
        let Ok(event) = self.events.recv_timeout(PATIENCE) else {
            panic!("nothing more is reported: {:#?}", self.operator.state())
        };
        let value = serde_json::to_value(&event).unwrap();
        let wrong: Vec<String> = SCHEMA.iter_errors(&value).map(|error| error.to_string()).collect();
        assert!(wrong.is_empty(), "{wrong:?}: {value}");
        event
    }

    /// Waits for an event in which something is found. A problem that the test does not wait for fails it.
    #[track_caller]
    pub fn until<T>(&self, find: impl Fn(&OperatorEvent) -> Option<T>) -> T {
        loop {
            let event = self.next();
            if let Some(found) = find(&event) {
                return found;
            }
            if let OperatorEvent::Problem(ProblemReport { code, message, .. }) = event {
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
        let ProblemReport { code, message, .. } = self.until_report();
        (code, message)
    }

    /// The same with what can be done about it.
    #[track_caller]
    pub fn until_report(&self) -> ProblemReport {
        self.until(|event| match event {
            OperatorEvent::Problem(report) => Some(report.clone()),
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

    /// Waits until a step of the wire is done.
    #[track_caller]
    pub fn until_made(&self, step: u32) {
        self.until(|event| match event {
            OperatorEvent::Machine(wirebend_operation::MachineEvent::Wire { made, .. }) => {
                (*made >= step).then_some(())
            }
            _ => None,
        });
    }

    #[track_caller]
    pub fn order(&self, order: &Value) -> &Self {
        self.operator.order(serde_json::from_value(order.clone()).unwrap()).unwrap();
        self
    }

    #[track_caller]
    pub fn refused(&self, order: Order) -> (&'static str, String) {
        let error = self.operator.order(order).unwrap_err();
        (error.code().as_str(), error.to_string())
    }

    #[track_caller]
    pub fn says(&self, answer: Answer) -> Question {
        let question = self.until_question();
        self.operator.answer(question.id, answer).unwrap();
        question
    }

    pub fn arm(&self, job: &Input) {
        self.operator.order_wire(arm(0, false), job.clone()).unwrap();
    }

    /// Arms a wire with a yes, and starts it.
    #[track_caller]
    pub fn start(&self, job: &Input) {
        self.arm(job);
        self.says(Answer::Yes);
        self.until_phase(Phase::Armed);
        self.order(&json!({"order": "start"}));
    }

    /// Resumes a wire.
    #[track_caller]
    pub fn resume(&self, job: &Input) {
        self.operator.order_wire(resume(None), job.clone()).unwrap();
    }

    #[track_caller]
    pub fn home(&self) {
        self.order(&json!({"order": "home"}));
        self.until_phase(Phase::Ready);
    }
}
