//! `stickslip response` and `border`: the answers of the closed forms.

use crate::args::{BorderArgs, ResponseArgs, Swept};
use crate::bits::{Value, at_bits};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::input;
use crate::note::{self, Note};
use crate::physical::Physical;
use crate::points::AskedPoints;
use crate::row::{Cells, Row};
use std::io::Write;
use stickslip::internal::ResponseAnswer;
use stickslip::internal::definitions::NO_STOP_FORCE_RATIOS;
use stickslip::{Error, NoStop, Ratios, Response};
use stickslip_front::inputs::{Given, Point};

pub(crate) fn response(args: &ResponseArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclose::answer(Swept::Response, &args.machine, &args.output, out);
    }
    at_bits!(args.output.bits, answer_responses(args: &ResponseArgs, out))
}

fn answer_responses<F: Value>(args: &ResponseArgs, out: &mut impl Write) -> Outcome {
    let asked = AskedPoints { question: Swept::Response, output: &args.output, start: None };
    asked.answered(
        &args.machine,
        out,
        |given: &Given<F>, point, _| response_at(given, point, true),
        |point, response, given, out| note::response(response, Note::of(given, point.machine.as_ref(), out)),
    )
}

/// The response at a point, and its record.
pub(crate) fn response_at<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    peaks: bool,
) -> Result<(Response<F>, Row), Failure> {
    let response = Response::guarded(point.ratios);
    if let (Some(cycle), Some(machine)) = (&response.cycle, &point.machine) {
        input::note_pendulum(given, cycle.max_displacement * machine.scales.length);
    }
    let found = ResponseAnswer { response: &response, peaks };
    let record = Cells::of_answer(given, &response.ratios, &found, ResponseAnswer::COLUMNS);
    let record = record.in_units(given, point, Physical::of_machine)?;
    Ok((response, record))
}

pub(crate) fn border(args: &BorderArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclose::answer(Swept::Border, &args.machine, &args.output, out);
    }
    at_bits!(args.output.bits, answer_borders(args: &BorderArgs, out))
}

/// The answer at a point, with the forces without a stop if requested, and its record.
type BorderAnswer<F> = ((Response<F>, Option<NoStop<F>>), Row);

/// The forces without any stop; they are unknown for a static friction above the kinetic one.
fn no_stop<F: Value>(ratios: Ratios<F>) -> Result<NoStop<F>, Error> {
    if ratios.has_higher_static_friction() {
        let static_friction_ratio = ratios.static_friction_ratio().into();
        return Err(Error::StaticFriction { static_friction_ratio });
    }
    Ok(NoStop::of(&ratios))
}

/// The answer at a point, with the forces without a stop if requested, and its record.
pub(crate) fn border_at<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    with_no_stop: bool,
) -> Result<BorderAnswer<F>, Failure> {
    // The border does not depend on the force, here r_y.
    let answer = Response::guarded(point.ratios);
    let found = with_no_stop.then(|| no_stop(point.ratios)).transpose();
    let found = found.map_err(|e| given.at_fault(&e))?;
    let mut record = Cells::of_border(given, &answer);
    record.fields.extend(found.as_ref().map(|found| (NO_STOP_FORCE_RATIOS, Cells::intervals(found))));
    let record = record.in_units(given, point, Physical::of_border)?;
    Ok(((answer, found), record))
}

fn answer_borders<F: Value>(args: &BorderArgs, out: &mut impl Write) -> Outcome {
    let asked = AskedPoints { question: Swept::Border, output: &args.output, start: None };
    asked.answered(
        &args.machine,
        out,
        |given: &Given<F>, point, _| border_at(given, point, args.no_stop),
        |point, (answer, found), given, out| {
            let scales = point.machine.as_ref().map(|machine| &machine.scales);
            note::border(answer, found.as_ref(), Note { given, machine: None, scales, out })
        },
    )
}
