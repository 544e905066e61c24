//! The identities of the cycle with damping.

use super::super::followed::apart;
use super::super::motion::count;
use super::{Case, Digits, Identity, points_of_a_half_cycle};
use crate::float::Float;

/// Sum and product of the half-cycle multipliers among the answers.
fn half_cycle<F: Float>(c: &Case<'_, F>) -> (F, F) {
    let [(a, b), (p, q)] = c.answers.multipliers.parts();
    (a + p, a * p - b * q)
}

/// The residual of the equation with this number among eq. 21–25, in units of B.
fn matched<F: Float>(c: &Case<'_, F>, number: usize) -> Option<F> {
    let (residuals, _) = c.system.equations(&c.unknowns);
    residuals.get(number).map(|residual| *residual * c.alpha())
}

macro_rules! identities {
    ($($equation:literal $digits:ident $statement:literal: |$c:ident| $residual:expr),+ $(,)?) => {
        vec![$(Identity {
            equation: $equation,
            statement: $statement,
            digits: Digits::$digits,
            residual: |$c: &Case<'_, F>| $residual,
        }),+]
    };
}

pub(super) fn identities<F: Float>() -> Vec<Identity<F>> {
    [by_matching(), by_motion(), on_the_border()].concat_all()
}

trait ConcatAll<T> {
    fn concat_all(self) -> Vec<T>;
}

impl<T, const N: usize> ConcatAll<T> for [Vec<T>; N] {
    fn concat_all(self) -> Vec<T> {
        self.into_iter().flatten().collect()
    }
}

/// Identities by the matching conditions, with the answers substituted and solved by Newton's method.
fn by_matching<F: Float>() -> Vec<Identity<F>> {
    identities![
        "21, ζ" All "matching with damping: x₁′(t₂) = 0": |c| matched(c, 0),
        "22, ζ" All "matching with damping: x₂′(t₃) = −V₀": |c| matched(c, 1),
        "23, ζ" All "matching with damping: x₁(t₂) = Δ₀": |c| matched(c, 2),
        "24, ζ" All "matching with damping: x₂(t₃) = −Δ₁": |c| matched(c, 3),
        "25, ζ" All "matching with damping: x″(t₁) = 0": |c| matched(c, 4),
        "16, ζ" All "the waveform and its velocity are the matched branch": |c| {
            let turn = F::pi() / F::int(3);
            let (x, v) = c.formulae.motion_at(&c.cycle, c.unknowns.displacement_phase + turn);
            let (at, speed) = c.system.falling(&c.unknowns, turn);
            Some((x - at * c.alpha()).abs() + (v * c.omega() - speed * c.alpha()).abs())
        },
        "21–25, ζ" All "Newton's method with damping: Δ₀, V₀ and Δ₁": |c| {
            let s = c.solved.as_ref()?;
            let (u, alpha) = (&s.unknowns, c.alpha());
            let off = [
                u.max_displacement - c.unknowns.max_displacement * alpha,
                u.max_velocity - c.unknowns.max_velocity * alpha,
                u.deviation - c.unknowns.deviation * alpha,
            ];
            let most = off.into_iter().fold(F::int(0), |most, off| most.or_larger(off.abs()));
            Some(c.in_good_digits(s, most, c.scale))
        },
        "21–25, ζ" All "Newton's method with damping: ω_d t₂ and ω_d t₁": |c| {
            let s = c.solved.as_ref()?;
            let late = apart(s.unknowns.displacement_phase, c.unknowns.displacement_phase).abs();
            let off = late.or_larger(apart(s.unknowns.velocity_phase, c.unknowns.velocity_phase).abs());
            Some(c.in_good_digits(s, off, F::int(1)))
        },
        "25, ζ" All "Newton's method with damping: no instant of its half cycle is faster than V₀": |c| {
            let s = c.solved.as_ref()?;
            let n = points_of_a_half_cycle(c.omega());
            let most = (1..n).fold(F::int(0), |most, i| {
                let (_, w) = c.system.falling(&c.unknowns, F::pi() * F::ratio(i, n));
                most.or_larger(-w * c.alpha() - c.answers.max_velocity * c.omega())
            });
            Some(c.in_good_digits(s, most, c.scale))
        },
    ]
}

/// Identities by the exact motion from rest.
fn by_motion<F: Float>() -> Vec<Identity<F>> {
    identities![
        "44, ζ" All "with damping Δ₀ is that of the exact motion": |c| {
            let m = c.motion.as_ref()?;
            Some(c.within(m.steady.max_displacement.value - c.answers.max_displacement, c.scale, m.doubt))
        },
        "43, ζ" All "with damping ω_d t₂ is that of the exact motion": |c| {
            let m = c.motion.as_ref()?;
            let phase = apart(m.steady.max_displacement.phase.reduced(), c.answers.displacement_phase);
            let acceleration = c.omega().square() * m.steady.max_displacement.value + F::int(1);
            Some(c.within(phase * acceleration / c.omega(), c.scale * (F::int(1) + F::int(1) / c.omega()), m.doubt))
        },
        "49, ζ" All "with damping V₀ is the greatest velocity of the exact motion": |c| {
            let m = c.motion.as_ref()?;
            let velocity = (m.steady.max_velocity.value - c.answers.max_velocity) * c.omega();
            Some(c.within(velocity, c.scale * (c.omega() + F::int(1)), m.doubt))
        },
        "62, ζ" All "with damping the exact motion has two reversals a cycle and no stop": |c| {
            let s = &c.motion.as_ref()?.steady;
            Some((count::<F>(s.sticks_per_cycle, 0) + count(s.velocity_zeros_per_cycle, 2)) * c.scale)
        },
        "64, ζ" All "with damping A₁ is the work against friction": |c| {
            let m = c.motion.as_ref()?;
            let work = c.answers.loop_size_stiffness * c.alpha().square() / F::int(2);
            Some(c.within((m.steady.energy_out - work) / F::int(4), c.scale, m.doubt))
        },
        "67, ζ" All "with damping A₂ is Ω² times that work": |c| {
            let m = c.motion.as_ref()?;
            let work = c.answers.loop_size_inertia * (c.alpha() / c.omega()).square() / F::int(2);
            Some(c.within((m.steady.energy_out - work) / F::int(4), c.scale, m.doubt))
        },
        "ζ" All "the work of the damper is that of the exact motion": |c| {
            let m = c.motion.as_ref()?;
            let terms = (c.alpha() + c.scale) * c.scale * (F::int(1) + F::int(1) / c.omega());
            Some(c.within(m.steady.damper_work - c.answers.damper_work, terms, terms * m.doubt / c.scale))
        },
        "λ, ζ" All "with damping λ₁² + λ₂² and λ₁²λ₂² are those of the exact motion's linearised cycle": |c| {
            let m = c.motion.as_ref()?;
            let [(a, b), (p, q)] = m.steady.multipliers;
            let (trace, product) = (a + p, a * p - b * q);
            let (sum, determinant) = half_cycle(c);
            let off =
                (sum.square() - F::int(2) * determinant - trace).abs() + (determinant.square() - product).abs();
            Some(c.within(off, F::int(1) + F::int(1) / c.omega(), m.doubt))
        },
        "λ, ζ" Half "with damping λ₁ + λ₂ and λ₁λ₂ are those of the exact half cycle by differences": |c| {
            let ((trace, product), (sum, determinant)) = (c.motion.as_ref()?.half_map?, half_cycle(c));
            Some(((trace - sum).abs() + (product - determinant).abs()) * c.scale)
        },
        "λ, ζ" All "with damping the contraction is the larger |λ|": |c| {
            let m = c.motion.as_ref()?;
            let [(a, b), (p, q)] = c.answers.multipliers.parts();
            let listed = a.hypot(b).or_larger(p.hypot(q));
            let found = c.answers.contraction;
            // A double root keeps half of the digits.
            let off = (found - listed).abs().or_larger((found.square() - m.steady.contraction()).square());
            Some(c.within(off, F::int(1) + F::int(1) / c.omega(), m.doubt))
        },
    ]
}

/// Identities on the border, by Newton's method and by the exact motion on either side.
fn on_the_border<F: Float>() -> Vec<Identity<F>> {
    identities![
        "62, ζ" All "Newton's method on the damped border: at τ* velocity and acceleration are zero": |c| {
            let b = c.border.as_ref()?;
            let (alpha, u) = (b.edge.min_force_ratio, b.unknowns());
            let (x, w) = b.system.falling(&u, b.edge.phase);
            let sine = (u.displacement_phase + b.edge.phase).sin();
            let damping = F::int(2) * c.cycle.ratios.damping_ratio();
            let acceleration = (sine - x - damping * w) * alpha + F::int(1);
            Some(c.in_good_digits(&b.solved, acceleration.abs() + w.abs() * alpha, c.scale))
        },
        "62, ζ" All "Newton's method on the damped border: nowhere does the body go back": |c| {
            let b = c.border.as_ref()?;
            let (u, n) = (b.unknowns(), points_of_a_half_cycle(c.omega()));
            let most = (1..n).fold(F::int(0), |most, i| {
                most.or_larger(b.system.falling(&u, F::pi() * F::ratio(i, n)).1)
            });
            Some(c.in_good_digits(&b.solved, most * b.edge.min_force_ratio, c.scale))
        },
        "62, ζ" All "Newton's method on the damped border: Δ₀/B is S − G": |c| {
            let b = c.border.as_ref()?;
            Some(c.in_good_digits(&b.solved, b.solved.unknowns.max_displacement - b.edge.least_displacement, c.scale))
        },
        "62, ζ" All "with damping the exact motion stops just below the border, and not above": |c| {
            let (below, above) = c.border.as_ref()?.stops?;
            Some(if below > 0 && above == 0 { F::int(0) } else { c.scale })
        },
        "65, ζ" Half "with damping A₁ of the exact motion is stationary at α*, by differences": |c| {
            Some(c.border.as_ref()?.best?.1 * c.scale)
        },
        "66, ζ" All "with damping A₁ of the exact motion at α* is A₁max": |c| {
            let (_, most) = c.formulae.best(&c.cycle.ratios);
            Some((c.border.as_ref()?.best?.0 / most - F::int(1)) * c.scale)
        },
    ]
}

impl<F: Float> super::OnBorder<F> {
    /// The solution in the length unit of the system.
    fn unknowns(&self) -> crate::nonsticking::matching::Unknowns<F> {
        let (u, alpha) = (&self.solved.unknowns, self.edge.min_force_ratio);
        crate::nonsticking::matching::Unknowns {
            max_velocity: u.max_velocity / alpha,
            max_displacement: u.max_displacement / alpha,
            deviation: u.deviation / alpha,
            ..*u
        }
    }
}
