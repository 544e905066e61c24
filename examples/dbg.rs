use stickslip::*; use stickslip::float::mp::Mp;
fn main(){
 let w=f64::from_bits(0x3ff0040287762753); let a=f64::from_bits(0x3ff461be75e93007);
 let c=Cycle::new(Ratios::new(w,a).unwrap()).unwrap();
 let m=Cycle::new(Ratios::new(Mp::<4>::from(w),Mp::from(a)).unwrap()).unwrap();
 println!("V {} {}",c.max_velocity(),m.max_velocity());
 println!("D {} {}",c.max_displacement(),m.max_displacement());
 println!("t1 {} {}",c.velocity_phase(),m.velocity_phase());
 println!("t2 {} {}",c.displacement_phase(),m.displacement_phase());
 println!("d1 {:e} {:e}",c.deviation(),m.deviation());
}
