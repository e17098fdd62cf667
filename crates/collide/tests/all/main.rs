//! Distances and contacts against sampling that shares no code with them.

mod distances;
mod heads;
mod sampled;
mod sweeps;
