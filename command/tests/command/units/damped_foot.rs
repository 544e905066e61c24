//! A moving support that carries spring and damper, compared with small time steps.

use super::{close, number};
use crate::command_line::{json, refused, stdout};
use std::f64::consts::TAU;

/// With the damper on the support, too, the force is √(k² + c²ω_d²) u₀, ahead of the support by atan(c ω_d/k); small
/// time steps with the support's own place and velocity give the same motion.
#[test]
fn a_foot_of_spring_and_damper_acts_by_both() {
    let (mass, stiffness, damping, friction, frequency, foot) = (2.0, 8.0, 3.0, 4.0, 4.0, 1.5);
    let machine = format!(
        "--mass {mass} --stiffness {stiffness} --friction {friction} --damping {damping} --frequency {frequency}"
    );
    let answer = json(&format!("response {machine} --damped-foot-displacement {foot} --format json"));
    let physical = &answer["physical"];
    let of = |name: &str| number(&physical[name]);
    close(of("force_amplitude"), 208f64.sqrt() * foot, 1e-14);
    close(of("lead_time"), 1.5f64.atan() / frequency, 1e-14);
    assert_eq!(of("damped_foot_displacement"), foot);
    let dt = TAU / frequency / 20_000.0;
    let (mut x, mut v, mut most, mut acceleration, mut when) = (0.0f64, 0.0, 0.0, 0.0f64, 0.0);
    let (mut heat, mut rubbed) = (0.0, 0.0);
    for step in 0..400_000 {
        let theta = frequency * dt * f64::from(step);
        let (place, speed) = (foot * theta.sin(), foot * frequency * theta.cos());
        let free = v + dt * (stiffness * (place - x) + damping * (speed - v)) / mass;
        let lost = friction * dt / mass;
        let after = free - free.clamp(-lost, lost);
        if step >= 380_000 {
            acceleration = acceleration.max(((after - v) / dt).abs());
            // The velocity between body and support in the middle of the step.
            let relative = (v + after) / 2.0 - speed;
            heat += damping * relative * relative * dt;
            rubbed += friction * (v + after).abs() / 2.0 * dt;
            if x > most {
                (most, when) = (x, theta % TAU);
            }
        }
        v = after;
        x += dt * v;
    }
    close(of("max_displacement"), most, 1e-3);
    close(of("max_acceleration"), acceleration, 1e-3);
    close(number(&answer["transmissibility"]), acceleration / (foot * frequency * frequency), 1e-3);
    close(of("displacement_time") - of("lead_time"), when / frequency, 1e-2);
    let steady = json(&format!("steady {machine} --damped-foot-displacement {foot} --format json"));
    // The damper's heat is that of the velocity between body and support, and the support does the work of both.
    for answer in [&answer, &steady] {
        close(number(&answer["physical"]["damper_energy_per_cycle"]), heat, 1e-3);
        close(number(&answer["damper_work"]) * friction * friction / stiffness, heat, 1e-3);
    }
    close(number(&steady["physical"]["energy_out"]), rubbed, 1e-3);
    close(number(&steady["physical"]["energy_in"]), heat + rubbed, 1e-3);
    close(number(&steady["transmissibility"]), number(&answer["transmissibility"]), 1e-12);
    assert!(
        stdout(&format!("response {machine} --damped-foot-displacement {foot}"))
            .contains("support of spring and damper")
    );
    refused(
        &format!("response {machine} --damped-foot-displacement 1 --foot-displacement 1"),
        &["--foot-displacement and --damped-foot-displacement"],
    );
}
