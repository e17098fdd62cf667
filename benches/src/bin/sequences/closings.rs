//! How long it takes to close the joints of many drawn wires.

use anyhow::Result;
use wirebend_accuracy::Closing;
use wirebend_benches::timed;
use wirebend_core::simulate::{ErrorModel, ErrorTerm};

use wirebend_benches::frames::truss::{DEPTH_OF_TEST, Truss};

const DRAWS: u64 = 400;
/// s.
const AIM: f64 = 1.0;

/// The truss of the accuracy test of Bend-Forming: feeds off by 0.2 mm, each strut bowed by 3 % in a direction of its own.
pub fn measure() -> Result<()> {
    let truss = Truss::new(1, DEPTH_OF_TEST);
    let (model, faces) = (truss.walked("accuracy-test"), truss.faces());
    let errors = ErrorModel {
        feed_mm: ErrorTerm { bias: 0.0, sigma: 0.2 },
        curvature: ErrorTerm { bias: 0.03, sigma: 0.0 },
        ..ErrorModel::default()
    };
    let (ms, surface) = timed(3, || {
        let mut sum = 0.0;
        for run in 0..DRAWS {
            let draw = model.draw(&errors, 1, run)?;
            sum += model.bowed(&draw)?.close(Closing::Aligned, &draw).surface_rms(&faces);
        }
        #[allow(clippy::cast_precision_loss)] // hundreds
        Ok(sum / DRAWS as f64)
    })?;
    println!(
        "{DRAWS} wires of a truss of one ring, bowed by 3 %, closed on one processor: {:.2} s (at most {AIM} wanted), surface {surface:.4} mm; \
         the authors of Bend-Forming take about a minute for each",
        ms / 1000.0
    );
    Ok(())
}
