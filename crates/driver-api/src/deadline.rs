//! How long a driver may take. A driver that takes longer is ended; its port closes with it.

use std::time::Duration;

/// From the start of its process to its description.
pub const START: Duration = Duration::from_secs(5);
/// To take settings.
pub const OPEN: Duration = Duration::from_secs(2);
/// To write a program.
pub const ENCODE: Duration = Duration::from_secs(30);
/// For any other call.
pub const CALL: Duration = Duration::from_secs(1);
/// To look for events. On a busy computer the system alone can take most of a second to read a port.
pub const POLL: Duration = Duration::from_secs(2);
/// To pass a stop on.
pub const STOP: Duration = Duration::from_millis(100);
/// To close.
pub const CLOSE: Duration = Duration::from_millis(500);
