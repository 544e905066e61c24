//! Laws that are curves, as a file gives them.

use super::curve::{Curve, Mesh, Of as Kind, Points, size};
use super::formula::Formula;
use super::node::{Fields, Node, Number};
use crate::inputs::units::Kind as Of;
use stickslip::system::{self, Element, Model, Signal, State};

/// The exponent of a Stribeck law that gives none: Gauss's curve, as after Armstrong-Hélouvry.
const EXPONENT: f64 = 2.0;
/// The part of a law's own size within which its second table is, where no force is given: the finest is within a quarter of it.
const PART: f64 = 1e-4;
/// The part of the pieces of a table that shows how far a motion goes, and the fewest of them.
const SCOUT: usize = 8;
/// From this factor on a law is steep: eight is that of a cubic spring over twice the stretch.
const STEEP: f64 = 8.0;
const FEWEST: usize = 4;
/// How many lengths of its fall a Stribeck law is first tabulated over.
const LENGTHS: f64 = 4.0;
/// The part of the first range by which a slope is taken on both sides of a place.
const BESIDE: f64 = 1e-5;

/// A law that is a curve.
#[derive(Debug, Clone)]
pub(super) struct Law {
    /// Its place in the file, for messages.
    place: String,
    pub(super) element: usize,
    curve: Curve,
    of: Kind,
    /// The force within which tables are.
    tolerance: Option<f64>,
    /// The first range.
    pub(super) reach: f64,
}

/// Why a contact with a curve has no ratio of static friction.
pub(super) const BESIDE_CURVE: &str =
    "must be left out beside a curve, whose static friction is its value at v = 0";

/// The tables of a law, each with twice as many pieces as the one before: that of the fineness 1 is within the force.
pub(super) struct Refined<'l> {
    mesh: Mesh<'l>,
    pieces: usize,
}

impl Refined<'_> {
    pub(super) fn table(&self, fineness: usize) -> Points {
        self.mesh.table(self.pieces.saturating_mul(1 << fineness.min(16)).div_ceil(2))
    }

    /// A table of few pieces, that shows how far a motion goes.
    pub(super) fn scout(&self) -> Points {
        self.mesh.table((self.pieces / SCOUT).max(FEWEST))
    }

    /// The force within which a table is, and whether that is proved.
    pub(super) fn error(&self, table: &Points) -> (f64, bool) {
        self.mesh.error(table)
    }
}

/// Reads a number of this kind: with a unit, or as it is beside matrices.
pub(super) type Read = fn(&Node<'_>, Of) -> Result<f64, String>;

/// The fields of a curve.
const FIELDS: [&str; 5] = ["kinetic", "static", "speed", "exponent", "viscous"];

impl Law {
    /// The law of a contact from a table of its constants, or a formula of v.
    pub(super) fn friction(node: &Node<'_>, element: usize, read: Read) -> Result<Self, String> {
        let fields = node.fields()?;
        if let Some(law) = Self::new(node, &fields, element, Kind::Friction, read)? {
            return Ok(law);
        }
        if fields.get("kinetic").is_none() && fields.get("static").is_none() {
            fields.end_with(&["speed", "exponent", "viscous", "tolerance"])?;
            return Err(node.wrong("needs formula, or kinetic, static and speed"));
        }
        let not_negative = |node: Node<'_>, kind: Of| node.at_least(read(&node, kind)?, 0);
        let kinetic = not_negative(fields.required("kinetic")?, Of::Force)?;
        let static_ = not_negative(fields.required("static")?, Of::Force)?;
        let of_speed = fields.required("speed")?;
        let speed = read(&of_speed, Of::Velocity)?;
        if speed <= 0.0 {
            return Err(of_speed.wrong(
                "must be > 0, the speed over which the friction falls; write friction for one that does not",
            ));
        }
        let exponent = match fields.get("exponent") {
            Some(node) => {
                let exponent = node.number()?;
                if exponent <= 0.0 {
                    return Err(node.wrong("must be > 0"));
                }
                exponent
            }
            None => EXPONENT,
        };
        let viscous = fields.get("viscous").map_or(Ok(0.0), |node| not_negative(node, Of::Damping))?;
        let tolerance = tolerance(&fields, read)?;
        fields.end()?;
        let curve = Curve::Stribeck { kinetic, static_, speed, exponent, viscous };
        Ok(Self { place: node.place().to_owned(), element, curve, of: Kind::Friction, tolerance, reach: 0.0 })
    }

    /// The law of a spring from a formula of x; `odd` says that it holds from 0 up, and mirrored below.
    pub(super) fn spring(node: &Node<'_>, element: usize, odd: bool, read: Read) -> Result<Self, String> {
        let fields = node.fields()?;
        let of = if odd { Kind::OddSpring } else { Kind::Spring };
        match Self::new(node, &fields, element, of, read)? {
            Some(law) => Ok(law),
            None => {
                fields.end_with(&["tolerance"])?;
                Err(fields.required("formula").map_or_else(|e| e, |node| node.wrong("is missing")))
            }
        }
    }

    /// The law by its formula, if it has one.
    fn new(
        node: &Node<'_>,
        fields: &Fields<'_>,
        element: usize,
        of: Kind,
        read: Read,
    ) -> Result<Option<Self>, String> {
        let Some(formula) = fields.get("formula") else { return Ok(None) };
        let variable = if of == Kind::Friction { "v" } else { "x" };
        if of == Kind::Friction
            && let Some(node) = FIELDS.iter().find_map(|name| fields.get(name))
        {
            return Err(node.wrong("must be left out beside formula, which is the whole law"));
        }
        let curve = Formula::new(formula.text()?, variable).map_err(|why| formula.wrong(&why))?;
        let tolerance = tolerance(fields, read)?;
        fields.end()?;
        let (place, curve) = (node.place().to_owned(), Curve::Formula(curve));
        Ok(Some(Self { place, element, curve, of, tolerance, reach: 0.0 }))
    }

    /// The law in words.
    pub(super) fn words(&self) -> String {
        match &self.curve {
            Curve::Formula(formula) => formula.text().to_owned(),
            Curve::Stribeck { .. } => "Stribeck's law".to_owned(),
        }
    }

    pub(super) fn about(&self, why: &str) -> String {
        format!("{}: {why}", self.place)
    }

    /// Sets the first range, from a start and the sides that move.
    pub(super) fn begin<F: Number>(&mut self, model: &Model<F>, start: &State<F>) {
        let Some(element) = model.elements.get(self.element) else { return };
        let along = |list: &[F]| -> f64 {
            element.direction.iter().zip(list).map(|(&b, &x)| (b * x).abs().to_f64()).sum()
        };
        let from = match self.of {
            Kind::Friction => along(&start.velocity) + most(&element.moves),
            Kind::Spring | Kind::OddSpring => along(&start.displacement),
        };
        let own = self.curve.scale().map_or(0.0, |length| LENGTHS * length);
        let first = (2.0 * from).max(own);
        self.reach = if first > 0.0 && first.is_finite() { first } else { 1.0 };
    }

    /// Whether the law grows so much between two places that a table to the farther one is too coarse up to the nearer one.
    pub(super) fn is_steep(&self, near: f64, far: f64) -> bool {
        size(&self.curve, self.of, far) > STEEP * size(&self.curve, self.of, near)
    }

    /// How far a table reaches that follows one which the motion has left.
    pub(super) fn further(&self, reach: f64) -> f64 {
        if self.is_steep(reach, 2.0 * reach) { 1.25 * reach } else { 2.0 * reach }
    }

    /// The force within which tables up to a reach are.
    fn tolerance(&self, reach: f64) -> f64 {
        let own = || PART * size(&self.curve, self.of, reach);
        self.tolerance.unwrap_or_else(own).max(f64::MIN_POSITIVE)
    }

    /// The tables up to a greatest speed or stretch.
    pub(super) fn refined(&self, reach: f64) -> Result<Refined<'_>, String> {
        let tolerance = self.tolerance(reach);
        let mesh = Mesh::new(&self.curve, self.of, reach, tolerance).map_err(|why| self.about(&why))?;
        let pieces = mesh.pieces(tolerance).map_err(|why| self.about(&why))?;
        Ok(Refined { mesh, pieces })
    }

    /// A table with exact slopes where the other side travels with one velocity, and at the stretch 0: for the stability of steady sliding,
    /// and for natural frequencies.
    pub(super) fn of_slopes<F: Number>(&self, element: &Element<F>) -> Result<Vec<(F, F)>, String> {
        let up_to = |why: String| match self.of {
            Kind::Friction => {
                format!("{why} (up to v = {}, by the velocity of the start and what moves)", self.reach)
            }
            Kind::Spring | Kind::OddSpring => format!("{why} (up to x = {}, by the start)", self.reach),
        };
        let mut points = self.refined(self.reach).map_err(up_to)?.table(1);
        let at = if self.of == Kind::Friction { element.moves.constant.abs().to_f64() } else { 0.0 };
        let beside = BESIDE * self.reach;
        if self.of != Kind::Friction || at > beside {
            points.retain(|point| (point.0 - at).abs() > 2.0 * beside);
            let after = points.partition_point(|point| point.0 < at);
            let pair = [at - beside, at + beside].map(|x| (x, self.curve.of(self.of, x)));
            points.splice(after..after, pair);
        }
        Ok(points.into_iter().map(|(x, force)| (F::from_f64(x), F::from_f64(force))).collect())
    }
}

/// The greatest size of a velocity over time, but for records.
fn most<F: Number>(signal: &Signal<F>) -> f64 {
    signal.sin.iter().chain(&signal.cos).fold(signal.constant.abs().to_f64(), |sum, x| sum + x.abs().to_f64())
}

fn tolerance(fields: &Fields<'_>, read: Read) -> Result<Option<f64>, String> {
    let Some(node) = fields.get("tolerance") else { return Ok(None) };
    let tolerance = read(&node, Of::Force)?;
    if tolerance > 0.0 { Ok(Some(tolerance)) } else { Err(node.wrong("must be > 0")) }
}

/// Gives an element the points of its law.
pub(super) fn set_points<F>(kind: &mut system::Kind<F>, table: Vec<(F, F)>) {
    match kind {
        system::Kind::Contact { law, .. } => *law = system::Law { points: table },
        system::Kind::Spring { points } => *points = table,
        system::Kind::Elastic { .. } | system::Kind::Stop { .. } => {}
        system::Kind::HardStop { .. } | system::Kind::UnderStop { .. } => {}
    }
}
