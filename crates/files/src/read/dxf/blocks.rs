//! Entities with their layers, in the drawing or in a block, and drawing them.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use nalgebra::{Affine3, Point3, Translation3};

use super::super::drawing::Drawing;
use super::super::error::{Location, ReadError};
use super::super::note::NoteKind;
use super::super::outline::Pen;
use super::super::text::excerpt;
use super::shape::{Insert, Shape};
use super::skin::Skin;

/// How deep blocks may hold blocks.
const MAX_DEPTH: usize = 64;
/// The layer whose entities in a block are on the layer that the block is put in on.
const BYBLOCK: &str = "0";

/// A shape, on a layer.
#[derive(Debug)]
pub(super) struct Entity {
    pub(super) place: Location,
    /// In lower case.
    pub(super) layer: String,
    /// Why it is not drawn wherever it is, if so.
    pub(super) hidden: Option<NoteKind>,
    pub(super) shape: Shape,
}

/// Entities that are put in together.
#[derive(Debug)]
pub(super) struct Block {
    pub(super) base: Point3<f64>,
    /// Whether its entities are in another file.
    pub(super) elsewhere: bool,
    pub(super) entities: Vec<Entity>,
}

/// What is in a file, names in lower case.
#[derive(Debug, Default)]
pub(super) struct Content {
    /// Whether each layer is on.
    pub(super) layers: BTreeMap<String, bool>,
    pub(super) blocks: HashMap<String, Block>,
    pub(super) entities: Vec<Entity>,
}

/// Draws entities, and those of blocks where they are put in.
pub(super) struct Plotter<'a> {
    pub(super) pen: Pen<'a>,
    skin: Skin,
    content: &'a Content,
    /// Empty: all that are on.
    wanted: BTreeSet<String>,
    /// The blocks that are open.
    open: Vec<&'a str>,
    /// Blocks and entities of blocks met, drawn or not: blocks in blocks can be many.
    met: usize,
}

impl<'a> Plotter<'a> {
    /// # Errors
    /// [`ReadError::NoSuchLayer`] for a wanted layer that there is not.
    pub(super) fn new(mut pen: Pen<'a>, content: &'a Content, layers: &[String]) -> Result<Self, ReadError> {
        let all = content.blocks.values().flat_map(|block| &block.entities).chain(&content.entities);
        let mut known: BTreeSet<&str> = all.map(|entity| entity.layer.as_str()).collect();
        known.extend(content.layers.keys().map(String::as_str));
        let wanted: BTreeSet<String> = layers.iter().map(|layer| layer.to_lowercase()).collect();
        if let Some(name) = wanted.iter().find(|name| !known.contains(name.as_str())) {
            let mut have: Vec<String> = known.iter().take(20).map(|name| excerpt(name)).collect();
            if known.len() > have.len() {
                have.push("…".to_owned());
            }
            let (file, name) = (pen.source.name.to_owned(), excerpt(name));
            return Err(ReadError::NoSuchLayer { file, name, have: have.join(", ") });
        }
        pen.drawing.layers = known.into_iter().map(str::to_owned).collect();
        Ok(Self { pen, skin: Skin::default(), content, wanted, open: Vec::new(), met: 0 })
    }

    /// Why what is on a layer is left out, if it is.
    fn left_out(&self, layer: &str) -> Option<NoteKind> {
        if self.wanted.is_empty() {
            (self.content.layers.get(layer) == Some(&false)).then_some(NoteKind::HiddenIgnored)
        } else {
            (!self.wanted.contains(layer)).then_some(NoteKind::OtherLayersIgnored)
        }
    }

    /// Draws entities after a map; `layer` is the one of the block that they are in.
    pub(super) fn draw(
        &mut self,
        entities: &'a [Entity],
        map: &Affine3<f64>,
        layer: Option<&'a str>,
    ) -> Result<(), ReadError> {
        for entity in entities {
            if layer.is_some() {
                self.meet(&entity.place)?;
            }
            let own = entity.layer.as_str();
            let layer = if own == BYBLOCK { layer.unwrap_or(own) } else { own };
            let is_block = matches!(entity.shape, Shape::Insert(_));
            // What a block holds may be on a layer that is wanted although the block is on another one.
            let by_layer = self.left_out(layer).filter(|why| !is_block || *why == NoteKind::HiddenIgnored);
            if let Some(why) = entity.hidden.or(by_layer) {
                self.pen.drawing.notes.add(why, 1);
                continue;
            }
            match &entity.shape {
                Shape::Outline(outline) => self.pen.draw(&entity.place, &outline.mapped(map))?,
                Shape::Fitted(outline) => {
                    self.pen.drawing.notes.add(NoteKind::FitPointsJoined, 1);
                    self.pen.draw(&entity.place, &outline.mapped(map))?;
                }
                Shape::Faces(faces) => self.skin.add(&mut self.pen, &entity.place, faces, map)?,
                Shape::Broken(error) => return error.take().map_or(Ok(()), |error| Err(*error)),
                Shape::Ignored(kind) => self.pen.drawing.notes.add(*kind, 1),
                Shape::Insert(insert) => self.insert(&entity.place, insert, map, layer)?,
            }
        }
        Ok(())
    }

    /// The drawing, with the sides of faces that are not to become edges.
    pub(super) fn finish(self) -> Result<Drawing, ReadError> {
        let mut drawing = self.pen.finish()?;
        drawing.hidden_sides = self.skin.hidden_sides();
        Ok(drawing)
    }

    fn meet(&mut self, place: &Location) -> Result<(), ReadError> {
        self.met += 1;
        self.pen.source.room_within(place.clone(), self.met, "blocks and entities of blocks")
    }

    fn insert(
        &mut self,
        place: &Location,
        insert: &'a Insert,
        map: &Affine3<f64>,
        layer: &'a str,
    ) -> Result<(), ReadError> {
        let source = self.pen.source;
        let file = || source.name.to_owned();
        let Some(block) = self.content.blocks.get(&insert.block) else {
            let have = format!("the file has {}", self.content.blocks.len());
            let (place, found) = (place.clone(), excerpt(&insert.block));
            return Err(ReadError::Index { file: file(), place, found, what: "block", have });
        };
        if block.elsewhere {
            self.pen.drawing.notes.add(NoteKind::ReferencesIgnored, 1);
            return Ok(());
        }
        if self.open.contains(&insert.block.as_str()) {
            let (place, name) = (place.clone(), excerpt(&insert.block));
            return Err(ReadError::Loop { file: file(), place, what: "block", name });
        }
        if self.open.len() == MAX_DEPTH {
            let (place, what) = (place.clone(), "blocks in blocks are");
            return Err(ReadError::TooDeep { file: file(), place, what, limit: MAX_DEPTH });
        }
        self.open.push(&insert.block);
        let to_base = Translation3::from(-block.base.coords);
        for row in 0..insert.counts[1] {
            for column in 0..insert.counts[0] {
                self.meet(place)?;
                #[allow(clippy::cast_precision_loss)] // there is no room for as many
                let step = insert.steps[0] * column as f64 + insert.steps[1] * row as f64;
                let one = Translation3::from(step) * insert.map * to_base;
                self.pen.drawing.notes.add(NoteKind::BlocksExploded, 1);
                self.draw(&block.entities, &(map * one), Some(layer))?;
            }
        }
        self.open.pop();
        Ok(())
    }
}
