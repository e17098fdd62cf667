//! Examines one file without using it: `wirebend profile check`.

use std::path::Path;

use crate::layer::Layer;
use crate::library::{Library, read_file};
use crate::{Kind, MachineProfile, ProfileError, Resolved};

/// What a sound file turned out to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// Kind.
    pub kind: Kind,
    /// Id.
    pub id: String,
    /// Whether it only serves to be inherited from.
    pub is_abstract: bool,
    /// Ids from the profile itself to its last ancestor.
    pub chain: Vec<String>,
    /// The complete machine, its parents merged in; `None` for other kinds and for abstract ones.
    pub machine: Option<Resolved<MachineProfile>>,
}

/// Examines the text of a profile; its parents are looked for among the shipped profiles.
///
/// # Errors
/// All rules that the text breaks; what keeps it from being read hides the rest.
pub fn check_text(file: &str, text: &str) -> Result<Checked, Vec<ProfileError>> {
    let library = Library::shipped().map_err(|error| vec![error])?;
    let layer = Layer::read(file, text.as_bytes(), false).map_err(|error| vec![error])?;
    check(library, layer)
}

/// Examines a profile file; its parents are looked for among the shipped profiles and, when the
/// file lies in the folder of its kind, such as `machines/`, in that profile folder.
///
/// # Errors
/// All rules that the file breaks; what keeps it from being read hides the rest.
pub fn check_file(path: &Path) -> Result<Checked, Vec<ProfileError>> {
    let mut library = Library::shipped().map_err(|error| vec![error])?;
    let layer = read_file(path).map_err(|error| vec![error])?;
    let folder = path.parent().filter(|parent| parent.ends_with(layer.kind.folder()));
    if let Some(root) = folder.and_then(Path::parent) {
        let root = if root.as_os_str().is_empty() { Path::new(".") } else { root };
        // What is wrong with its neighbours is not asked here.
        library.add_folder(root);
    }
    check(library, layer)
}

impl Library {
    /// Examines the text of a profile that is to be written to `file`; its parents are looked for among
    /// the profiles of this library, where it takes the place of one with its id.
    ///
    /// # Errors
    /// All rules that the text breaks; what keeps it from being read hides the rest.
    pub fn check(&self, file: &str, text: &str) -> Result<Checked, Vec<ProfileError>> {
        let layer = Layer::read(file, text.as_bytes(), false).map_err(|error| vec![error])?;
        check(self.clone(), layer)
    }

    /// As [`Library::check`], of a profile that is passed on in a file of any name, on its own or with others. Lines are those of `text`.
    ///
    /// # Errors
    /// All rules that the text breaks; what keeps it from being read hides the rest.
    pub fn check_shared(&self, file: &str, text: &str) -> Result<Checked, Vec<ProfileError>> {
        let layer = Layer::read_shared(file, text.as_bytes(), false).map_err(|error| vec![error])?;
        check(self.clone(), layer)
    }

    /// As [`Library::with`], of a profile that is passed on in a file of any name, on its own or with others.
    ///
    /// # Errors
    /// The first thing that makes the text no profile.
    pub fn with_shared(&self, file: &str, text: &str) -> Result<Self, ProfileError> {
        let mut library = self.clone();
        library.replace(Layer::read_shared(file, text.as_bytes(), false)?);
        Ok(library)
    }

    /// This library with the text of a profile more, which takes the place of one with its id.
    ///
    /// # Errors
    /// The first thing that makes the text no profile. Whether it keeps the rules is for [`Library::check`] to say.
    pub fn with(&self, file: &str, text: &str) -> Result<Self, ProfileError> {
        let mut library = self.clone();
        library.replace(Layer::read(file, text.as_bytes(), false)?);
        Ok(library)
    }
}

fn check(mut library: Library, layer: Layer) -> Result<Checked, Vec<ProfileError>> {
    let known = library.layer(layer.kind, &layer.id);
    if known.is_some_and(|known| known.shipped && !is_shipped_file(&layer, known)) {
        let (place, kind, id) = (layer.place("id"), layer.kind, layer.id);
        return Err(vec![ProfileError::ShadowsShipped { place, kind, id }]);
    }
    library.remove(layer.kind, &layer.id);
    library.replace(layer.clone());
    let errors = library.errors_of(&layer);
    if !errors.is_empty() {
        return Err(errors);
    }
    let chain = library.chain(&layer).map_err(|error| vec![error])?;
    let is_machine = layer.kind == Kind::Machine && !layer.is_abstract;
    Ok(Checked {
        machine: is_machine.then(|| library.resolve(&layer)).transpose()?,
        kind: layer.kind,
        is_abstract: layer.is_abstract,
        chain: chain.iter().map(|layer| layer.id.clone()).collect(),
        id: layer.id,
    })
}

/// Whether a file is a shipped profile itself, as in a checkout of the program's sources.
fn is_shipped_file(layer: &Layer, shipped: &Layer) -> bool {
    layer.text == shipped.text || Path::new(&layer.file).ends_with(&shipped.file)
}
