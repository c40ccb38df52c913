use ablation::{environment::*, gas::*, grid::*, march::*, reaction::*, solid::*, stack::*, surface::*, wall::*, contact::*, geometry::*};
use std::time::Instant;
fn csv(f:&str)->Vec<Vec<f64>>{ std::fs::read_to_string(format!("/work/shared/reference/tps/{f}")).unwrap().lines().filter_map(|l| l.split(',').map(|x| x.trim().parse().ok()).collect::<Option<Vec<f64>>>()).collect() }
fn state(f:&str,rho:f64,h:f64,e:f64)->State{ let rows:Vec<_>=csv(f).into_iter().filter(|r| r[0]==1.0).collect(); State{density_kg_m3:rho,formation_j_kg:h,specific_heat:rows.iter().map(|r|[r[1],r[2]]).collect(),conductivity:rows.iter().map(|r|[r[1],r[4]]).collect(),emissivity:e,absorptivity:e}}
fn main(){
 let a:Vec<String>=std::env::args().collect();
 let case=a[1].as_str(); let cells:usize=a.get(2).map_or(64,|x|x.parse().unwrap()); let tol:f64=a.get(3).map_or(0.1,|x|x.parse().unwrap()); let stretch:f64=a.get(4).map_or(12.0,|x|x.parse().unwrap());
 let solid=Solid::try_new(state("tacot_virgin.csv",280.,-857142.857,0.8),state("tacot_char.csv",220.,0.,0.9)).unwrap();
 let gas=Gas::try_new(csv("tacot_gas.csv").iter().map(|r|GasRow{pressure_pa:r[0],temperature_k:r[1],molar_mass_kg_mol:r[2],enthalpy_j_kg:r[3],viscosity_pa_s:r[4]}).collect()).unwrap();
 let table=WallTable::try_new(csv("bprime_tacot_air.csv").iter().map(|r|WallRow{pressure_pa:r[0],gas_rate:r[1],char_rate:r[2],temperature_k:r[3],enthalpy_j_kg:r[4]}).collect()).unwrap();
 let reactions=vec![Reaction::of_component([30.,0.],1.2e4,8555.5556,3.,333.3333),Reaction::of_component([90.,60.],4.48e9,20444.4444,3.,555.5556)];
 let m=Material::try_new("TACOT".into(),solid,Some(Pyrolysis{reactions,gas,permeability_m2:[1.6e-11,2e-11]}),Surface::Reacting(table)).unwrap();
 let stack=Stack::try_new(vec![Layer{material:m,thickness_m:0.05,joint:Joint::Perfect}],Geometry::Planar,Back::Adiabatic).unwrap();
 let env= if case=="1.0" { Environment::held(&[(0.,300.),(0.1,1644.),(60.,1644.),(60.1,300.),(120.,300.)].map(|(t,k)|(t,Held{temperature_k:k,pressure_pa:101325.,recession_m_s:0.}))).unwrap()} else {
  Environment::heated(&[(0.,0.003,0.,true),(0.1,0.3,1.5e6,true),(60.,0.3,1.5e6,true),(60.1,0.003,0.,false),(120.,0.003,0.,false)].map(|(t,c,h,on)|(t,Heating{pressure_pa:101325.,transfer_kg_m2s:c,recovery_j_kg:h,radiative_w_m2:0.,chemistry:on}))).unwrap()};
 let s=Settings{initial_temperature_k: 300.0,wall:WallSettings{blowing:0.5,recession:case=="2.2",sink_temperature_k:300.},until:Until::Time(120.),output_step_s:Some(if case=="1.0"{1.0}else{0.1}),depths_m:vec![0.001,0.002,0.004,0.008,0.012,0.016,0.024,0.05],resolution:Resolution{cells,stretch,cells_behind:8},tolerance_k:tol,most_steps:200000};
 let mut s1=s.clone(); s1.output_step_s=a.get(5).map(|x|x.parse().unwrap());
 let t0=Instant::now(); let r1=Run::try_new(&stack,&env,&s1).unwrap().response(|_| core::ops::ControlFlow::Continue(())); println!("no output: {:?} {:?} {:?}",t0.elapsed(),r1.outcome,r1.account);
 let r=Run::try_new(&stack,&env,&s).unwrap().response(|_| core::ops::ControlFlow::Continue(()));
 println!("{:?} end {} E {:e} M {:e} steps {} back {} corr {}",r.outcome,r.end_s,r.account.energy_imbalance(),r.account.mass_imbalance(),r.account.steps,r.account.taken_back,r.account.corrections);
 let (f,cols):(&str,Vec<usize>)= match case {"1.0"=>("aw_case_1_0_fiat_T.csv",vec![0,1,2,3,5]),"2.1"=>("aw_case_2_1_amaryllis_T.csv",(0..8).collect()),_=>("aw_case_2_2_amaryllis_T.csv",(0..8).collect())};
 let rf=csv(f);
 for (lo,hi) in [(0.0,1.0),(1.0,4.0),(4.0,10.),(10.,30.),(30.,60.05),(60.05,120.)] { let mut w=vec![0f64;cols.len()+1];
  for row in &rf { if row[0]<=lo||row[0]>hi {continue;} let Some(x)=r.history.rows.iter().find(|x|(x.time_s-row[0]).abs()<1e-6) else {continue}; 
   w[0]= if (x.wall_k-row[1]).abs()>w[0].abs(){x.wall_k-row[1]}else{w[0]};
   for (k,c) in cols.iter().enumerate(){ let v=row[2+k]; if v>0.0 && x.depths_k[*c]>0.0 { let d=x.depths_k[*c]-v; if d.abs()>w[k+1].abs(){w[k+1]=d;} } } }
  println!("{lo}-{hi}: {}",w.iter().map(|x|format!("{x:7.2}")).collect::<Vec<_>>().join(" ")); }
 if case!="1.0" { let mf=csv(if case=="2.1"{"aw_case_2_1_amaryllis_mass.csv"}else{"aw_case_2_2_amaryllis_mass.csv"});
  for t in [1.,5.,10.,20.,30.,50.,60.,80.,100.,120.]{ let x=r.history.rows.iter().find(|x|(x.time_s-t).abs()<1e-6).unwrap(); let row=mf.iter().find(|r|(r[0]-t).abs()<1e-6).unwrap(); println!("{t} mg {:.6} {:.6} ({:+.2}%) mc {:.6} {:.6} s {:.7} {:.7} p {}",x.gas_kg_m2s,row[1],100.*(x.gas_kg_m2s/row[1]-1.),x.char_kg_m2s,row[2],x.recession_m,row[5],x.pressure_pa); } }
}
