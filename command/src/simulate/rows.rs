//! The columns of a motion's segments and samples, which every drive has alike.

use crate::outputs::{
    DURATION, ENDS_BY, FRICTION, KIND, Key, R, START_CYCLE, START_PHASE, START_V, START_X, key,
};
use crate::physical::Physical;
use crate::row::Cell;
use stickslip_front::inputs::units::{Kind, System};

/// The whole cycles of the drive, and its phase within the next.
pub(super) type When<F> = (Cell<F>, Cell<F>);

/// The columns of a segment in ratios: its duration, and the displacement and the velocity at its start and the displacement at its end.
pub(super) fn segment<F>(
    kind: &'static str,
    ends_by: &'static str,
    [(start_cycle, start_phase), (end_cycle, end_phase)]: [When<F>; 2],
    [duration, x, v, end_x]: [Option<F>; 4],
) -> Vec<(Key, Cell<F>)> {
    vec![
        (KIND, Cell::Text(kind)),
        (ENDS_BY, Cell::Text(ends_by)),
        (START_CYCLE, start_cycle),
        (START_PHASE, start_phase),
        (key!("end_cycle"), end_cycle),
        (key!("end_phase"), end_phase),
        (DURATION, Cell::Number(duration)),
        (START_X, Cell::Number(x)),
        (START_V, Cell::Number(v)),
        (key!("end_x"), Cell::Number(end_x)),
    ]
}

/// The columns of a segment in units: its times, the displacement and the velocity at its start, and the displacement at its end.
pub(super) fn segment_in_units<F>(
    system: System,
    [start, end]: [Option<F>; 2],
    [x, v, end_x]: [Option<F>; 3],
) -> Physical<F> {
    Physical::beside(
        system,
        vec![
            ("start_time", Kind::Time, Cell::Number(start)),
            ("end_time", Kind::Time, Cell::Number(end)),
            ("start_displacement", Kind::Length, Cell::Number(x)),
            ("start_velocity", Kind::Velocity, Cell::Number(v)),
            ("end_displacement", Kind::Length, Cell::Number(end_x)),
        ],
    )
}

/// The columns of a sample in ratios.
pub(super) fn sample<F>((cycle, phase): When<F>, [x, v, friction, r]: [Option<F>; 4]) -> Vec<(Key, Cell<F>)> {
    vec![
        (key!("cycle"), cycle),
        (key!("phase"), phase),
        (key!("x"), Cell::Number(x)),
        (key!("v"), Cell::Number(v)),
        (FRICTION, Cell::Number(friction)),
        (R, Cell::Number(r)),
    ]
}

/// The columns of a sample in units. A body without a mass has no friction force.
pub(super) fn sample_in_units<F>(
    system: System,
    [time, displacement, velocity, acceleration]: [F; 4],
    friction_force: Option<F>,
) -> Physical<F> {
    let number = |x: F| Cell::Number(Some(x));
    let mut values = vec![
        ("time", Kind::Time, number(time)),
        ("displacement", Kind::Length, number(displacement)),
        ("velocity", Kind::Velocity, number(velocity)),
        ("acceleration", Kind::Acceleration, number(acceleration)),
    ];
    values.extend(friction_force.map(|force| ("friction_force", Kind::Force, number(force))));
    Physical::beside(system, values)
}
