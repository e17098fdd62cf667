//! All profiles that are known: those inside the program and those of a person's folders.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use wirebend_error::ErrorRemedy;

use crate::error::nearest;
use crate::layer::Layer;
use crate::{
    Kind, MAX_FILE_BYTES, MachineProfile, MaterialProfile, NoiseProfile, Profile, ProfileError, Resolved,
    StrutBuilderProfile, shipped,
};

/// Every known profile, by kind and id. Each one in it has passed all rules.
#[derive(Clone, Debug, Default)]
pub struct Library {
    layers: BTreeMap<(Kind, String), Layer>,
}

/// One line of a list of profiles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listing {
    /// Id.
    pub id: String,
    /// Name for people; the id when no name is set.
    pub name: String,
    /// Whether it only serves to be inherited from.
    pub is_abstract: bool,
    /// Whether it comes with the program.
    pub shipped: bool,
    /// Its file.
    pub file: String,
}

/// What became of a folder of profiles.
#[derive(Debug, Default)]
pub struct Added {
    /// Profiles that can be used now.
    pub loaded: Vec<(Kind, String)>,
    /// Why other files were refused; one file may have several reasons.
    pub refused: Vec<ProfileError>,
    /// What was not taken for a profile: not `*.json`, or not in the folder of a
    /// kind ([`Kind::folder`]).
    pub ignored: Vec<PathBuf>,
}

impl Library {
    /// The profiles that come with the program.
    ///
    /// # Errors
    /// A shipped file that breaks a rule; a test sees to it that there is none.
    pub fn shipped() -> Result<Self, ProfileError> {
        let mut library = Self::default();
        for (file, bytes) in shipped::files() {
            let layer = Layer::read(&file, bytes, true)?;
            library.insert(layer)?;
        }
        match library.drop_unsound().into_iter().next() {
            Some(error) => Err(error),
            None => Ok(library),
        }
    }

    /// Adds the profiles of `folder/machines/*.json`, `folder/materials/*.json`, `folder/noise/*.json`
    /// and `folder/strut-builders/*.json`. Files that break a rule are left out and reported; the others,
    /// and all that was there before, stay usable. An absent sub-folder is empty.
    pub fn add_folder(&mut self, folder: &Path) -> Added {
        let mut added = Added::default();
        let mut sub_folders = Vec::new();
        for path in entries(folder, &mut added.refused) {
            match Kind::ALL.into_iter().find(|kind| path.ends_with(kind.folder())) {
                Some(kind) if path.is_dir() => sub_folders.push((kind, path)),
                _ => added.ignored.push(path),
            }
        }
        for (kind, sub_folder) in sub_folders {
            for path in entries(&sub_folder, &mut added.refused) {
                if path.is_dir() || path.extension().is_none_or(|extension| extension != "json") {
                    added.ignored.push(path);
                    continue;
                }
                match self.add_file(&path, kind) {
                    Ok(id) => added.loaded.push((kind, id)),
                    Err(error) => added.refused.push(error),
                }
            }
        }
        added.refused.extend(self.drop_unsound());
        added.loaded.retain(|(kind, id)| self.layer(*kind, id).is_some());
        added
    }

    fn add_file(&mut self, path: &Path, kind: Kind) -> Result<String, ProfileError> {
        let layer = read_file(path)?;
        if layer.kind != kind {
            return Err(ProfileError::WrongFolder {
                place: layer.place("kind"),
                found: layer.kind,
                folder: kind.folder().into(),
            });
        }
        let id = layer.id.clone();
        self.insert(layer)?;
        Ok(id)
    }

    /// Takes a layer in unless its id is taken.
    pub(crate) fn insert(&mut self, layer: Layer) -> Result<(), ProfileError> {
        if let Some(taken) = self.layer(layer.kind, &layer.id) {
            let (place, kind, id) = (layer.place("id"), layer.kind, layer.id);
            return Err(if taken.shipped {
                ProfileError::ShadowsShipped { place, kind, id }
            } else {
                ProfileError::DuplicateId { place, id, first: taken.file.clone() }
            });
        }
        self.replace(layer);
        Ok(())
    }

    pub(crate) fn replace(&mut self, layer: Layer) {
        self.layers.insert((layer.kind, layer.id.clone()), layer);
    }

    pub(crate) fn remove(&mut self, kind: Kind, id: &str) {
        self.layers.remove(&(kind, id.to_owned()));
    }

    /// Removes what breaks a rule, and then what relied on it, until all that is left is sound.
    fn drop_unsound(&mut self) -> Vec<ProfileError> {
        let mut all = Vec::new();
        loop {
            let mut unsound = Vec::new();
            for (key, layer) in &self.layers {
                let errors = self.errors_of(layer);
                if !errors.is_empty() {
                    unsound.push(key.clone());
                    all.extend(errors);
                }
            }
            if unsound.is_empty() {
                return all;
            }
            for key in unsound {
                self.layers.remove(&key);
            }
        }
    }

    /// The machine with this id, complete, its parents merged in.
    ///
    /// # Errors
    /// [`ProfileError::Unknown`] with the nearest ids, or [`ProfileError::Abstract`].
    pub fn machine(&self, id: &str) -> Result<Resolved<MachineProfile>, ProfileError> {
        self.get(id)
    }

    /// The material with this id, complete, its parents merged in.
    ///
    /// # Errors
    /// As [`Library::machine`].
    pub fn material(&self, id: &str) -> Result<Resolved<MaterialProfile>, ProfileError> {
        self.get(id)
    }

    /// The noise profile with this id, complete, its parents merged in.
    ///
    /// # Errors
    /// As [`Library::machine`].
    pub fn noise(&self, id: &str) -> Result<Resolved<NoiseProfile>, ProfileError> {
        self.get(id)
    }

    /// The strut builder with this id, complete, its parents merged in.
    ///
    /// # Errors
    /// As [`Library::machine`].
    pub fn strut_builder(&self, id: &str) -> Result<Resolved<StrutBuilderProfile>, ProfileError> {
        self.get(id)
    }

    fn get<T: Profile>(&self, id: &str) -> Result<Resolved<T>, ProfileError> {
        let unknown = || self.unknown(T::KIND, id, self.usable(T::KIND, id));
        let layer = self.layer(T::KIND, id).ok_or_else(unknown)?;
        if layer.is_abstract {
            let place = layer.place("abstract");
            return Err(ProfileError::Abstract { place, kind: T::KIND, id: id.into() });
        }
        self.resolve_first(layer)
    }

    /// As [`Library::resolve`], with the first of the errors.
    pub(crate) fn resolve_first<T: Profile>(&self, layer: &Layer) -> Result<Resolved<T>, ProfileError> {
        let unknown = || self.unknown(T::KIND, &layer.id, self.known(T::KIND, &layer.id, ""));
        self.resolve(layer).map_err(|errors| errors.into_iter().next().unwrap_or_else(unknown))
    }

    /// The layer with this id.
    pub(crate) fn find(&self, kind: Kind, id: &str) -> Result<&Layer, ProfileError> {
        self.layer(kind, id).ok_or_else(|| self.unknown(kind, id, self.known(kind, id, "")))
    }

    fn unknown(&self, kind: Kind, id: &str, remedy: ErrorRemedy) -> ProfileError {
        let other = Kind::ALL.into_iter().find(|other| self.layer(*other, id).is_some());
        ProfileError::Unknown { kind, id: id.into(), other, remedy: Box::new(remedy) }
    }

    /// The kinds that have a profile with this id, at least one.
    ///
    /// # Errors
    /// [`ProfileError::UnknownId`] with the nearest ids.
    pub fn kinds(&self, id: &str) -> Result<Vec<Kind>, ProfileError> {
        let kinds: Vec<Kind> = Kind::ALL.into_iter().filter(|kind| self.layer(*kind, id).is_some()).collect();
        if kinds.is_empty() {
            let known: BTreeSet<&str> = self.layers.values().map(|layer| layer.id.as_str()).collect();
            let remedy = Box::new(choose(id, known));
            return Err(ProfileError::UnknownId { id: id.into(), remedy });
        }
        Ok(kinds)
    }

    /// All machines, abstract ones too, by id.
    #[must_use]
    pub fn machines(&self) -> Vec<Listing> {
        self.list(Kind::Machine)
    }

    /// All materials, abstract ones too, by id.
    #[must_use]
    pub fn materials(&self) -> Vec<Listing> {
        self.list(Kind::Material)
    }

    /// All noise profiles, abstract ones too, by id.
    #[must_use]
    pub fn noises(&self) -> Vec<Listing> {
        self.list(Kind::Noise)
    }

    /// All strut builders, abstract ones too, by id.
    #[must_use]
    pub fn strut_builders(&self) -> Vec<Listing> {
        self.list(Kind::StrutBuilder)
    }

    /// All profiles of a kind, abstract ones too, by id.
    #[must_use]
    pub fn list(&self, kind: Kind) -> Vec<Listing> {
        self.of_kind(kind)
            .map(|layer| {
                let chain = self.chain(layer).unwrap_or_default();
                let name = chain.iter().find_map(|layer| layer.values.get("name")?.as_str());
                Listing {
                    id: layer.id.clone(),
                    name: name.unwrap_or(&layer.id).to_owned(),
                    is_abstract: layer.is_abstract,
                    shipped: layer.shipped,
                    file: layer.file.clone(),
                }
            })
            .collect()
    }

    fn of_kind(&self, kind: Kind) -> impl Iterator<Item = &Layer> {
        self.layers.values().filter(move |layer| layer.kind == kind)
    }

    pub(crate) fn layer(&self, kind: Kind, id: &str) -> Option<&Layer> {
        self.layers.get(&(kind, id.to_owned()))
    }

    /// What to do about an id that is not known, in a profile whose own id is `besides`.
    pub(crate) fn known(&self, kind: Kind, id: &str, besides: &str) -> ErrorRemedy {
        let ids = self.of_kind(kind).map(|layer| layer.id.as_str()).filter(|known| *known != besides);
        choose(id, ids.collect())
    }

    /// The same where the profile itself is used, and not inherited from.
    pub(crate) fn usable(&self, kind: Kind, id: &str) -> ErrorRemedy {
        let usable = self.of_kind(kind).filter(|layer| !layer.is_abstract);
        choose(id, usable.map(|layer| layer.id.as_str()).collect())
    }
}

/// What to do about an id that is none of these.
fn choose(id: &str, known: BTreeSet<&str>) -> ErrorRemedy {
    let near = nearest(id, known.iter().copied());
    ErrorRemedy::ChooseKnown { near, known: known.into_iter().map(str::to_owned).collect() }
}

/// Reads one file, never more of it than the largest profile.
pub(crate) fn read_file(path: &Path) -> Result<Layer, ProfileError> {
    let file = path.display().to_string();
    let unreadable = |source| ProfileError::Unreadable { file: file.clone(), source };
    let limit = u64::try_from(MAX_FILE_BYTES).unwrap_or(u64::MAX);
    let mut bytes = Vec::new();
    let reader = fs::File::open(path).map_err(unreadable)?;
    reader.take(limit.saturating_add(1)).read_to_end(&mut bytes).map_err(unreadable)?;
    Layer::read(&file, &bytes, false)
}

/// What a folder holds, by name, so that messages come in the same order everywhere.
fn entries(folder: &Path, refused: &mut Vec<ProfileError>) -> Vec<PathBuf> {
    let listed = fs::read_dir(folder)
        .and_then(|entries| entries.map(|entry| entry.map(|entry| entry.path())).collect());
    match listed {
        Ok(paths) => {
            let mut paths: Vec<PathBuf> = paths;
            paths.sort();
            paths
        }
        Err(source) => {
            let file = folder.display().to_string();
            refused.push(ProfileError::Unreadable { file, source });
            Vec::new()
        }
    }
}
