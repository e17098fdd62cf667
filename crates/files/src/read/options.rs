//! How a file is to be read.

use wirebend_core::bend::Convention;
use wirebend_core::units::Length;

/// What the numbers of a file measure.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
)]
pub enum LengthUnit {
    /// Millimetres.
    #[default]
    #[serde(rename = "mm")]
    Millimetre,
    /// Centimetres.
    #[serde(rename = "cm")]
    Centimetre,
    /// Metres.
    #[serde(rename = "m")]
    Metre,
    /// Inches of 25.4 mm.
    #[serde(rename = "inch")]
    Inch,
}

impl LengthUnit {
    /// Every unit.
    pub const ALL: [Self; 4] = [Self::Millimetre, Self::Centimetre, Self::Metre, Self::Inch];

    /// How many millimetres one of it is.
    #[must_use]
    pub const fn mm(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Centimetre => 10.0,
            Self::Metre => 1000.0,
            Self::Inch => 25.4,
        }
    }

    /// "mm", "cm", "m" or "inch".
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "inch",
        }
    }

    /// The unit that a word names, as files and people write it ("millimeter", "Inches", "in").
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Some(match word.trim().to_ascii_lowercase().as_str() {
            "mm" | "millimeter" | "millimeters" | "millimetre" | "millimetres" => Self::Millimetre,
            "cm" | "centimeter" | "centimeters" | "centimetre" | "centimetres" => Self::Centimetre,
            "m" | "meter" | "meters" | "metre" | "metres" => Self::Metre,
            "in" | "inch" | "inches" => Self::Inch,
            _ => return None,
        })
    }
}

/// Settings of every reader; the default reads millimetres and welds at 1 µm.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// A factor on all lengths, applied after the unit.
    pub scale: f64,
    /// What the numbers measure. None: what the file says, else millimetres (which is noted).
    pub units: Option<LengthUnit>,
    /// Vertices this close become one, after scaling.
    pub weld: Length,
    /// Whether the sides of all faces become the wireframe. Polygons get no diagonals.
    pub face_edges: bool,
    /// Centreline radius of every bend of an LRA table without a CLR column. Lengths from corner to corner
    /// need none.
    pub clr: Option<Length>,
    /// How the machine that a program was written for counts its axes.
    pub convention: Convention,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self {
            scale: 1.0,
            units: None,
            weld: Length::from_mm(1e-3).unwrap_or_default(),
            face_edges: false,
            clr: None,
            convention: Convention::default(),
        }
    }
}
