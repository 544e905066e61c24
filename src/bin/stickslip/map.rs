//! `stickslip map`.

use crate::args::{MapArgs, Picture, Swept};
use crate::failure::{Failure, Outcome};
use crate::figure;
use crate::grid::Grid;
use crate::interrupt;
use crate::progress;
use crate::record::Cell;
use crate::sweep::rows;
use std::io::Write;
use stickslip::figures::{Axis, Figure, Panel, Plane, Scale, Series, Style};
use stickslip::{Border, Place, Ratios};

/// What is mapped.
enum Quantity<'a> {
    Regime,
    Margin,
    Stops,
    Output(Swept, &'a str),
}

impl<'a> Quantity<'a> {
    fn parse(text: &'a str) -> Result<Self, Failure> {
        let quantity = match text {
            "regime" => return Ok(Self::Regime),
            "margin" => return Ok(Self::Margin),
            "stops" => return Ok(Self::Stops),
            _ => match text.strip_prefix("steady:") {
                Some(name) => Self::Output(Swept::Steady, name),
                None => Self::Output(Swept::Response, text),
            },
        };
        match quantity.at(0.7, 2.0)? {
            Some(_) => Ok(quantity),
            None => {
                let known =
                    "regime, margin, stops, an output of response, or steady: and an output of steady";
                Err(Failure::Input(format!("map {text}: must be one of {known}")))
            }
        }
    }

    /// The value at a point; `None` where there is no such output.
    fn at(&self, omega: f64, alpha: f64) -> Result<Option<Cell<f64>>, Failure> {
        let (question, name) = match self {
            Self::Margin => {
                let ratios = Ratios::new(omega, alpha).map_err(|e| Failure::Input(e.to_string()))?;
                return Ok(Some(Cell::Number(Some(Place::new(ratios).margin()))));
            }
            Self::Regime => (Swept::Response, "regime"),
            Self::Stops => (Swept::Steady, "sticks_per_cycle"),
            Self::Output(question, name) => (*question, *name),
        };
        let record = rows::answer(question, omega, alpha).map_err(|e| Failure::Input(e.to_string()))?;
        let found = record.fields.iter().find(|(found, _)| *found == name);
        Ok(found.map(|(_, cell)| *cell).filter(|cell| !matches!(cell, Cell::Pairs(_) | Cell::Intervals(_))))
    }

    /// What the colours stand for, with its unit.
    fn label(&self) -> String {
        let name = match self {
            Self::Regime => return "regime".to_owned(),
            Self::Margin => return "margin α/α_min".to_owned(),
            Self::Stops => return "stops per cycle".to_owned(),
            Self::Output(_, name) => *name,
        };
        let unit = match name {
            "max_displacement" | "min_displacement" | "deviation" | "distance" | "rest_position" => " (B)",
            "max_velocity" | "min_velocity" => " (B ω_d)",
            "energy_in" | "energy_out" => " (r_y B)",
            "periods" => " (2π/ω_d)",
            _ if name.ends_with("_phase") => " (rad)",
            _ => "",
        };
        format!("{name}{unit}")
    }

    const fn question(&self) -> Swept {
        match self {
            Self::Regime | Self::Margin => Swept::Response,
            Self::Stops => Swept::Steady,
            Self::Output(question, _) => *question,
        }
    }
}

pub(crate) fn run(args: &MapArgs, out: &mut impl Write) -> Outcome {
    let kind = args.out.as_deref().map_or(Ok(Picture::Csv), figure::picture_of)?;
    let quantity = Quantity::parse(&args.quantity)?;
    let omega = Grid::parse("--omega", &args.omega)?;
    let alpha = Grid::parse("--alpha", &args.alpha)?;
    rows::check(quantity.question(), &omega, &alpha)?;
    match (&args.out, kind) {
        (Some(file), Picture::Svg | Picture::Png) => {
            drawable(&omega, &alpha)?;
            figure::beside(file, args.overwrite)?
                .fill(|out| figure::write(&picture(args, &quantity, &omega, &alpha)?, kind, out))
        }
        (Some(file), Picture::Csv) => {
            figure::beside(file, args.overwrite)?.fill(|out| table(args, &quantity, &omega, &alpha, out))
        }
        (None, _) => table(args, &quantity, &omega, &alpha, out),
    }
}

/// The points in order, α by α, Ω the fast index.
fn cells(
    quantity: &Quantity<'_>,
    omega: &Grid<f64>,
    alpha: &Grid<f64>,
    mut take: impl FnMut(f64, f64, Cell<f64>) -> Outcome,
) -> Outcome {
    let points = omega.len().saturating_mul(alpha.len());
    let place = |point: u64| (omega.value(point % omega.len()), alpha.value(point / omega.len()));
    progress::in_order(
        0..points,
        |points| {
            let cell = |point| {
                if interrupt::asked() {
                    return Err(Failure::Interrupted);
                }
                let (omega, alpha) = place(point);
                Ok((omega, alpha, quantity.at(omega, alpha)?.unwrap_or(Cell::Number(None))))
            };
            points.map(cell).collect::<Result<Vec<_>, Failure>>()
        },
        |found| found.into_iter().try_for_each(|(omega, alpha, cell)| take(omega, alpha, cell)),
    )
}

fn table(
    args: &MapArgs,
    quantity: &Quantity<'_>,
    omega: &Grid<f64>,
    alpha: &Grid<f64>,
    out: &mut impl Write,
) -> Outcome {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(["omega", "alpha", args.quantity.as_str()])?;
    let outcome = cells(quantity, omega, alpha, |omega, alpha, cell| {
        Ok(writer.serialize((Cell::Number(Some(omega)), Cell::Number(Some(alpha)), cell))?)
    });
    writer.flush()?;
    outcome
}

/// Most points of a picture, and most from one side to the other: it has to be in memory, and nobody sees more.
const MOST: u64 = 4_000_000;
const MOST_ACROSS: u64 = 20_000;

fn drawable(omega: &Grid<f64>, alpha: &Grid<f64>) -> Outcome {
    let points = omega.len().saturating_mul(alpha.len());
    if points > MOST {
        return Err(Failure::Input(format!(
            "--omega, --alpha: {points} points, must be ≤ {MOST} in a picture"
        )));
    }
    for (name, grid) in [("--omega", omega), ("--alpha", alpha)] {
        if grid.len() > MOST_ACROSS {
            let text = format!("{name}: {} values, must be ≤ {MOST_ACROSS} in a picture", grid.len());
            return Err(Failure::Input(text));
        }
    }
    Ok(())
}

fn picture(
    args: &MapArgs,
    quantity: &Quantity<'_>,
    omega: &Grid<f64>,
    alpha: &Grid<f64>,
) -> Result<Figure, Failure> {
    let (x, y): (Vec<f64>, Vec<f64>) = (omega.values().collect(), alpha.values().collect());
    let (Some((left, right)), Some((low, high))) = (ends(&x), ends(&y)) else {
        let text = "--omega, --alpha: a picture needs at least two values of each, ascending";
        return Err(Failure::Input(text.to_owned()));
    };
    // The regimes in this order, the others as they come.
    let regimes = ["non-sticking", "sticking", "stuck", "unbounded"];
    let mut names: Vec<String> = regimes.map(str::to_owned).to_vec();
    let mut named = false;
    let mut values = Vec::new();
    let mut whole = true;
    cells(quantity, omega, alpha, |_, _, cell| {
        values.push(match cell {
            Cell::Text(name) => {
                named = true;
                place_of(name, &mut names)
            }
            Cell::Count(count) => count.map_or(f64::NAN, |n| n as f64),
            Cell::Number(number) => {
                whole = false;
                number.unwrap_or(f64::NAN)
            }
            Cell::Flag(flag) => f64::from(u8::from(flag)),
            Cell::Pairs(_) | Cell::Intervals(_) => f64::NAN,
        });
        Ok(())
    })?;
    let scale = match (named, whole) {
        (true, _) => Scale::Names(names),
        (false, true) => {
            let most = values.iter().copied().filter(|v| v.is_finite()).fold(0.0, f64::max);
            Scale::Names((0..=most as u64).map(|n| n.to_string()).collect())
        }
        (false, false) => Plane::shades(&values),
    };
    let border = x.iter().filter_map(|&x| Border::new(x).ok().map(|b| (x, b.min_force_ratio())));
    let axis = |label: &str, grid: &Grid<f64>, low, high| match grid {
        Grid::Even { logarithmic: true, .. } => Axis::logarithmic(label, low, high),
        Grid::Even { .. } | Grid::List(_) => Axis::linear(label, low, high),
    };
    Ok(Figure {
        name: "map".to_owned(),
        title: format!("Map of {}", args.quantity),
        caption: String::new(),
        panels: vec![Panel {
            title: String::new(),
            x: axis("frequency ratio Ω = ω_d/ω_n", omega, left, right),
            y: axis("force ratio α = p₀/r_y", alpha, low, high),
            series: vec![Series::new("exact border α_min", Style::Thick, 0, border)],
            plane: Some(Plane { label: quantity.label(), x, y, values, scale }),
        }],
    })
}

/// The first and the last value, where all are ascending.
fn ends(values: &[f64]) -> Option<(f64, f64)> {
    let ascending = values.windows(2).all(|pair| matches!(pair, [a, b] if a < b));
    match values {
        [first, .., last] if ascending => Some((*first, *last)),
        _ => None,
    }
}

/// The place of a name in the list, at its end where it is new.
fn place_of(name: &str, names: &mut Vec<String>) -> f64 {
    let place = names.iter().position(|n| n == name).unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    });
    place as f64
}
