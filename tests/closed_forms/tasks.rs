//! Ten tasks as a user of the library would write them: each in as few lines as a sketch on paper has.

use crate::compared::Origin::ByHand;
use crate::compared::{compared, near};
use std::f64::consts::TAU;
use stickslip::motion::record::{Body, Record};
use stickslip::{Drive, Error, Excitation, Oscillator, Steady, design};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() <= tolerance, "{found} for {expected}");
}

/// 50 t on 1000 kN/m with 5 kN of friction.
fn body() -> Result<Oscillator<f64>, Error> {
    Oscillator::new(50.0, 1000.0, 5.0)?.with_damping_ratio(0.02)
}

/// A machine with units to its displacement and the force on its support.
#[test]
fn one_machine() -> Outcome {
    let body = Oscillator::new(50.0, 1000.0, 5.0)?.with_damping_ratio(0.02)?;
    let drive = Drive::force(12.0, TAU)?;
    let steady = Steady::of(&body, &drive)?;
    let (displacement, force) = in_harmonics(&body, &drive);
    near("fn Steady::of", steady.max_displacement, displacement, ByHand, 1e-6);
    near("fn Steady::of", steady.max_transmitted_force, force, ByHand, 1e-4);
    Ok(())
}

#[test]
fn a_sweep_over_frequency() -> Outcome {
    let (body, drive) = (body()?, Drive::force(12.0, TAU)?);
    let frequencies = [3.5, 4.0, 5.0, 6.0, 7.0, 9.0];
    let peaks: Vec<f64> = frequencies
        .iter()
        .map(|&w| Ok(Steady::of(&body, &drive.at(w)?)?.max_displacement))
        .collect::<Result<_, Error>>()?;
    for (peak, w) in peaks.into_iter().zip(frequencies) {
        near("fn Steady::of", peak, in_harmonics(&body, &drive.at(w)?).0, ByHand, 1e-6);
    }
    Ok(())
}

/// A period of a motion with stops.
#[test]
fn samples_of_a_motion_with_stops() -> Outcome {
    let steady = Steady::of(&body()?, &Drive::force(12.0, 2.0)?)?;
    let mut csv = String::new();
    for s in steady.samples(200)? {
        csv += &format!("{},{},{},{}\n", s.time, s.displacement, s.velocity, s.friction);
    }
    assert_eq!(csv.lines().count(), 200);
    let samples = steady.samples(2000)?;
    let rest = samples.iter().filter(|s| s.velocity == 0.0).count() as f64;
    assert!((rest / 2000.0 - steady.stick_time / steady.period).abs() < 3e-3 && steady.stops > 0);
    // Each sample obeys the equation of motion at its time, and friction its law.
    let damping = body()?.damping();
    for (k, s) in samples.iter().enumerate() {
        assert!((s.time - steady.period * k as f64 / 2000.0).abs() < 1e-12);
        let (restoring, force) =
            (1000.0 * s.displacement + damping * s.velocity, 12.0 * (2.0 * s.time).sin());
        let inertia = force - restoring - s.friction;
        compared("fn Steady::samples", 50.0 * s.acceleration, inertia, ByHand, 1e-9);
        assert!(if s.velocity == 0.0 {
            s.friction.abs() <= 5.0 + 1e-9
        } else {
            s.friction * s.velocity > 0.0
        });
    }
    let most = samples.iter().map(|s| s.displacement).fold(f64::MIN, f64::max);
    close(most, steady.max_displacement, 1e-5);
    Ok(())
}

#[test]
fn the_least_force_with_a_damper() -> Outcome {
    let body = Oscillator::new(50.0, 1000.0, 5.0)?.with_damping_ratio(0.05)?;
    let least = design::min_amplitude(&body, Excitation::Force, TAU)?;
    let stops = |share: f64| Ok::<_, Error>(Steady::of(&body, &Drive::force(least * share, TAU)?)?.stops);
    assert!(stops(0.999)? > 0 && stops(1.001)? == 0);
    Ok(())
}

#[test]
fn a_record_from_csv() -> Outcome {
    let file = tempfile::NamedTempFile::new()?;
    std::fs::write(&file, "time [s],acceleration\n0,0\n0.5,8\n1,-6\n1.5,0\n")?;
    let record = Record::from_csv(Excitation::SurfaceAcceleration, std::fs::File::open(&file)?)?;
    let body = Body::new(1000.0, 600.0)?.with_stiffness(4e4)?;
    let residual = body.follow(&record)?.residual_displacement.ok_or("it moves on")?;
    let same = Record::new(Excitation::SurfaceAcceleration, 0.5, vec![0.0, 8.0, -6.0, 0.0])?;
    close(residual, body.follow(&same)?.residual_displacement.ok_or("it moves on")?, 1e-9);
    let not_text = Record::<f64>::from_csv(Excitation::Force, &b"0,1\n1,\xff\n"[..]).unwrap_err();
    assert!(not_text.to_string().starts_with("record: the text must be readable, but "), "{not_text}");
    Ok(())
}

#[test]
fn the_friction_of_an_isolator() -> Outcome {
    let body = Oscillator::new(800.0, 5053.0, 1.0)?; // friction: to be found
    let drive = Drive::new(Excitation::SurfaceAcceleration, 2.0, 1.0)?;
    let best =
        design::best_friction_over_band(&body, &drive, TAU * 0.5..=TAU * 4.0, design::Aim::Acceleration)?;
    assert!(best.friction > 0.0 && best.greatest < 2.0, "{best:?}");
    let at = |friction: f64, w: f64| {
        let body = Oscillator::new(800.0, 5053.0, friction)?;
        Steady::of(&body, &drive.at(w)?)
    };
    let greatest = |friction: f64| {
        (0..200).map(|k| TAU * (0.5 + 3.5 * f64::from(k) / 199.0)).try_fold(0.0, |most: f64, w| {
            Ok::<_, Error>(most.max(at(friction, w)?.max_transmitted_force / 800.0))
        })
    };
    close(greatest(best.friction)?, best.greatest, 2e-2);
    assert!(greatest(best.friction * 1.3)? > best.greatest && greatest(best.friction * 0.7)? > best.greatest);
    Ok(())
}

#[cfg(feature = "mp")]
#[test]
fn at_256_bits() -> Outcome {
    type N = stickslip::float::Mp<4>;
    let body = Oscillator::new(N::from(50), N::from(1000), N::from(5))?;
    let drive = Drive::force(N::from(12), N::from(2) * N::pi())?;
    let text = format!("{:.60}", Steady::of(&body, &drive)?.max_displacement);
    let double = Steady::of(&Oscillator::new(50.0, 1000.0, 5.0)?, &Drive::force(12.0, TAU)?)?;
    assert_eq!(text.len(), 62);
    close(text.parse()?, double.max_displacement, 4e-16);
    Ok(())
}

#[cfg(feature = "mp")]
#[test]
fn an_enclosure() -> Outcome {
    use stickslip::enclosed::KnownRatios;
    use stickslip::{Output, Ratios, Response};
    let ratios = KnownRatios::parsed("0.695..0.705", "2")?;
    let response = ratios.response(128)?;
    let stroke = response.get(Output::MaxDisplacement).ok_or("undecided")?;
    let (middle, off) = (stroke.mid.to_f64(), stroke.rad.to_f64());
    // It contains what it must. Each formula is evaluated once over the whole interval: 5.47 times as wide as it must be.
    let mut widest: f64 = 0.0;
    for k in 0..=100 {
        let at = Response::new(Ratios::new(0.695 + 1e-4 * f64::from(k), 2.0)?);
        let away = (Output::MaxDisplacement.of(&at).ok_or("it sticks")? - middle).abs();
        assert!(away <= off, "{k}: {away} of {off}");
        widest = widest.max(away);
    }
    assert!(off < 5.5 * widest, "{off} for {widest}");
    Ok(())
}

#[cfg(feature = "dual")]
#[test]
fn sensitivities() -> Outcome {
    use stickslip::Output;
    use stickslip::sensitivity::{Parameter, Sensitivities};
    let s = Sensitivities::by_parameters(&body()?, &Drive::force(12.0, TAU)?)?;
    let by_friction = s.of(Output::MaxDisplacement).ok_or("it sticks")?.by(Parameter::FrictionBound);
    let at = |friction: f64| {
        let body = Oscillator::new(50.0, 1000.0, friction)?.with_damping(body()?.damping())?;
        Ok::<_, Error>(Steady::of(&body, &Drive::force(12.0, TAU)?)?.max_displacement)
    };
    close(by_friction, (at(5.0 + 1e-5)? - at(5.0 - 1e-5)?) / 2e-5, 1e-6);
    Ok(())
}

/// An error type of one's own, and answers that are kept as JSON.
#[cfg(feature = "serde")]
#[test]
fn errors_and_json() -> Outcome {
    use stickslip::{Cycle, Ratios, Response};
    #[derive(thiserror::Error, Debug)]
    enum MyError {
        #[error(transparent)]
        Machine(#[from] Error),
        #[error(transparent)]
        Json(#[from] serde_json::Error),
    }
    let kept = || -> Result<(), MyError> {
        let body = body()?;
        let text = serde_json::to_string(&body)?;
        assert_eq!(serde_json::from_str::<Oscillator<f64>>(&text)?, body);
        match Cycle::new(Ratios::new(0.4, 6.0)?) {
            Err(Error::Sticks { least, .. }) => close(least.to_f64(), 6.949_737_755_908_733, 1e-15),
            other => panic!("{other:?}"),
        }
        let response = Response::new(Ratios::new(0.7, 2.0)?);
        let answer: Response<f64> = serde_json::from_str(&serde_json::to_string(&response)?)?;
        assert_eq!(answer, response);
        Ok(())
    };
    Ok(kept()?)
}

/// The greatest displacement and the greatest force on the support of a motion without stops: by the Fourier series of the
/// load and of friction, a square wave that changes its sign at the turning point.
fn in_harmonics(body: &Oscillator<f64>, drive: &Drive<f64>) -> (f64, f64) {
    let (m, c, k, r) = (body.mass(), body.damping(), body.stiffness(), body.friction_bound());
    let (p, w) = (drive.amplitude(), drive.angular_frequency());
    // 1/(k − m(nω)² + i c nω), and the amplitude of harmonic n of friction.
    let flexibility = |n: f64| {
        let (re, im) = (k - m * (n * w).powi(2), c * n * w);
        let square = re * re + im * im;
        (re / square, -im / square)
    };
    let odd = |count: u32| (0..count).map(|n| f64::from(2 * n + 1));
    let wave = 4.0 * r / std::f64::consts::PI;
    // At the maximum, s = 0, the velocity is 0: this is the phase of the load there.
    let (re, im) = flexibility(1.0);
    let slopes: f64 = odd(500_000).map(|n| flexibility(n).0).sum();
    let angle = (-wave * slopes / (p * re.hypot(im))).acos();
    let at = |angle: f64, s: f64, count| {
        let start = (p * re.hypot(im) * (angle + w * s).sin(), p * re.hypot(im) * w * (angle + w * s).cos());
        odd(count).fold(start, |(x, v), n| {
            let ((re, im), (sin, cos)) = (flexibility(n), (n * w * s).sin_cos());
            let size = wave / n;
            (x + size * (re * sin + im * cos), v + size * n * w * (re * cos - im * sin))
        })
    };
    let peaks = [angle, -angle].map(|angle| {
        let force = (1..2000).map(|j| {
            let (x, v) = at(angle, -f64::from(j) / 2000.0 * std::f64::consts::PI / w, 400);
            (k * x + c * v + r).abs()
        });
        (at(angle, 0.0, 20_000).0, force.fold(0.0, f64::max))
    });
    // Of the two phases the one after which the body turns back.
    if peaks[0].0 > peaks[1].0 { peaks[0] } else { peaks[1] }
}
