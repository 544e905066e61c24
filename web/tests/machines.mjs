// Random machines, the same in every run: ratios, and bodies in SI under each kind of drive, with dampers and static friction
// or without.

// A number in [0, 1) by its place (SplitMix, 32 bits).
export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let z = state;
    z = Math.imul(z ^ (z >>> 16), 0x85ebca6b);
    z = Math.imul(z ^ (z >>> 13), 0xc2b2ae35);
    return ((z ^ (z >>> 16)) >>> 0) / 4294967296;
  };
}

export function machines(count) {
  const next = random(41);
  const between = (low, high) => Number((low * (high / low) ** next()).toPrecision(12));
  const dampers = () => (next() < 0.3 ? 0 : between(1e-4, 3));
  const ratio = () => (next() < 0.7 ? 1 : Number((1 + next()).toPrecision(10)));
  const drives = ["force", "base_acceleration", "base_velocity", "base_displacement", "foot_displacement", "unbalance", "damped_foot_displacement"];
  const kinds = [{ columns: ["omega", "alpha", "damping_ratio", "static_friction_ratio"], row: () => [between(0.06, 8), between(0.5, 30), dampers(), ratio()] }];
  for (const drive of drives) {
    kinds.push({
      columns: ["mass", "stiffness", "friction", "damping_ratio", "static_friction_ratio", drive, "frequency"],
      row: () => {
        const [mass, stiffness, friction] = [between(1e-2, 1e5), between(10, 1e8), between(0.1, 1e4)];
        const omega = between(0.06, 8);
        const frequency = Number((omega * Math.sqrt(stiffness / mass)).toPrecision(14));
        const zeta = dampers();
        const p0 = friction * between(0.5, 30);
        const amplitude = {
          force: p0, base_acceleration: p0 / mass, base_velocity: p0 / mass / frequency, base_displacement: p0 / mass / frequency ** 2,
          foot_displacement: p0 / stiffness, unbalance: p0 / frequency ** 2,
          damped_foot_displacement: p0 / stiffness / Math.hypot(1, 2 * zeta * omega),
        }[drive];
        return [mass, stiffness, friction, zeta, ratio(), Number(amplitude.toPrecision(14)), frequency];
      },
    });
  }
  const each = Math.ceil(count / kinds.length);
  return kinds.map(({ columns, row }) => ({ columns, rows: Array.from({ length: each }, row) }));
}
