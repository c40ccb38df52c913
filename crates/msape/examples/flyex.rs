use msape::*;
use std::io::Read;
fn main(){
 let mut a:Vec<String>=std::env::args().skip(1).collect();
 let path=a.remove(1); let text=if path=="-" {let mut s=String::new();std::io::stdin().read_to_string(&mut s).unwrap();s}else{std::fs::read_to_string(path).unwrap()};
 let mut case=Case::from_text(&text).unwrap();
 let mut req=Request::Nothing;
 let mut it=a.into_iter().skip(1);
 while let Some(o)=it.next(){ match o.as_str(){ "--trajectory-step"=>req=Request::Uniform(it.next().unwrap().parse().unwrap()), "--set"=>{let kv=it.next().unwrap(); let (k,v)=kv.split_once('=').unwrap(); case.set(k,v);} _=>{} } }
 let lib=Library::builtin().unwrap();
 match (if std::env::args().nth(1).as_deref()==Some("design"){design(&case,&lib,req)}else{fly(&case,&lib,req)}){ Err(e)=>{for x in e{eprintln!("{x}");} std::process::exit(2)},
 Ok(ans)=>{ let mut r=serde_json::Map::new(); for o in msape::quantity::outputs(msape::quantity::Job::Design){ r.insert(o.key.into(), (o.get)(&ans).into()); }
  let mut top=serde_json::Map::new(); top.insert("outcome".into(), ans.outcome.name().into()); top.insert("results".into(), r.into());
  top.insert("evaluations".into(), ans.flight.as_ref().map_or(0,|f|f.evaluations).into());
  if let Some(t)=ans.flight.as_ref().and_then(|f|f.trajectory.as_ref()) { let mut m=serde_json::Map::new(); for (c,v) in msape::quantity::trajectory::columns().iter().zip(&t.values){ m.insert(c.key.into(), serde_json::json!(v)); } top.insert("trajectory".into(), m.into()); }
  if std::env::args().nth(1).as_deref()==Some("design") { if let Some(d)=&ans.design { for c in &d.vehicle.components { eprintln!("{:30} V {:9.5} m3 rho {:7.1} m {:7.3} kg, with margin {:7.3}", c.kind.label(), c.volume_m3, c.density_kg_m3, c.mass_kg, c.mass_with_margin_kg); } eprintln!("mass {:.3} cg/D {:.4} {:#?} {:#?}", d.vehicle.mass.mass_kg, d.vehicle.dimensions.cg_over_diameter, d.vehicle.dimensions, d.vehicle.impact); eprintln!("{:?}\n{:?}\n{:?}", d.vehicle.structure, d.forebody_tps, d.aftbody_tps); eprintln!("T {}", d.payload_temperature_k-273.15); } for p in &ans.passes { eprintln!("{} {} m {:.5} {:?} {:.6?}", p.number, p.flight_model, p.mass_kg, p.mass_change_kg, p.crossings);} for a in &ans.adjustments { eprintln!("ADJ {:?}", a);} for f in &ans.findings { eprintln!("FIND {:?} {} {}: {}", f.severity, f.model, f.key, f.message);} eprintln!("{:?} {:?}", ans.outcome, ans.reason); }
 println!("{}", serde_json::Value::Object(top)); } }
}
