//! Through the elements: groups, pages within, uses; what is hidden, what is not read.

use std::collections::BTreeSet;
use std::str::FromStr as _;

use nalgebra::{Affine3, Translation3};
use roxmltree::{Node, NodeId};
use svgtypes::Transform;
use wirebend_error::ErrorRemedy;

use super::super::error::ReadError;
use super::super::note::NoteKind;
use super::super::outline::Pen;
use super::super::text::excerpt;
use super::page::{Along, Page, fit};
use super::path::affine;
use super::shape::{length, shape};
use super::tree::Tree;
use super::{aspect, view_box};

const SVG: &str = "http://www.w3.org/2000/svg";
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";
const XLINK: &str = "http://www.w3.org/1999/xlink";
/// So many bytes of a path take as long to read again as an element does.
const BYTES_OF_ELEMENT: usize = 64;
/// How deep elements may hold elements.
const MAX_DEPTH: usize = 256;

/// What elements have from those around them.
#[derive(Debug, Clone)]
pub(super) struct Context {
    /// From the numbers of the element to the drawing.
    map: Affine3<f64>,
    page: Page,
    visible: bool,
    /// Whether the element is on a layer that is wanted.
    wanted: bool,
    depth: usize,
}

impl Context {
    pub(super) fn new(map: Affine3<f64>, page: Page) -> Self {
        Self { map, page, visible: true, wanted: false, depth: 0 }
    }
}

pub(super) struct Walk<'a, 'input> {
    tree: &'a Tree<'a, 'input>,
    pub(super) pen: Pen<'a>,
    /// In lower case; empty: all.
    layers: BTreeSet<String>,
    /// The elements that are being used.
    open: Vec<NodeId>,
    /// Elements met in those that are used: uses of uses can be many.
    met: usize,
}

impl<'a, 'input> Walk<'a, 'input> {
    /// # Errors
    /// [`ReadError::NoSuchLayer`] for a wanted layer that there is not.
    pub(super) fn new(
        tree: &'a Tree<'a, 'input>,
        mut pen: Pen<'a>,
        layers: &[String],
    ) -> Result<Self, ReadError> {
        let layers: BTreeSet<String> = layers.iter().map(|layer| layer.to_lowercase()).collect();
        let groups = || tree.document.descendants().filter(|node| node.tag_name().name() == "g");
        let is_layer = |group: &Node<'_, '_>| group.attribute((INKSCAPE, "groupmode")) == Some("layer");
        let label =
            |group: Node<'a, 'input>| group.attribute((INKSCAPE, "label")).or_else(|| group.attribute("id"));
        pen.drawing.layers = groups().filter(is_layer).filter_map(label).map(str::to_owned).collect();
        if let Some(name) = layers.iter().find(|name| !groups().any(|group| named(group, name))) {
            let have: Vec<String> = pen.drawing.layers.iter().take(20).map(|name| excerpt(name)).collect();
            let have = if have.is_empty() { "none".to_owned() } else { have.join(", ") };
            let file = tree.source.name.to_owned();
            return Err(ReadError::NoSuchLayer { file, name: excerpt(name), have });
        }
        pen.drawing.notes.add(NoteKind::StylesIgnored, tree.styles.misunderstood);
        Ok(Self { tree, pen, layers, open: Vec::new(), met: 0 })
    }

    /// The outermost page with all that is on it.
    pub(super) fn root(&mut self, root: Node<'a, 'input>, mut context: Context) -> Result<(), ReadError> {
        if self.is_none(root) {
            self.pen.drawing.notes.add(NoteKind::HiddenIgnored, 1);
            return Ok(());
        }
        context.visible = self.is_visible(root, &context);
        self.children(root, &context)
    }

    fn children(&mut self, node: Node<'a, 'input>, context: &Context) -> Result<(), ReadError> {
        let inner = self.within(node, context)?;
        node.children().filter(Node::is_element).try_for_each(|child| self.element(child, &inner))
    }

    fn element(&mut self, node: Node<'a, 'input>, context: &Context) -> Result<(), ReadError> {
        // What programs keep for themselves is not of the drawing.
        if node.tag_name().namespace().is_some_and(|namespace| namespace != SVG) {
            return Ok(());
        }
        if !self.open.is_empty() {
            // What has to be read again counts, too.
            let text =
                ["d", "points"].iter().filter_map(|name| node.attribute(*name)).map(str::len).sum::<usize>();
            self.met += 1 + text / BYTES_OF_ELEMENT;
            self.pen.source.room_within(self.tree.place(node), self.met, "elements that are used")?;
        }
        let name = node.tag_name().name();
        let ignored = match name {
            // Not drawn where they stand.
            "defs" | "symbol" | "clipPath" | "mask" | "marker" | "pattern" | "linearGradient"
            | "radialGradient" | "filter" | "style" | "metadata" | "title" | "desc" | "view" => return Ok(()),
            "text" => Some(NoteKind::TextsIgnored),
            "image" => Some(NoteKind::ImagesIgnored),
            "g" | "a" | "switch" | "svg" | "use" | "path" | "line" | "polyline" | "polygon" | "rect"
            | "circle" | "ellipse" => None,
            _ => Some(NoteKind::ElementsIgnored),
        };
        if self.is_none(node) {
            self.pen.drawing.notes.add(NoteKind::HiddenIgnored, 1);
            return Ok(());
        }
        if let Some(kind) = ignored {
            self.pen.drawing.notes.add(kind, 1);
            return Ok(());
        }
        self.effects(node);
        let context = self.context(node, context)?;
        match name {
            "use" => self.use_of(node, &context),
            "svg" => self.page(node, node, &context),
            "switch" => self.one_of(node, &context),
            "g" | "a" => self.children(node, &context),
            _ => self.shape(node, &context),
        }
    }

    /// What holds for the elements in an element.
    fn within(&self, node: Node<'a, 'input>, context: &Context) -> Result<Context, ReadError> {
        if context.depth == MAX_DEPTH {
            let (file, place) = (self.tree.source.name.to_owned(), self.tree.place(node));
            return Err(ReadError::TooDeep {
                file,
                place,
                what: "elements in elements are",
                limit: MAX_DEPTH,
            });
        }
        Ok(Context { depth: context.depth + 1, ..context.clone() })
    }

    /// One of several for this language or that program: the first that is for all, else the first.
    fn one_of(&mut self, node: Node<'a, 'input>, context: &Context) -> Result<(), ReadError> {
        let conditions = ["systemLanguage", "requiredExtensions", "requiredFeatures"];
        let for_all = |child: &Node<'_, '_>| {
            child.tag_name().name() != "foreignObject"
                && !conditions.iter().any(|name| child.has_attribute(*name))
        };
        let children: Vec<_> = node.children().filter(Node::is_element).collect();
        let Some(chosen) = children.iter().find(|child| for_all(child)).or(children.first()) else {
            return Ok(());
        };
        self.pen.drawing.notes.add(NoteKind::HiddenIgnored, children.len() - 1);
        self.element(*chosen, &self.within(node, context)?)
    }

    /// What holds within an element: its transform, and whether it is visible and wanted.
    fn context(&self, node: Node<'a, 'input>, around: &Context) -> Result<Context, ReadError> {
        let mut context = around.clone();
        if self.tree.styles.moves(node) || node.has_attribute("transform-origin") {
            let remedy = ErrorRemedy::ExportAs { form: "plain SVG".to_owned() };
            return Err(self.tree.unsupported(node, "a transform of a style, or with an origin,", remedy));
        }
        if let Some(text) = node.attribute("transform") {
            let transform = Transform::from_str(text);
            let transform =
                transform.map_err(|error| self.tree.refuse(node, "transform", &error.to_string()))?;
            context.map *= affine(&transform);
        }
        context.visible = self.is_visible(node, around);
        context.wanted |= self.layers.iter().any(|layer| named(node, layer));
        Ok(context)
    }

    /// Whether neither it nor what it holds is there.
    fn is_none(&self, node: Node<'_, '_>) -> bool {
        self.tree.styles.property(node, "display") == Some("none")
    }

    fn is_visible(&self, node: Node<'_, '_>, around: &Context) -> bool {
        match self.tree.styles.property(node, "visibility") {
            None | Some("inherit" | "unset") => around.visible,
            Some(visibility) => matches!(visibility, "visible" | "initial"),
        }
    }

    /// Counts what hides or adds something that is not looked at.
    fn effects(&mut self, node: Node<'_, '_>) {
        let effects = ["clip-path", "mask", "filter", "marker", "marker-start", "marker-mid", "marker-end"];
        let has = |name: &&str| self.tree.styles.property(node, name).is_some_and(|value| value != "none");
        self.pen.drawing.notes.add(NoteKind::FiltersIgnored, effects.iter().filter(|name| has(name)).count());
    }

    fn shape(&mut self, node: Node<'a, 'input>, context: &Context) -> Result<(), ReadError> {
        let notes = &mut self.pen.drawing.notes;
        if !context.visible {
            notes.add(NoteKind::HiddenIgnored, 1);
            return Ok(());
        }
        if !self.layers.is_empty() && !context.wanted {
            notes.add(NoteKind::OtherLayersIgnored, 1);
            return Ok(());
        }
        let outlines = shape(self.tree, node, context.page).transpose()?.unwrap_or_default();
        if outlines.is_empty() {
            notes.add(NoteKind::EdgesCollapsed, 1);
        }
        let place = self.tree.place(node);
        outlines.iter().try_for_each(|outline| self.pen.draw(&place, &outline.mapped(&context.map)))
    }

    /// A page within the page, or a symbol: `sized` is the element with its width and height.
    fn page(
        &mut self,
        node: Node<'a, 'input>,
        sized: Node<'a, 'input>,
        context: &Context,
    ) -> Result<(), ReadError> {
        let around = context.page;
        let side = |name, along, whole: f64| -> Result<f64, ReadError> {
            let own = length(self.tree, sized, name, around, along)?;
            let length = if own.is_some() { own } else { length(self.tree, node, name, around, along)? };
            Ok(length.unwrap_or(whole))
        };
        let width = side("width", Along::Width, around.width)?;
        let height = side("height", Along::Height, around.height)?;
        let mut inner = Context { page: Page { width, height }, ..context.clone() };
        let at = |name, along| length(self.tree, node, name, around, along);
        let (x, y) = (at("x", Along::Width)?, at("y", Along::Height)?);
        inner.map *= Translation3::new(x.unwrap_or_default(), y.unwrap_or_default(), 0.0);
        if let Some(view) = view_box(self.tree, node)? {
            inner.map *= affine(&fit(view, inner.page, aspect(self.tree, node)?));
            inner.page = Page { width: view.w, height: view.h };
        }
        self.children(node, &inner)
    }

    fn use_of(&mut self, node: Node<'a, 'input>, context: &Context) -> Result<(), ReadError> {
        let href = node.attribute("href").or_else(|| node.attribute((XLINK, "href"))).unwrap_or_default();
        let target = href.trim().strip_prefix('#').and_then(|id| self.tree.by_id(id));
        let Some(target) = target else {
            self.pen.drawing.notes.add(NoteKind::ReferencesIgnored, 1);
            return Ok(());
        };
        let (file, place) = (self.tree.source.name.to_owned(), self.tree.place(node));
        if self.open.contains(&target.id()) {
            return Err(ReadError::Loop { file, place, what: "element", name: excerpt(href) });
        }
        if context.depth == MAX_DEPTH {
            return Err(ReadError::TooDeep {
                file,
                place,
                what: "elements in elements are",
                limit: MAX_DEPTH,
            });
        }
        let at = |name, along| length(self.tree, node, name, context.page, along);
        let (x, y) = (at("x", Along::Width)?, at("y", Along::Height)?);
        let mut inner = Context { depth: context.depth + 1, ..context.clone() };
        inner.map *= Translation3::new(x.unwrap_or_default(), y.unwrap_or_default(), 0.0);
        self.pen.drawing.notes.add(NoteKind::BlocksExploded, 1);
        self.open.push(target.id());
        match target.tag_name().name() {
            "symbol" | "svg" => {
                let inner = self.context(target, &inner)?;
                self.page(target, node, &inner)?;
            }
            _ => self.element(target, &inner)?,
        }
        self.open.pop();
        Ok(())
    }
}

/// Whether a group goes by a name, which is in lower case: its label, or its id.
fn named(node: Node<'_, '_>, name: &str) -> bool {
    let names = [node.attribute((INKSCAPE, "label")), node.attribute("id")];
    node.tag_name().name() == "g" && names.iter().flatten().any(|own| own.to_lowercase() == name)
}
