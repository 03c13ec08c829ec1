//! tmp
mod common;
use common::*; use antipode_geometry::*; use antipode_terrain::*; use std::io::Write;
#[test] fn look(){
 for (name,space) in [("flat",flat()),("sphere",sphere())] { for seed in 0..5u64 {
  let f=Field::new(seed,space.clone());
  let mut hs=vec![]; let mut r=Random(3);
  let span = if name=="flat" {400.0} else {30.0};
  for _ in 0..2000 { hs.push(f.surface_height(Hemisphere::A,r.between(-span,span),r.between(-span,span))); }
  hs.sort_by(f64::total_cmp);
  println!("{name} {seed} p5 {:.1} p25 {:.1} p50 {:.1} p75 {:.1} p95 {:.1}",hs[100],hs[500],hs[1000],hs[1500],hs[1900]);
  let mut out=std::fs::File::create(format!("/tmp/mc/{name}{seed}.obj")).unwrap();
  for x in -1..1 { for z in -1..1 { for y in 0..2 { let c=chunk(Hemisphere::A,x,y,z); let m=march(&f.samples(c),&f,c); let o=c.origin();
   for t in m.triangles(){ for n in t { let v=m.vertices[*n as usize]; writeln!(out,"{} {} {} {} {} {} {} {} {}",o.x+v.position[0] as f64,o.y+v.position[1] as f64,o.z+v.position[2] as f64,v.normal[0],v.normal[1],v.normal[2],v.colour[0],v.colour[1],v.colour[2]).unwrap(); } } } } }
 } }
}
